// SPDX-License-Identifier: Apache-2.0
/// A device that shades points as another one does, by a quotient of which it finds a digit each clock cycle.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tb/specular/same_values.h"

namespace blysk::specular {

/// The iterative form of a device, on iterative_device in rtl_sysc. Its options are those of the other one.
class iterative : public device_of_same_values {
 public:
  std::string figure() const override {
    return other().figure() + ", a digit of the quotient each clock cycle";
  }

  /// A point is taken in the cycle that delivers the one before.
  int cycles_per_row(const selection& asked) const override { return *latency_cycles(asked); }

 protected:
  using device_of_same_values::device_of_same_values;
};

}  // namespace blysk::specular
