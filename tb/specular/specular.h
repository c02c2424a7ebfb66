// SPDX-License-Identifier: Apache-2.0
/// What the devices with the registers and colour multipliers of rtl_sysc/devices/specular.h share on this side.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tb/device.h"

namespace blysk::specular {

/// A device that computes (brdf, red, green, blue) from (n, cos, r, g, b).
class device_of_points : public device {
 public:
  /// n and cos; the colours run alongside.
  std::size_t enumerated() const override { return 2; }

  /// The code at the upper end of where the BRDF is 0, for the exponent before it.
  std::vector<std::int64_t> corners(const selection& asked,
                                    std::span<const std::int64_t> before) const override;

  std::unique_ptr<engine> make_golden(const selection& asked) const override;

  /// The device's own formula in words, "BRDF = c / (n - n c + c)", c = cos(delta).
  virtual std::string equation(const selection& asked) const = 0;

  /// The device's own formula: BRDF of n and cos(delta), limited as the options say.
  virtual std::function<double(double n, double c)> formula(const selection& asked) const = 0;

  /// How far the bit-accurate model's BRDF may be from the formula's at any n and cos(delta): a bound that is derived from
  /// the word lengths, the double's own rounding included. Empty if none is derived.
  virtual std::function<double(double n, double c)> bound(const selection&) const { return {}; }

  /// The largest cos(delta) below 1 where the formula's lobe ends, in [0, 1).
  virtual double root(const selection& asked, double n) const = 0;
};

/// What a device whose word lengths all go with the format makes of others.
/// \throws std::invalid_argument unless they are the cosine's alone, that of the format
void check_only_cosine(const selection& asked, const word_lengths& bits);

/// Columns of the stimulus and of the results, in the ports' order.
enum stimulus_column : std::size_t { kN, kCos, kRed, kGreen, kBlue };
enum result_column : std::size_t { kBrdf, kOutRed, kOutGreen, kOutBlue };

}  // namespace blysk::specular
