// SPDX-License-Identifier: Apache-2.0
#include "tb/cosim/mutants.h"

#include "Vmutants.h"
#include "tb/cosim/verilated_quadratic.h"

namespace blysk::cosim {
namespace {

struct device {
  Vmutants top;
  std::int64_t brdf() const { return 0; }
};

class verilated_mutants final : public verilated_quadratic<device, mutants> {
 public:
  void select(unsigned number) override { device_.top.mutant = static_cast<SData>(number); }
};

}  // namespace

std::unique_ptr<mutants> make_mutants() {
  return std::make_unique<verilated_mutants>();
}

}  // namespace blysk::cosim
