// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "tb/render/render.h"

namespace blysk::render::test {

/// The bit-accurate model, or the formula, of a device for a picture.
class picture_source {
 public:
  picture_source(const selection& device, bool is_formula) {
    const auto make = [device, is_formula] {
      return is_formula ? device.of().make_golden(device) : device.of().make_bit(device);
    };
    of_ = std::make_unique<device_source>(device_source{device,
                                                        [this, make](unsigned thread) {
                                                          while (engines_.size() <= thread)
                                                            engines_.push_back(make());
                                                          return engines_[thread].get();
                                                        },
                                                        false, make});
  }
  const device_source* of() const { return of_.get(); }

 private:
  std::vector<std::unique_ptr<engine>> engines_;
  std::unique_ptr<device_source> of_;
};

}  // namespace blysk::render::test
