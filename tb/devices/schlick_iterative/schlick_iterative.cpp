// SPDX-License-Identifier: Apache-2.0
// schlick with its divider in time.
#include "tb/specular/iterative.h"

namespace blysk::schlick_iterative_device {
namespace {

class schlick_iterative final : public specular::iterative {
 public:
  schlick_iterative() : iterative("schlick") {}
  std::string name() const override { return "schlick-iterative"; }
  std::string title() const override { return "schlick with a divider that finds a digit each clock cycle"; }
  std::string good_for() const override {
    return "Schlick's lobe with one subtractor, where a point may take F + 3 cycles";
  }
  std::string words(const selection&) const override { return "a digit of the quotient each clock cycle"; }
};

}  // namespace

const device& instance() {
  static const schlick_iterative device;
  return device;
}

}  // namespace blysk::schlick_iterative_device
