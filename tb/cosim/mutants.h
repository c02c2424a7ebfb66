// SPDX-License-Identifier: Apache-2.0
/// All single-fault mutants of an exported device in one verilated module.
#pragma once

#include <memory>

#include "tb/cosim/verilator_engine.h"

namespace blysk::cosim {

class mutants : public verilator_engine {
 public:
  /// \param number  1 .. how many there are; 0 is the device without a fault
  virtual void select(unsigned number) = 0;
};

/// Its run() gives no brdf: yosys keeps no such net.
std::unique_ptr<mutants> make_mutants();

}  // namespace blysk::cosim
