// SPDX-License-Identifier: Apache-2.0
/// A device that computes what another one does, bit for bit, and differs in its registers.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tb/device.h"

namespace blysk::specular {

/// Models, formula, memories and options are those of the other device.
class device_of_same_values : public device {
 public:
  std::string source() const override;
  std::vector<option> options() const override;
  void check(const selection& asked) const override;
  std::unique_ptr<engine> make_bit(const selection& asked) const override;
  std::int64_t rom_bits(const selection& asked) const override;
  word_lengths widths(const selection& asked) const override;
  std::unique_ptr<engine> make_bit(const selection& asked, const word_lengths& bits) const override;
  std::unique_ptr<engine> make_golden(const selection& asked) const override;
  std::size_t enumerated() const override;
  std::vector<std::int64_t> corners(const selection& asked,
                                    std::span<const std::int64_t> before) const override;
  std::optional<selection> computes_as(const selection& asked) const override;

 protected:
  /// \param whose  the other device's name
  explicit device_of_same_values(std::string whose) : whose_(std::move(whose)) {}

  const device& other() const;

  /// What is asked for, of the other device.
  selection of_other(const selection& asked) const;

 private:
  std::string whose_;
};

}  // namespace blysk::specular
