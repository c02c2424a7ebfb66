// SPDX-License-Identifier: Apache-2.0
// SystemC equals the bit-accurate model, bit for bit. One process per case: SystemC elaborates once.
#include <algorithm>
#include <random>

#include "tb/bench/systemc_engine.h"
#include "tb/bit/quadratic.h"
#include "tb/catch.h"

namespace {

using namespace blysk;

device_options options_of(const char* format, const char* coefficient, bool as_published) {
  device_options options;
  options.format = format;
  options.coefficient = coefficient;
  options.as_published = as_published;
  return options;
}

/// Writes with colours that a permutation of the index makes, so that every value of each is met.
void append(batch& writes, int n, std::uint32_t code) {
  const std::size_t i = writes.size();
  writes.n.push_back(static_cast<std::uint16_t>(n));
  writes.cos_delta.push_back(code);
  writes.red_ks.push_back(static_cast<std::uint8_t>(255 - i * 7 % 256));
  writes.green_ks.push_back(static_cast<std::uint8_t>(i * 101 % 256));
  writes.blue_ks.push_back(static_cast<std::uint8_t>(i * 31 % 256));
}

class comparison {
 public:
  explicit comparison(const device_options& options)
      : systemc_(bench::make_systemc(options)), bit_(bit::make_quadratic(options)) {}

  void check(const batch& writes) {
    systemc_->run(writes, from_systemc_);
    bit_->run(writes, from_bit_);
    if (from_systemc_.brdf == from_bit_.brdf && from_systemc_.red == from_bit_.red &&
        from_systemc_.green == from_bit_.green && from_systemc_.blue == from_bit_.blue) {
      return;
    }
    for (std::size_t i = 0; i < writes.size(); ++i) {
      CAPTURE(i, writes.n[i], writes.cos_delta[i], writes.red_ks[i], writes.green_ks[i], writes.blue_ks[i]);
      REQUIRE(from_systemc_.brdf[i] == from_bit_.brdf[i]);
      REQUIRE(from_systemc_.red[i] == from_bit_.red[i]);
      REQUIRE(from_systemc_.green[i] == from_bit_.green[i]);
      REQUIRE(from_systemc_.blue[i] == from_bit_.blue[i]);
    }
  }

 private:
  std::unique_ptr<bench::systemc_engine> systemc_;
  std::unique_ptr<engine> bit_;
  results from_systemc_, from_bit_;
};

void check_all_inputs(const device_options& options) {
  const std::uint32_t one = 1u << fraction_bits(options);
  comparison compared(options);
  batch writes;
  for (int n = 1; n <= 1000; ++n) {
    writes.resize(0);
    for (std::uint32_t code = 0; code <= one; ++code) append(writes, n, code);
    compared.check(writes);
  }
  SUCCEED("1000 exponents, " << one + 1 << " codes each");
}

constexpr std::uint32_t kAround = 8;           // codes on either side of every corner
constexpr std::size_t kRandomWrites = 100000;  // seed 60553

/// All n at the corners of cos (both ends, 1/2, both sides of the lobe's root), then random writes.
void check_sample(const device_options& options) {
  const std::uint32_t one = 1u << fraction_bits(options);
  comparison compared(options);
  batch writes;
  const auto around = [&](int n, std::uint32_t corner) {
    const std::uint32_t first = corner > kAround ? corner - kAround : 0;
    for (std::uint32_t code = first; code <= std::min(one, corner + kAround); ++code) append(writes, n, code);
  };
  for (int n = 1; n <= 1000; ++n) {
    writes.resize(0);
    around(n, 0);
    around(n, one / 2);
    around(n, one);
    const double a = std::max(1.0, 0.786939 * n - 0.5);
    around(n, static_cast<std::uint32_t>((1 - 1 / a) * one));
    compared.check(writes);
  }
  std::mt19937_64 random(60553);
  writes.resize(0);
  for (std::size_t i = 0; i < kRandomWrites; ++i) {
    append(writes, static_cast<int>(1 + random() % 1000), static_cast<std::uint32_t>(random() % (one + 1)));
  }
  compared.check(writes);
  SUCCEED("corners of 1000 exponents and " << kRandomWrites << " random writes");
}

// Every input of the two smallest formats.
TEST_CASE("q8 systemc = bit for all inputs", "[unit][equality]") {
  check_all_inputs(options_of("q8", "derived", false));
}
TEST_CASE("q8 systemc = bit for all inputs, coefficient published", "[unit][equality][full]") {
  check_all_inputs(options_of("q8", "published", false));
}
TEST_CASE("q8 systemc = bit for all inputs, as published", "[unit][equality][full]") {
  check_all_inputs(options_of("q8", "published", true));
}
TEST_CASE("q10 systemc = bit for all inputs", "[unit][equality][full]") {
  check_all_inputs(options_of("q10", "derived", false));
}
TEST_CASE("q10 systemc = bit for all inputs, as published", "[unit][equality][full]") {
  check_all_inputs(options_of("q10", "published", true));
}

// A stated sample of the others.
#define BLYSK_SAMPLE(format)                                                                            \
  TEST_CASE(format " systemc = bit at corners and at random", "[unit][equality][full]") {               \
    check_sample(options_of(format, "derived", false));                                                 \
  }                                                                                                     \
  TEST_CASE(format " systemc = bit at corners and at random, as published", "[unit][equality][full]") { \
    check_sample(options_of(format, "published", true));                                                \
  }
BLYSK_SAMPLE("q12")
BLYSK_SAMPLE("q14")
BLYSK_SAMPLE("q16")
BLYSK_SAMPLE("q18")
BLYSK_SAMPLE("q20")
BLYSK_SAMPLE("q22")
BLYSK_SAMPLE("q24")

}  // namespace
