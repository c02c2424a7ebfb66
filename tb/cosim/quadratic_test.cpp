// SPDX-License-Identifier: Apache-2.0
// The exported Verilog and the reference written by hand against the bit-accurate model, bit for bit. sweep_verilog does
// the same with more inputs of the wide formats.
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

class comparison {
 public:
  explicit comparison(const std::string& format)
      : fraction(fraction_bits(options_of(format))),
        exported_(make_verilator(options_of(format))),
        reference_(make_reference(format)),
        model_(bit::make_quadratic(options_of(format))) {}

  void check(const batch& in) {
    model_->run(in, expected_);
    compared += in.size();
    check(in, "exported", *exported_);
    check(in, "by hand", *reference_);
  }

  const int fraction;
  std::uint64_t compared = 0;

 private:
  void check(const batch& in, const std::string& which, verilator_engine& verilog) {
    verilog.run(in, got_);
    if (got_ == expected_) return;
    for (std::size_t i = 0; i < in.size(); ++i) {
      CAPTURE(which, in.n[i], in.cos_delta[i], int{in.red_ks[i]}, int{in.green_ks[i]}, int{in.blue_ks[i]});
      REQUIRE(got_.brdf[i] == expected_.brdf[i]);
      REQUIRE(got_.red[i] == expected_.red[i]);
      REQUIRE(got_.green[i] == expected_.green[i]);
      REQUIRE(got_.blue[i] == expected_.blue[i]);
    }
    FAIL("results of another length");
  }

  std::unique_ptr<verilator_engine> exported_, reference_;
  std::unique_ptr<engine> model_;
  results got_, expected_;
};

void check_all_inputs(const std::string& format) {
  comparison all(format);
  for_all_inputs(all.fraction, [&](const batch& in) { all.check(in); });
  CHECK(all.compared == 1000 * ((std::uint64_t{1} << all.fraction) + 1));
}

}  // namespace

TEST_CASE("q8: all n at all cosines", "[cosim][full]") {
  check_all_inputs("q8");
}
TEST_CASE("q10: all n at all cosines", "[cosim][full]") {
  check_all_inputs("q10");
}
TEST_CASE("q12: all n at all cosines", "[cosim][full]") {
  check_all_inputs("q12");
}

TEST_CASE("q8: every colour at every cosine", "[cosim]") {
  comparison all("q8");
  batch in;
  for (unsigned code = 0; code <= 256; ++code) {
    // At n = 1 the parabola rises all the way from 0 to 1, so the BRDF takes most of its values.
    for (unsigned colour = 0; colour < 256; ++colour)
      append(in, 1, code, colour, 255 - colour, colour ^ 0x55u);
  }
  all.check(in);
}

TEST_CASE("random inputs of every format", "[cosim]") {
  const std::string format = GENERATE("q8", "q10", "q12", "q14", "q16", "q18", "q20", "q22", "q24");
  CAPTURE(format);
  comparison all(format);
  for_random_inputs(all.fraction, 20'000, 1, [&](const batch& in) { all.check(in); });
}

TEST_CASE("the ends, the roots and the clamp's edges of the wide formats", "[cosim][full]") {
  const std::string format = GENERATE("q18", "q20", "q22", "q24");
  CAPTURE(format);
  comparison all(format);
  for_corner_inputs(all.fraction, 1 << 10, [&](const batch& in) { all.check(in); });
}

}  // namespace blysk::cosim
