// SPDX-License-Identifier: Apache-2.0
#include <boost/multiprecision/cpp_dec_float.hpp>

#include "rtl_sysc/formats.h"
#include "tb/catch.h"
#include "tb/device.h"
#include "tb/golden/coefficient.h"

namespace {

using namespace blysk;
using real50 = boost::multiprecision::cpp_dec_float_50;

/// x * 2^bits rounded to nearest.
std::int64_t rounded(const real50& x, int bits) {
  return static_cast<std::int64_t>(floor(ldexp(x, bits) + real50(1) / 2));
}

TEST_CASE("the wired constants are the lines' slopes, rounded", "[unit][formats]") {
  for (int bits = 1; bits <= 20; ++bits) {
    CAPTURE(bits);
    CHECK(published_line(bits).slope == rounded(real50(786) / 1000, bits));
    CHECK(derived_line(bits).slope == rounded(golden::coefficient_slope<real50>(), bits));
  }
  CHECK(published_line(8).slope == 0b11001001);  // what [P] means by bits 1, 2, 5, (8)
  CHECK(published_line(8).offset == 1);
  CHECK(derived_line(8).offset == -1);
}

TEST_CASE("constant bits are wired from the point downwards", "[unit][formats]") {
  device_options options;
  options.format = "q10";
  options.coefficient = "published";
  options.constant = "110010";
  CHECK(wire_constants(options).slope == 0b1100100000);
  options.constant = "110011";
  CHECK(wire_constants(options).slope == 0b1100110000);
  for (const char* wrong : {"0110", "11a1", "11111111111", "-1", "1.1"}) {
    options.constant = wrong;
    CAPTURE(wrong);
    CHECK_THROWS_AS(wire_constants(options), std::invalid_argument);
  }
}

TEST_CASE("no net of any format overflows", "[unit][formats]") {
  for (const auto name : format_names) {
    for (const bool as_published : {false, true}) {
      device_options options;
      options.format = name;
      options.as_published = as_published;
      // The assertions are static: that this compiles is the test.
      CHECK(visit_formats(options,
                          []<class Q, lobe Lobe>() { return quadratic_formats<Q, Lobe>::no_overflow(); }));
    }
  }
}

}  // namespace
