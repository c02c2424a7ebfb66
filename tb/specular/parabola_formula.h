// SPDX-License-Identifier: Apache-2.0
/// The formula a (c^2 - c) + c of the devices of rtl_sysc/devices/parabola.h in double, and the options that choose it.
#pragma once

#include "tb/specular/specular.h"

namespace blysk::specular {

/// A device whose options name a line of a, "coefficient", and the lobe, "as-published".
class parabola : public device_of_points {
 public:
  std::string equation(const selection& asked) const override;
  std::function<double(double, double)> formula(const selection& asked) const override;
  double root(const selection& asked, double n) const override;

  /// That of docs/architecture.md.
  std::function<double(double, double)> bound(const selection& asked) const override;

  /// The coefficient a of the formula.
  double coefficient(const selection& asked, double n) const;

  /// The coefficient a that the hardware forms, raw, with widths(asked)["coefficient"] fraction bits.
  /// \param n  1..1000
  virtual std::int64_t wired_coefficient(const selection& asked, int n) const = 0;

 protected:
  /// \param names  of the lines that the device has in hardware, the preset first
  /// \param formula_names  of those that its formula alone has
  static option coefficient_option(const std::vector<std::string>& names,
                                   const std::vector<std::string>& formula_names);
  static option as_published_option();

  /// ", BRDF clamped to [0, 1]"
  static std::string lobe_words(const selection& asked);
};

}  // namespace blysk::specular
