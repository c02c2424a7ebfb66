// SPDX-License-Identifier: Apache-2.0
// The wires of nodes 31 and 32.
#include <boost/multiprecision/cpp_dec_float.hpp>

#include "tb/catch.h"
#include "tb/devices/quadratic/wires.h"
#include "tb/golden/coefficient.h"
#include "tb/visit_format.h"

namespace {

using namespace blysk;
using real50 = boost::multiprecision::cpp_dec_float_50;

/// x * 2^bits rounded to nearest.
std::int64_t rounded(const real50& x, int bits) {
  return static_cast<std::int64_t>(floor(ldexp(x, bits) + real50(1) / 2));
}

selection with_constant(const std::string& bits) {
  return choose("quadratic", "q10", {{"coefficient", "published"}, {"constant", bits}});
}

}  // namespace

TEST_CASE("the wired constants are the lines' slopes, rounded", "[formats]") {
  for (int bits = 1; bits <= 20; ++bits) {
    CAPTURE(bits);
    CHECK(published_line(bits).slope == rounded(real50(786) / 1000, bits));
    CHECK(derived_line(bits).slope == rounded(golden::coefficient_slope<real50>(), bits));
  }
  CHECK(published_line(8).slope == 0b11001001);  // what [P] means by bits 1, 2, 5, (8)
  CHECK(published_line(8).offset == 1);
  CHECK(derived_line(8).offset == -1);
}

TEST_CASE("constant bits are wired from the point downwards", "[formats]") {
  CHECK(quadratic_device::wires(with_constant("110010")).slope == 0b1100100000);
  CHECK(quadratic_device::wires(with_constant("110011")).slope == 0b1100110000);
  CHECK(quadratic_device::wires(with_constant("110011")).offset == 1);
  CHECK(quadratic_device::wires(with_constant("1")).slope == 0b1000000000);
  CHECK(quadratic_device::wires(with_constant("1111111111")).slope == 0b1111111111);
  for (const char* wrong : {"0110", "11a1", "11111111111", "-1", "1.1", "0"}) {
    CAPTURE(wrong);
    CHECK_THROWS_WITH(
        with_constant(wrong),
        std::string("constant ") + wrong +
            " cannot be wired at node 31, expected 1 to 10 bits of 0 and 1, the first of them 1");
  }
}

TEST_CASE("the options in words", "[formats]") {
  CHECK(choose("quadratic", "q8").text() ==
        "device quadratic, format q8, coefficient derived, BRDF clamped to [0, 1]");
  CHECK(choose("quadratic", "q8", {{"constant", "101"}, {"as-published", "on"}}).text() ==
        "device quadratic, format q8, coefficient derived, constant 0.101b, BRDF as published");
}

TEST_CASE("no net of any format overflows", "[formats]") {
  // The assertions are static: that this compiles is the test.
  for (const auto name : format_names) {
    CHECK(visit_format(std::string(name), []<class Q>() {
      return quadratic_formats<Q, negative_lobe::clamped>::no_overflow() &&
             quadratic_formats<Q, negative_lobe::as_published>::no_overflow();
    }));
  }
}
