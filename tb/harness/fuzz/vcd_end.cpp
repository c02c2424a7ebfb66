// SPDX-License-Identifier: Apache-2.0
// The check that a VCD file has its end: the first two bytes are the time that it should reach, in half clock periods, the
// rest is the file.
#include "tb/fuzz/fuzz.h"
#include "tb/harness/systemc_engine.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blysk;
  if (size < 2) return 0;
  const double now_ps = (data[0] | data[1] << 8) * harness::kClockPeriodNs * 1e3 / 2;
  const std::string_view text = fuzz::text_of(data + 2, size - 2);
  const fuzz::memory_file file(text);
  const bool is_whole = harness::ends_at(file.path(), now_ps);
  fuzz::expect(!is_whole || text.ends_with('\n'), "a file that ends within a line is taken for whole");
  fuzz::expect(!is_whole || text.find('#') != std::string_view::npos || now_ps <= 1,
               "a file without times is taken for whole");
  return 0;
}
