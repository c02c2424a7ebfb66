// SPDX-License-Identifier: Apache-2.0
// The device of UA 60553 as a pipeline.
#include "tb/specular/pipelined.h"

namespace blysk::quadratic_pipelined_device {
namespace {

class quadratic_pipelined final : public specular::pipelined {
 public:
  quadratic_pipelined()
      : pipelined("quadratic", {{{{"mul6"}, {"mul7"}}, 4769},
                                {{{"add15"}, {"inv8", "add9"}}, 4544},
                                {{{"mul10"}}, 7791},
                                {{{"add11"}}, 3637},
                                {{{"quant11"}}, 2666},
                                {{{"mul12"}, {"mul13"}, {"mul14"}}, 4038}}) {}
  std::string name() const override { return "quadratic-pipelined"; }
  std::string title() const override { return "quadratic as a pipeline, a point each clock cycle"; }
  std::string good_for() const override { return "the picture of quadratic at the clock of one multiplier"; }
};

}  // namespace

const device& instance() {
  static const quadratic_pipelined device;
  return device;
}

}  // namespace blysk::quadratic_pipelined_device
