// SPDX-License-Identifier: Apache-2.0
/// The exported Verilog of a device, verilated, as an engine.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "tb/engine.h"

namespace blysk {
struct device_options;  // tb/device.h brings SystemC along, which Verilator's headers then take for theirs
}

namespace blysk::cosim {

/// What the host drives; named as the device's ports.
struct pins {
  bool clk = false;
  bool rst_n = false;
  std::uint16_t n_i = 0;
  bool n_we_i = false;
  std::uint32_t cos_i = 0;
  bool cos_we_i = false;
  std::uint8_t r_i = 0;
  bool r_we_i = false;
  std::uint8_t g_i = 0;
  bool g_we_i = false;
  std::uint8_t b_i = 0;
  bool b_we_i = false;
};

/// What the device answers; raw integers, unsigned as their wires are without as_published.
struct outputs {
  std::uint64_t r_o = 0;
  std::uint64_t g_o = 0;
  std::uint64_t b_o = 0;
  bool valid_o = false;

  friend bool operator==(const outputs&, const outputs&) = default;
};

/// A verilated quadratic device. Its run() keeps the protocol of bench::systemc_engine: strobes change with the
/// falling edges of clk, every write takes two cycles, the results of one are read at the leading edge of 29 that
/// begins the next.
class verilator_engine : public clocked_engine {
 public:
  /// Applies the pins, lets the device settle and reads its outputs.
  virtual outputs apply(const pins& values) = 0;
};

/// The device checked in under rtl_verilog/ for the format.
/// \throws std::invalid_argument for options that no device has, and for others than the default coefficient,
///         constant and lobe: those are exported on demand, and not compiled into the program
std::unique_ptr<verilator_engine> make_verilator(const device_options& options);

/// reference_quadratic.v, written by hand, with the default coefficient, constant and lobe.
/// \throws std::invalid_argument for a format that does not exist
std::unique_ptr<verilator_engine> make_reference(const std::string& format);

}  // namespace blysk::cosim
