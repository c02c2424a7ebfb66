// SPDX-License-Identifier: Apache-2.0
// The arc-cosine unit against the arc cosine.
#include <algorithm>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <cmath>

#include "rtl_sysc/devices/arccos/formats.h"
#include "tb/catch.h"
#include "tb/device.h"
#include "tb/harness/systemc_engine.h"
#include "tb/visit_format.h"

namespace {

using namespace blysk;
using real50 = boost::multiprecision::cpp_dec_float_50;

/// Every code of the cosine through the bit-accurate model.
columns all_angles(const selection& asked) {
  columns in(asked.of().ports(asked), port::role::data);
  columns out;
  const std::size_t codes = (std::size_t{1} << asked.fraction()) + 1;
  in.resize(codes);
  for (std::size_t code = 0; code < codes; ++code) in[0].set(code, code);
  asked.of().make_bit(asked)->run(in, out);
  return out;
}

/// arccos(1 - v) / sqrt v with 50 digits, sqrt 2 in the limit.
std::int64_t exact_word(std::uint64_t place, int segment_bits, int bits) {
  const real50 v = ldexp(real50(place), -segment_bits);
  const real50 ratio = place == 0 ? real50(sqrt(real50(2))) : real50(acos(real50(1 - v)) / sqrt(v));
  return static_cast<std::int64_t>(floor(ldexp(ratio, bits) + real50(1) / 2));
}

}  // namespace

TEST_CASE("the words are the ratio of the arc cosine to the root, rounded", "[arccos]") {
  for (const char* format : {"q8", "q16", "q20"}) {
    visit_format(format, []<class Q>() {
      using formats = arccos_formats<Q>;
      const auto& values = formats::contents::values;
      for (std::size_t i = 0; i < values.size(); ++i) {
        CAPTURE(formats::segment_bits, i);
        REQUIRE(values[i] == exact_word(i, formats::segment_bits, formats::root_bits));
      }
    });
  }
}

TEST_CASE("every angle is less than an ulp from the arc cosine", "[arccos]") {
  for (const char* format : {"q8", "q10", "q12", "q14", "q16", "q18", "q20"}) {
    const selection asked = choose("arccos", format);
    const columns angles = all_angles(asked);
    double largest = 0;
    std::int64_t before = std::int64_t{1} << 62;
    bool falls = true;
    for (std::size_t code = 0; code < angles.size(); ++code) {
      const double exact = std::acos(std::ldexp(static_cast<double>(code), -asked.fraction()));
      const std::int64_t angle = angles[0].get(code);
      largest =
          std::max(largest, std::abs(static_cast<double>(angle) - std::ldexp(exact, asked.fraction() + 2)));
      falls = falls && angle < before;
      before = angle;
    }
    WARN(format << ": " << angles.size() << " cosines, largest error " << largest << " ulp");
    CHECK(largest < 0.92);  // the bound: 1/2 + 0.089 + 0.197 + 0.125
    CHECK(largest > 0.6);   // and it is no bound of something else
    CHECK(falls);
    CHECK(angles[0].get(angles.size() - 1) == 0);
  }
}

TEST_CASE("named angles", "[arccos]") {
  const selection asked = choose("arccos", "q12");
  const columns angles = all_angles(asked);
  CHECK(angles[0].get(4096) == 0);
  CHECK(angles[0].get(4095) == 362);    // sqrt(2 2^-12) 2^14 = 362.04
  CHECK(angles[0].get(2048) == 17157);  // pi/3 2^14 = 17157.3
  CHECK(angles[0].get(0) == 25736);     // pi/2 2^14 = 25735.9
}

TEST_CASE("an angle takes a cycle for each digit of the root and one more", "[arccos]") {
  const selection asked = choose("arccos", "q8");
  const auto device = harness::make_systemc(asked);
  columns in(asked.of().ports(asked), port::role::data);
  columns out;
  in.resize(200);
  for (std::size_t i = 0; i < in.size(); ++i) in[0].set(i, i);
  device->run(in, out);
  const std::uint64_t before = device->cycles();
  device->run(in, out);
  REQUIRE(out.size() == 200);
  CHECK(device->cycles() - before == 200 * (8 + 6 + 1) + 1);
}
