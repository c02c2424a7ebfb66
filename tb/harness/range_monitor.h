// SPDX-License-Identifier: Apache-2.0
/// What the nets of a device carry while it runs: the least and the greatest value of each, before it is cut to the wire.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <systemc>
#include <vector>

#include "tb/format.h"
#include "tb/netlist/elaborated.h"

namespace blysk::harness {

/// A net, named after the output that drives it, or after the register within a block.
struct net_range {
  std::string name;     ///< "mul10.p_o", "control.left"
  wire_format carries;  ///< of one bit where the block states no format
  bool has_format;      ///< stated by the block
  bool is_seen = false;
  netlist::wide_int least = 0, greatest = 0;  ///< valid where is_seen

  /// Whether all values seen are codes of the format.
  bool holds() const { return !is_seen || (least >= carries.min && greatest <= carries.max); }

  /// Bits that the values seen need, in two's complement where the format is signed.
  int bits_needed() const;
};

/// Watches a device from every rising edge of its clock: what the clock finds has settled. The value of an output is what
/// the block's law gives for the block's inputs, in 120 bits; that the wire carries its low bits is checked. The value of a
/// register is what it takes, when it takes it.
class range_monitor final : public sc_core::sc_module {
 public:
  using SC_CURRENT_USER_MODULE = range_monitor;

  /// \param device  outlives this; made before simulation starts
  range_monitor(const sc_core::sc_module_name& name, const netlist::elaborated& device);
  ~range_monitor() override;

  /// Off at first, as registers hold no legal codes before they have been written.
  void watch(bool on) { is_on_ = on; }

  /// In the order of the blocks.
  /// \throws std::logic_error if a wire did not carry what its block's law gives
  const std::vector<net_range>& ranges() const;

  /// Rising edges watched.
  std::uint64_t edges() const { return edges_; }

 private:
  class law;

  void start_of_simulation() override;
  void look();

  const netlist::elaborated& device_;
  bool is_on_ = false;
  std::uint64_t edges_ = 0;
  std::vector<std::unique_ptr<law>> laws_;
  std::vector<net_range> ranges_;
  std::string fault_;
};

}  // namespace blysk::harness
