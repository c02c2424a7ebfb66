// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <systemc>
#include <vector>

#include "tb/netlist/elaborated.h"
#include "tb/wave_values.h"

namespace blysk::harness {

/// Follows the ports of a device and traces what they stand for as real numbers; of the error six digits, since viewers cut
/// longer numbers, their exponent first. Values change in the delta cycle after their wires. Made before simulation starts.
class value_recorder final : public sc_core::sc_module {
 public:
  using SC_CURRENT_USER_MODULE = value_recorder;

  value_recorder(const sc_core::sc_module_name& name, const netlist::elaborated& device, wave_values values,
                 sc_core::sc_trace_file* file);

 private:
  void rise();
  void show();
  const std::vector<std::int64_t>& levels();

  const netlist::elaborated& device_;
  wave_values values_;
  std::vector<std::int64_t> levels_;
  std::vector<double> shown_;  // what SystemC traces
  double error_ = 0;           // with all digits
};

}  // namespace blysk::harness
