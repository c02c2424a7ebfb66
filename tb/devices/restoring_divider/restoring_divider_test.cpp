// SPDX-License-Identifier: Apache-2.0
// The restoring divider against division itself, and clock for clock against the divider by shifts of the same width.
#include <algorithm>
#include <cmath>

#include "tb/catch.h"
#include "tb/device.h"
#include "tb/harness/systemc_engine.h"

namespace {

using namespace blysk;

/// Rows of one difference, run lengths 1..1023.
columns all_runs(const selection& asked, std::int64_t difference) {
  columns in(asked.of().ports(asked), port::role::data);
  in.resize(1023);
  for (std::size_t i = 0; i < in.size(); ++i) {
    in[0].set(i, difference);
    in[1].set(i, static_cast<std::int64_t>(i) + 1);
  }
  return in;
}

/// The largest error of the bit-accurate model over the run lengths, all differences or some of them.
double largest_error(const std::string& device, const std::string& format) {
  const selection asked = choose(device, format);
  const auto model = asked.of().make_bit(asked);
  columns out;
  double largest = 0;
  for (const std::int64_t difference : {-255, -254, -129, -1, 0, 1, 17, 128, 253, 255}) {
    model->run(all_runs(asked, difference), out);
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double exact = static_cast<double>(difference) / static_cast<double>(i + 1);
      largest = std::max(largest, std::abs(std::ldexp(out[0].real(i), -asked.fraction()) - exact));
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("the increment is the quotient, cut towards 0", "[restoring-divider]") {
  for (const char* format : {"q8", "q16", "q24"}) {
    const selection asked = choose("restoring-divider", format);
    const auto model = asked.of().make_bit(asked);
    columns out;
    for (std::int64_t difference = -255; difference <= 255; ++difference) {
      model->run(all_runs(asked, difference), out);
      REQUIRE(out.size() == 1023);
      for (std::size_t i = 0; i < out.size(); ++i) {
        const std::int64_t scaled = difference * (std::int64_t{1} << asked.fraction());
        CAPTURE(format, difference, i + 1);
        REQUIRE(out[0].get(i) == scaled / (static_cast<std::int64_t>(i) + 1));  // C++ cuts towards 0 too
      }
    }
  }
}

TEST_CASE("a division takes n + 9 clock cycles, eight more than one by shifts of the same width",
          "[restoring-divider]") {
  const selection asked = choose("restoring-divider", "q8");
  const auto device = harness::make_systemc(asked);
  columns out;
  device->run(all_runs(asked, 255), out);
  const std::uint64_t before = device->cycles();
  for (const std::int64_t difference : {-255, 0, 100}) device->run(all_runs(asked, difference), out);
  REQUIRE(out.size() == 1023);
  const std::uint64_t cycles =
      device->cycles() - before - 3;  // one until the first row of each run is offered
  CHECK(device->writes() == 4 * 1023);
  REQUIRE(cycles % (3 * 1023) == 0);
  const std::uint64_t restoring = cycles / (3 * 1023);
  const std::uint64_t by_shifts = 8 + 1;  // counted by unit.shift-divider
  CHECK(restoring == 8 + 9);
  // [T] 2.4 tells 2946 cycles of a processor against 2064 for the 408 sums and 42 divisions of its triangle. With a clock
  // for each sum these devices take 1122 against 786.
  const double ratio = static_cast<double>(408 + 42 * restoring) / static_cast<double>(408 + 42 * by_shifts);
  CHECK(ratio == Approx(1122.0 / 786));
  CHECK(std::round(ratio * 100) == std::round(2946.0 / 2064 * 100));
}

TEST_CASE("at the same width the shifts' error is up to half the difference as large",
          "[restoring-divider]") {
  for (const char* format : {"q8", "q16", "q24"}) {
    const double place = std::ldexp(1, -choose("restoring-divider", format).fraction());
    CAPTURE(format);
    CHECK(largest_error("restoring-divider", format) < place);
    CHECK(largest_error("restoring-divider", format) > 0.99 * place);
    CHECK(largest_error("shift-divider", format) <= 127.5 * place);
    CHECK(largest_error("shift-divider", format) > 125 * place);
  }
}

TEST_CASE("seven shifts more bring the shifts below a place of the quotient", "[restoring-divider]") {
  // n + 7 shifts take n + 8 clocks, one less than the restoring division to n places.
  const selection asked = choose("shift-divider", "q8");
  for (const int more : {6, 7}) {
    const auto model = asked.of().make_bit(asked, {{"steps", 8 + more}});
    columns out;
    model->run(all_runs(asked, 255), out);
    double largest = 0;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double exact = 255.0 / static_cast<double>(i + 1);
      largest = std::max(largest, std::abs(std::ldexp(out[0].real(i), -8 - more) - exact));
    }
    CAPTURE(more, largest);
    CHECK((largest < std::ldexp(1, -8)) == (more == 7));
  }
}

TEST_CASE("restoring-divider says what it is", "[words]") {
  const selection asked = choose("restoring-divider", "q8");
  CHECK(asked.text() == "device restoring-divider, format q8, 16 digits");
  CHECK(asked.of().rom_bits(asked) == 0);
  CHECK_THROWS_WITH(asked.of().make_bit(asked, {{"steps", 8}}),
                    "word length steps does not exist, expected increment");
  CHECK_THROWS_WITH(asked.of().make_bit(asked, {{"increment", 49}}),
                    "word length increment 49 is outside its range, expected 1..48");
}
