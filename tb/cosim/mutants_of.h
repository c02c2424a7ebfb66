// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/cosim/mutants.h"
#include "tb/cosim/verilated.h"

namespace blysk::cosim {

/// \tparam Glue  of a module with mutants
template <class Glue>
class mutants_of final : public verilated<Glue, mutants> {
 public:
  void select(unsigned number) override {
    auto& selector = this->glue_.top.mutant;
    selector = static_cast<std::remove_reference_t<decltype(selector)>>(number);
  }
};

}  // namespace blysk::cosim
