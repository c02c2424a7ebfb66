// SPDX-License-Identifier: Apache-2.0
/// The bit-accurate model of a device beside its formula and its bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "tb/catch.h"
#include "tb/inputs.h"
#include "tb/specular/specular.h"

namespace blysk::specular::test {

class bounded {
 public:
  explicit bounded(const selection& asked)
      : ulp_(std::ldexp(1.0, -asked.fraction())),
        bound_(dynamic_cast<const device_of_points&>(asked.of()).bound(asked)),
        bit_(asked.of().make_bit(asked)),
        golden_(asked.of().make_golden(formula_of(asked))) {
    if (!bound_) throw std::logic_error("the device derives no bound");
  }

  void check(const columns& writes) {
    bit_->run(writes, from_bit_);
    golden_->run(writes, from_golden_);
    inputs_ += writes.size();
    const auto* const n = writes[kN].data<std::uint16_t>();
    const double* const golden = from_golden_[kBrdf].data<double>();
    writes[kCos].visit([&](const auto& codes) {
      from_bit_[kBrdf].visit([&](const auto& brdf) {
        for (std::size_t i = 0; i < writes.size(); ++i) {
          const double c = static_cast<double>(codes[i]) * ulp_;
          const double error = std::fabs(static_cast<double>(brdf[i]) * ulp_ - golden[i]);
          const double allowed = bound_(n[i], c);
          if (!(error <= allowed)) {
            CAPTURE(n[i], codes[i], brdf[i], golden[i], error / ulp_, allowed / ulp_);
            FAIL("beyond the bound (errors in ulp)");
          }
          tightness_ = std::max(tightness_, error / allowed);
        }
      });
    });
    for (std::size_t channel = 0; channel < 3; ++channel) {
      for (std::size_t i = 0; i < writes.size(); i += 97) {
        const std::int64_t expected = from_bit_[kBrdf].get(i) * writes[kRed + channel].get(i);
        if (from_bit_[kOutRed + channel].get(i) != expected)
          FAIL("a colour is not the BRDF times its factor");
      }
    }
  }

  std::uint64_t inputs() const { return inputs_; }

  /// The largest error / bound so far.
  double tightness() const { return tightness_; }

 private:
  static selection formula_of(const selection& asked) {
    std::map<std::string, std::string> options = asked.values();
    for (const option& each : asked.of().options()) {
      if (each.is_wired) options.erase(each.name);
    }
    return choose(asked.of().name(), asked.format(), options, purpose::formula);
  }

  double ulp_;
  std::function<double(double, double)> bound_;
  std::unique_ptr<engine> bit_, golden_;
  std::uint64_t inputs_ = 0;
  double tightness_ = 0;
  columns from_bit_, from_golden_;
};

}  // namespace blysk::specular::test
