// SPDX-License-Identifier: Apache-2.0
// Compiled once for each hundred, BLYSK_HUNDRED, whose class is BLYSK_CLASS of BLYSK_HEADER.
#include "tb/cosim/mutants.h"

#include BLYSK_HEADER
#include "tb/cosim/verilated_quadratic.h"

namespace blysk::cosim {
namespace {

struct device {
  BLYSK_CLASS top;
  std::int64_t brdf() const { return 0; }
};

class verilated_mutants final : public verilated_quadratic<device, mutants> {
 public:
  void select(unsigned number) override { device_.top.mutant = static_cast<SData>(number); }
};

}  // namespace

template <>
std::unique_ptr<mutants> make_mutants<BLYSK_HUNDRED>() {
  return std::make_unique<verilated_mutants>();
}

}  // namespace blysk::cosim
