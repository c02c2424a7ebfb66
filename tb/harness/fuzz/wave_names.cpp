// SPDX-License-Identifier: Apache-2.0
// Whether a layout fits a waveform: the text up to the first byte 0 is the VCD file, what follows it the layout. A row that
// is counted has a declared name in it, and each declared name makes a row that is counted.
#include "tb/harness/wave_names.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "tb/fuzz/fuzz.h"
#include "tb/usage_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blysk;
  const std::string_view text = fuzz::text_of(data, size);
  const std::size_t end = std::min(text.find('\0'), text.size());
  const fuzz::memory_file vcd(text.substr(0, end));
  const fuzz::memory_file layout(end == text.size() ? std::string_view() : text.substr(end + 1));
  try {
    const auto signals = harness::declared_signals(vcd.path());
    const harness::row_count rows = harness::rows_of(layout.path(), signals);
    fuzz::expect(rows.shown == 0 || !signals.empty(), "a row shows a signal of no waveform");
    for (const std::string& name : signals) {
      fuzz::expect(text.substr(0, end).find("$var") != std::string_view::npos,
                   "a signal is declared nowhere");
      // A name that ends like a range, or begins like an alias, is no row of its own.
      if (name.ends_with(']') || name.starts_with("+{") || name.ends_with('\r')) continue;
      const fuzz::memory_file row("+{an alias} " + name + "[7:0]\n");
      fuzz::expect(harness::rows_of(row.path(), signals).shown == 1,
                   "the row of a declared signal is not counted");
    }
  } catch (const usage_error& error) {
    fuzz::expect_message(error.what());
  }
  return 0;
}
