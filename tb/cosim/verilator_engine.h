// SPDX-License-Identifier: Apache-2.0
/// Verilated devices as engines.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "tb/device.h"
#include "tb/engine.h"

namespace blysk::cosim {

/// A Verilated device. Its run() keeps the protocol of harness::systemc_engine: strobes change with the falling edges of
/// clk, every write takes two cycles, the results of one are read at the leading edge of the valid port that begins the
/// next.
class verilator_engine : public clocked_engine {
 public:
  /// Applies the inputs, lets the device settle and reads the outputs and the inner results.
  /// \param levels  a number for each port, in the order of device::ports()
  virtual void apply(std::span<std::int64_t> levels) = 0;

 protected:
  using clocked_engine::clocked_engine;
};

/// The exported Verilog of the device in the format. All named formats of all devices are compiled in: those under
/// rtl_verilog/ from there, the others from an export into the build tree.
/// Its run() throws std::logic_error for a device without the strobe protocol.
/// \throws std::invalid_argument for options that differ from the presets
std::unique_ptr<verilator_engine> make_verilator(const selection& asked);

}  // namespace blysk::cosim
