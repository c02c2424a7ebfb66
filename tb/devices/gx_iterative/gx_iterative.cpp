// SPDX-License-Identifier: Apache-2.0
// gx with its divider in time.
#include "tb/specular/iterative.h"

namespace blysk::gx_iterative_device {
namespace {

class gx_iterative final : public specular::iterative {
 public:
  gx_iterative() : iterative("gx") {}
  std::string name() const override { return "gx-iterative"; }
  std::string title() const override { return "gx with a divider that finds a digit each clock cycle"; }
  std::string good_for() const override {
    return "GX's lobe with one subtractor, where a point may take F + 3 cycles";
  }
  std::string words(const selection&) const override { return "a digit of the quotient each clock cycle"; }
};

}  // namespace

const device& instance() {
  static const gx_iterative device;
  return device;
}

}  // namespace blysk::gx_iterative_device
