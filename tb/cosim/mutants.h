// SPDX-License-Identifier: Apache-2.0
/// Single-fault mutants of an exported device, a hundred in one verilated module.
#pragma once

#include <memory>

#include "tb/cosim/verilator_engine.h"

namespace blysk::cosim {

class mutants : public verilator_engine {
 public:
  /// \param number  of a mutant that the module has, counted from 1 over all modules; any other number selects the
  ///                device without a fault
  virtual void select(unsigned number) = 0;
};

/// Mutants 100 (Hundred - 1) + 1 .. 100 Hundred. Their run() gives no brdf: yosys keeps no such net.
template <int Hundred>
std::unique_ptr<mutants> make_mutants();

}  // namespace blysk::cosim
