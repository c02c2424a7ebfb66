// SPDX-License-Identifier: Apache-2.0
/// Single-fault mutants of an exported device, a hundred in one Verilated module.
#pragma once

#include <memory>
#include <span>

#include "tb/cosim/verilator_engine.h"

namespace blysk::cosim {

/// Inner results read as 0: yosys keeps no such nets.
class mutants : public verilator_engine {
 public:
  /// \param number  of a mutant that the module has, counted from 1 over all modules; any other number selects the
  ///                device without a fault
  virtual void select(unsigned number) = 0;

 protected:
  using verilator_engine::verilator_engine;
};

/// What makes the modules: entry i the one of mutants 100 i + 1 .. 100 (i + 1). Made by CMake for a program of one device
/// and format.
std::span<std::unique_ptr<mutants> (*const)()> mutants_table();

}  // namespace blysk::cosim
