// SPDX-License-Identifier: Apache-2.0
// The exported Verilog against the bit-accurate model, bit for bit.
#include <algorithm>
#include <random>

#include "tb/bit/quadratic.h"
#include "tb/catch.h"
#include "tb/cosim/vectors.h"
#include "tb/cosim/verilator_engine.h"

namespace blysk::cosim {
namespace {

device_options options_of(const std::string& format) {
  device_options options;
  options.format = format;
  return options;
}

/// Verilog, the exported device's if no other is given, and the model that it has to equal.
class comparison {
 public:
  explicit comparison(const std::string& format)
      : comparison(options_of(format), make_verilator(options_of(format))) {}
  comparison(const device_options& options, std::unique_ptr<verilator_engine> verilog)
      : fraction(fraction_bits(options)),
        verilog_(std::move(verilog)),
        model_(bit::make_quadratic(options)) {}

  void check(const batch& in) {
    verilog_->run(in, got_);
    model_->run(in, expected_);
    compared += in.size();
    if (got_.brdf == expected_.brdf && got_.red == expected_.red && got_.green == expected_.green &&
        got_.blue == expected_.blue) {
      return;
    }
    for (std::size_t i = 0; i < in.size(); ++i) {
      CAPTURE(in.n[i], in.cos_delta[i], int{in.red_ks[i]}, int{in.green_ks[i]}, int{in.blue_ks[i]});
      REQUIRE(got_.brdf[i] == expected_.brdf[i]);
      REQUIRE(got_.red[i] == expected_.red[i]);
      REQUIRE(got_.green[i] == expected_.green[i]);
      REQUIRE(got_.blue[i] == expected_.blue[i]);
    }
  }

  const int fraction;
  std::uint64_t compared = 0;

 private:
  std::unique_ptr<verilator_engine> verilog_;
  std::unique_ptr<engine> model_;
  results got_, expected_;
};

void check_all_inputs(comparison both) {
  for_all_inputs(both.fraction, [&](const batch& in) { both.check(in); });
  CHECK(both.compared == 1000 * ((std::uint64_t{1} << both.fraction) + 1));
}

}  // namespace

TEST_CASE("q8: all n at all cosines", "[cosim][full]") {
  check_all_inputs(comparison("q8"));
}
TEST_CASE("q10: all n at all cosines", "[cosim][full]") {
  check_all_inputs(comparison("q10"));
}
TEST_CASE("q12: all n at all cosines", "[cosim][full]") {
  check_all_inputs(comparison("q12"));
}

TEST_CASE("the reference by hand: all n at all cosines", "[cosim][full]") {
  const std::string format = GENERATE("q8", "q10", "q12");
  CAPTURE(format);
  check_all_inputs({options_of(format), make_reference(format)});
}

TEST_CASE("q8: every colour at every cosine", "[cosim]") {
  comparison both("q8");
  batch in;
  for (unsigned code = 0; code <= 256; ++code) {
    // At n = 1 the parabola rises all the way from 0 to 1, so the BRDF takes most of its values.
    for (unsigned colour = 0; colour < 256; ++colour)
      append(in, 1, code, colour, 255 - colour, colour ^ 0x55u);
  }
  both.check(in);
}

TEST_CASE("random inputs of every format", "[cosim]") {
  const std::string format = GENERATE("q8", "q10", "q12", "q14", "q16", "q18", "q20", "q22", "q24");
  CAPTURE(format);
  comparison both(format);
  for_random_inputs(both.fraction, 20'000, 1, [&](const batch& in) { both.check(in); });
}

TEST_CASE("ten million random inputs of the wide formats", "[cosim][full]") {
  const std::string format = GENERATE("q14", "q16", "q18", "q20", "q22", "q24");
  CAPTURE(format);
  comparison both(format);
  for_random_inputs(both.fraction, 10'000'000, 2, [&](const batch& in) { both.check(in); });
}

TEST_CASE("the ends, the roots and the clamp's edges of the wide formats", "[cosim][full]") {
  const std::string format = GENERATE("q14", "q16", "q18", "q20", "q22", "q24");
  CAPTURE(format);
  comparison both(format);
  for_corner_inputs(both.fraction, 1 << 10, [&](const batch& in) { both.check(in); });
}

}  // namespace blysk::cosim
