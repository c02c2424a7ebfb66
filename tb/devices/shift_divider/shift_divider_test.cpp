// SPDX-License-Identifier: Apache-2.0
// The divider by shifts against [T]'s figures and against division itself.
#include <algorithm>
#include <cmath>

#include "tb/catch.h"
#include "tb/device.h"
#include "tb/harness/systemc_engine.h"

namespace {

using namespace blysk;

/// difference / k through the bit-accurate model.
double divided(const std::string& format, std::int64_t difference, std::int64_t k) {
  const selection asked = choose("shift-divider", format);
  columns in(asked.of().ports(asked), port::role::data);
  columns out;
  in.resize(1);
  in[0].set(0, difference);
  in[1].set(0, k);
  asked.of().make_bit(asked)->run(in, out);
  REQUIRE(out.size() == 1);
  return std::ldexp(out[0].real(0), -asked.fraction());
}

/// Rows of one difference, run lengths 1..count.
columns runs(const selection& asked, std::int64_t difference, std::size_t count) {
  columns in(asked.of().ports(asked), port::role::data);
  in.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    in[0].set(i, difference);
    in[1].set(i, i + 1);
  }
  return in;
}

}  // namespace

TEST_CASE("8 shifts have the errors that the thesis states", "[shift-divider]") {
  // [T] 2.4, k = 2..16, difference 255: largest absolute error 0.4427, mean relative error 0.81 %.
  double largest = 0;
  double sum = 0;
  for (std::int64_t k = 2; k <= 16; ++k) {
    const double exact = 255.0 / static_cast<double>(k);
    const double error = std::abs(divided("q8", 255, k) - exact);
    largest = std::max(largest, error);
    sum += error / exact;
  }
  CHECK(std::round(largest * 1e4) == 4427);
  CHECK(std::round(sum / 15 * 1e4) == 81);
}

TEST_CASE("powers of two and a run of one pixel are exact", "[shift-divider]") {
  for (const std::int64_t difference : {-255, -1, 0, 1, 128, 255}) {
    for (std::int64_t k = 1; k <= 256; k *= 2)
      CHECK(divided("q8", difference, k) == static_cast<double>(difference) / static_cast<double>(k));
  }
}

TEST_CASE("the error of an increment is at most half a place of 1/k times the difference",
          "[shift-divider]") {
  for (const char* format : {"q8", "q16", "q24"}) {
    const selection asked = choose("shift-divider", format);
    const auto model = asked.of().make_bit(asked);
    columns out;
    double share = 0;
    for (const std::int64_t difference : {-255, -100, 1, 17, 255}) {
      model->run(runs(asked, difference, 1023), out);
      const double bound = std::ldexp(std::abs(static_cast<double>(difference)), -asked.fraction() - 1);
      for (std::size_t i = 0; i < out.size(); ++i) {
        const double exact = static_cast<double>(difference) / static_cast<double>(i + 1);
        const double error = std::abs(std::ldexp(out[0].real(i), -asked.fraction()) - exact);
        // Differences and run lengths are small integers: the quotient's own rounding is below 2^-44.
        CHECK(error <= bound + std::ldexp(1, -44));
        share = std::max(share, error / bound);
      }
    }
    CAPTURE(format, share);
    CHECK(share > 0.98);  // the bound is tight
  }
}

TEST_CASE("a division takes one clock cycle more than it has shifts", "[shift-divider]") {
  const selection asked = choose("shift-divider", "q8");
  const auto device = harness::make_systemc(asked);
  columns out;
  device->run(runs(asked, 255, 10), out);
  const std::uint64_t before = device->cycles();
  device->run(runs(asked, -255, 1000), out);
  REQUIRE(out.size() == 1000);
  // One cycle until the first row is offered.
  CHECK(device->cycles() - before == 1000 * (8 + 1) + 1);
  CHECK(device->writes() == 1010);
}
