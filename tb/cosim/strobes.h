// SPDX-License-Identifier: Apache-2.0
/// Strobes as a host may send them, in every order.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>

#include "tb/cosim/verilator_engine.h"

namespace blysk::cosim {

enum class codes { legal, all };

/// Strobes and data of one clock cycle: they change with the falling edge of clk.
class strobe_sequence {
 public:
  /// \param which  legal: n in 1..1000, cos <= 1; all: whatever the wires can carry
  explicit strobe_sequence(int fraction, codes which = codes::legal)
      : codes_(which == codes::legal ? (std::uint64_t{1} << fraction) + 1 : std::uint64_t{2} << fraction),
        smallest_(which == codes::legal ? 1 : 0),
        largest_(which == codes::legal ? 1000 : 1023) {}

  /// Sequences of 16 cycles keep to one pattern; every eighth starts with a reset, in whatever the registers do, and
  /// leaves one register unwritten or none, so that its reset value is seen.
  pins next(pins now) {
    if (cycle_ % 16 == 0) {
      pattern_ = static_cast<pattern>(random_() % 4);
      unwritten_ = cycle_ % (8 * 16) == 0 ? static_cast<int>(random_() % 6) : 0;
    }
    now.rst_n = cycle_ % (8 * 16) >= 2;
    now.n_i = exponent();
    now.cos_i = cosine();
    now.r_i = byte();
    now.g_i = byte();
    now.b_i = byte();
    const bool toggled = !now.cos_we_i;
    const auto strobe = [&](bool is_17) {
      switch (pattern_) {
        case pattern::quiet:
          return false;
        case pattern::together:
          return toggled;
        case pattern::back_to_back:
          return is_17 ? toggled : bit();
        case pattern::any:
          break;
      }
      return bit();
    };
    now.n_we_i = strobe(false) && unwritten_ != 1;
    now.cos_we_i = strobe(true) && unwritten_ != 2;
    now.r_we_i = strobe(false) && unwritten_ != 3;
    now.g_we_i = strobe(false) && unwritten_ != 4;
    now.b_we_i = strobe(false) && unwritten_ != 5;
    ++cycle_;
    return now;
  }

 private:
  enum class pattern { any, quiet, back_to_back, together };

  // Small ones are as frequent as large ones, whose lobes are so narrow that most cosines lie beyond.
  std::uint16_t exponent() {
    const unsigned below = 1u << random_() % 11;
    return static_cast<std::uint16_t>(std::min<std::uint64_t>(smallest_ + random_() % below, largest_));
  }
  // Every fourth lies within 64 codes of 1, where the lobe of a large n is.
  std::uint32_t cosine() {
    const std::uint64_t reach = random_() % 4 == 0 ? std::min<std::uint64_t>(codes_, 64) : codes_;
    return static_cast<std::uint32_t>(codes_ - 1 - random_() % reach);
  }
  bool bit() { return (random_() & 1) != 0; }
  std::uint8_t byte() { return static_cast<std::uint8_t>(random_() & 255); }

  std::mt19937_64 random_{1};
  std::uint64_t codes_;
  std::uint64_t smallest_, largest_;  // n
  std::uint64_t cycle_ = 0;
  pattern pattern_ = pattern::any;
  int unwritten_ = 0;  // number of the register, 1..5
};

/// Cycles of a strobe_sequence that reach every pattern and reset many times.
inline constexpr int kStrobeCycles = 20'000;

/// Calls use(outputs) after every edge of clk of kStrobeCycles cycles of legal strobes.
template <class Use>
void play_strobes(verilator_engine& verilog, int fraction, Use use) {
  strobe_sequence strobes(fraction);
  pins values;
  for (int cycle = 0; cycle < kStrobeCycles; ++cycle) {
    values = strobes.next(values);
    for (const bool clk : {false, true}) {
      values.clk = clk;
      use(verilog.apply(values));
    }
  }
}

}  // namespace blysk::cosim
