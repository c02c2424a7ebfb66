// SPDX-License-Identifier: Apache-2.0
// rational with its divider in time.
#include "tb/specular/iterative.h"

namespace blysk::rational_iterative_device {
namespace {

class rational_iterative final : public specular::iterative {
 public:
  rational_iterative() : iterative("rational") {}
  std::string name() const override { return "rational-iterative"; }
  std::string title() const override { return "rational with a divider that finds a digit each clock cycle"; }
  std::string good_for() const override {
    return "rational's lobe with one subtractor, where a point may take F + 3 cycles";
  }
  std::string words(const selection& asked) const override {
    return other().words(of_other(asked)) + ", a digit of the quotient each clock cycle";
  }
};

}  // namespace

const device& instance() {
  static const rational_iterative device;
  return device;
}

}  // namespace blysk::rational_iterative_device
