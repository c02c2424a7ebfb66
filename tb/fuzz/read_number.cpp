// SPDX-License-Identifier: Apache-2.0
// The number reader: what it takes, the C library takes whole and reads as the same number.
#include "tb/read_number.h"

#include <cmath>
#include <cstdlib>
#include <string>

#include "tb/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blysk;
  const std::string text(fuzz::text_of(data, size));
  const auto real = read_real(text);
  if (real) {
    char* end = nullptr;
    const double expected = std::strtod(text.c_str(), &end);
    fuzz::expect(end == text.c_str() + text.size(), "strtod stops before the end");
    fuzz::expect(*real == expected || (std::isnan(*real) && std::isnan(expected)),
                 "strtod reads another number");
  }
  if (const auto integer = read_integer(text)) {
    fuzz::expect(real.has_value(), "an integer is no real number");
    fuzz::expect(static_cast<double>(*integer) == *real, "an integer is another real number");
  }
  return 0;
}
