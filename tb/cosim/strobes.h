// SPDX-License-Identifier: Apache-2.0
/// Strobes as a host may send them, in every order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <span>
#include <vector>

#include "tb/cosim/verilator_engine.h"
#include "tb/device.h"

namespace blysk::cosim {

enum class codes { legal, all };

/// The inputs of one clock cycle after the other: they change with the falling edge of clk.
class strobe_sequence {
 public:
  /// \param which  legal: the codes that the formats have; all: whatever the wires can carry
  explicit strobe_sequence(const selection& asked, codes which = codes::legal);

  const std::vector<port>& ports() const { return ports_; }

  /// Sequences of 16 cycles keep to one pattern; every eighth starts with a reset of two cycles or one, in whatever the
  /// registers do, and leaves one register unwritten or none, so that its reset value is seen. Data without a strobe, start
  /// and other controls change in every cycle.
  /// \param levels  of all ports in the device's order; the inputs but the clock are set
  void next(std::span<std::int64_t> levels);

 private:
  enum class pattern { any, quiet, back_to_back, together };
  enum class spread { even, small, large };

  /// A data port and its strobe.
  struct channel {
    std::size_t data;
    std::size_t strobe;  ///< of no port if it has none
    bool is_trailing;
    std::int64_t min, max;
    spread likely;
  };

  std::int64_t code(const channel& of);
  bool bit() { return (random_() & 1) != 0; }

  static constexpr std::uint64_t kResetEvery = 8 * 16;

  std::vector<port> ports_;
  std::vector<channel> channels_;
  std::mt19937_64 random_{1};
  std::uint64_t cycle_ = 0;
  pattern pattern_ = pattern::any;
  std::size_t unwritten_ = 0;  // number of the register, from 1
};

/// Cycles of a strobe_sequence that reach every pattern and reset many times.
inline constexpr int kStrobeCycles = 20'000;

/// Applies kStrobeCycles cycles of strobes and calls use(levels of all ports) after every edge of clk, from the first
/// rising one on, which resets the device, until it says false.
void play_strobes(verilator_engine& verilog, const selection& asked,
                  const std::function<bool(std::span<const std::int64_t>)>& use, codes which = codes::legal);

}  // namespace blysk::cosim
