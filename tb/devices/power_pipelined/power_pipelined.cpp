// SPDX-License-Identifier: Apache-2.0
// The device of cos^n itself as a pipeline.
#include "tb/specular/pipelined.h"

namespace blysk::power_pipelined_device {
namespace {

class power_pipelined final : public specular::pipelined {
 public:
  power_pipelined()
      : pipelined("power", {{{{"norm"}}, 2707},
                            {{{"inv_f", "add_f"}, {"rom_ratio"}, {"rom_ratio_change"}}, 1956},
                            {{{"mul_ratio"}}, 4152},
                            {{{"add_ratio"}}, 2601},
                            {{{"mul_log"}}, 5053},
                            {{{"add_log"}}, 598},
                            {{{"mul_n"}}, 6401},
                            {{{"rom_power"}, {"rom_power_change"}, {"off"}}, 1064},
                            {{{"mul_power"}}, 4722},
                            {{{"add_power"}}, 2806},
                            {{{"shift"}}, 921},
                            {{{"quant", "key_brdf"}}, 2288},
                            {{{"mul12"}, {"mul13"}, {"mul14"}}, 4059}}) {}
  std::string name() const override { return "power-pipelined"; }
  std::string title() const override { return "power as a pipeline, a point each clock cycle"; }
  std::string good_for() const override { return "cos^n to the last place at the clock of one multiplier"; }
};

}  // namespace

const device& instance() {
  static const power_pipelined device;
  return device;
}

}  // namespace blysk::power_pipelined_device
