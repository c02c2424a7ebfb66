// SPDX-License-Identifier: Apache-2.0
/// Measured delays put behind the wires of a device. The hardware knows nothing of them.
///
/// A block computes at once when an input changes, and writes. What it writes is taken here. Each bit of the output is shown
/// when the last of the changed input bits has had the time that the block takes from it to this bit. Delays are inertial: a
/// later write takes back what is pending, and a bit that would be shown sooner than what an earlier change still has under
/// way waits for that. So a pulse shorter than a bit's delay is not seen.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <systemc>
#include <vector>

#include "tb/delays.h"
#include "tb/netlist/elaborated.h"
#include "tb/netlist/wire.h"

namespace blysk::harness {

/// Times are in ps since the start.
using picoseconds = std::uint64_t;

/// When a wire changed for the last time, and until when it might have.
struct wire_history {
  picoseconds changed_at = 0;
  std::uint64_t changed_bits = 0;  ///< at that time
  picoseconds busy_until =
      0;  ///< no path from a changed bit of a register is under way any more; see find_activity()
};

class delay_lines final : public sc_core::sc_module {
 public:
  using SC_CURRENT_USER_MODULE = delay_lines;

  explicit delay_lines(const sc_core::sc_module_name& name);
  ~delay_lines() override;

  /// Puts the delays of all blocks of a device behind their outputs, as soon as SystemC has bound the ports. Constants have
  /// none. Device and delays outlive the simulation.
  /// \throws std::invalid_argument from the elaboration if the delays lack a block or a wire, or the device's nets are
  ///         plain signals
  void delay(const netlist::elaborated& device, const device_delays& delays);

  /// An input of a block. Without a wire all its bits count as changed whenever the block writes.
  struct input {
    const netlist::any_wire* wire;
    int width;
  };

  /// Puts delays behind one wire.
  /// \param ps  [bit of the output][bit of the inputs], or block_delays::kNoPath
  void delay(netlist::any_wire& output, const std::vector<input>& inputs,
             const std::vector<std::vector<int>>& ps);

  /// \throws std::invalid_argument for a wire without delays
  const wire_history& history(const netlist::any_wire& of) const;

  /// Brings `busy_until` of all wires of the device up to date: for each bit the longest path to it from the bits of
  /// registers that changed. Between the blocks' values, cells may change their outputs for a while that long.
  void find_activity();

  /// The earliest time of what is pending; the largest number if nothing is.
  picoseconds next() const;

 private:
  class line;

  void end_of_elaboration() override;
  void show_due();
  void arm(picoseconds at);

  const netlist::elaborated* device_ = nullptr;
  const device_delays* delays_ = nullptr;
  std::vector<std::unique_ptr<line>> lines_;  // those of a device in the order of its data
  std::map<const netlist::any_wire*, const line*> drivers_;
  sc_core::sc_event due_;
  picoseconds armed_ = std::numeric_limits<picoseconds>::max();
};

/// The simulation's time.
picoseconds now_ps();

}  // namespace blysk::harness
