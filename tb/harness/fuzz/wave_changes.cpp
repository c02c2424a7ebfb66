// SPDX-License-Identifier: Apache-2.0
// A waveform whose values are read: it is refused in one printable line, or has a value for its clock at any time, or none.
#include "tb/harness/wave_changes.h"

#include <limits>
#include <stdexcept>

#include "tb/fuzz/fuzz.h"
#include "tb/usage_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blysk;
  const fuzz::memory_file vcd(fuzz::text_of(data, size));
  try {
    const harness::wave_changes waves(vcd.path());
    try {
      const std::string& last = waves.at("SystemC.clk", std::numeric_limits<std::uint64_t>::max());
      fuzz::expect(fuzz::text_of(data, size).find(last) != std::string_view::npos,
                   "a value that nothing wrote");
    } catch (const std::invalid_argument&) {  // it has no clock
    }
  } catch (const usage_error& error) {
    fuzz::expect_message(error.what());
  }
  return 0;
}
