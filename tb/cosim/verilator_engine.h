// SPDX-License-Identifier: Apache-2.0
/// Verilated devices as engines.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "tb/device.h"
#include "tb/engine.h"

namespace blysk::cosim {

class recording;

/// A Verilated device. Its run() keeps the protocol of harness::systemc_engine: strobes change with the falling edges of
/// clk, every write takes two cycles, the results of one are read at the leading edge of the valid port that begins the
/// next.
class verilator_engine : public recorded_engine {
 public:
  /// Which device a waveform is of.
  void set_device(const selection& asked) { asked_ = asked; }

  /// Applies the inputs, lets the device settle and reads the outputs and the inner results.
  /// \param levels  a number for each port, in the order of device::ports()
  virtual void apply(std::span<std::int64_t> levels) = 0;

 protected:
  using recorded_engine::recorded_engine;

  /// \throws std::bad_optional_access before set_device()
  std::unique_ptr<recording> make_recording(const std::string& path) const;

 private:
  std::optional<selection> asked_;
};

/// Whether waves can be recorded. Verilator keeps every net for them, so such a class is another one.
enum class waves { off, on };

/// The exported Verilog of the device in the format. All named formats of all devices are compiled in: those under
/// rtl_verilog/ from there, the others from an export into the build tree, as those with the options that a device lists for
/// this engine. With waves there are those under rtl_verilog/.
/// Its run() throws std::logic_error for a device without the strobe protocol.
/// \throws std::invalid_argument for other options that differ from the presets, and a format that is not compiled in
std::unique_ptr<verilator_engine> make_verilator(const selection& asked, waves recorded = waves::off);

}  // namespace blysk::cosim
