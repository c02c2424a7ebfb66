// SPDX-License-Identifier: Apache-2.0
/// The columns of a device that shades a point: n, cos, r, g, b in; red, green, blue among its results.
#pragma once

#include <cstdint>

#include "tb/columns.h"
#include "tb/device.h"
#include "tb/render/effects/energy.h"

namespace blysk::render {

class device_ports {
 public:
  /// \throws std::invalid_argument for a device with other columns
  explicit device_ports(const selection& asked);

  /// Fraction bits of cos, UQ1.F.
  int cos_fraction() const { return cos_fraction_; }
  std::int64_t one() const { return std::int64_t{1} << cos_fraction_; }

  /// Empty columns of the stimulus.
  columns make_writes() const { return columns(ports_, port::role::data); }

  /// A write into row i.
  void set(columns& writes, std::size_t row, int n, std::int64_t cosine,
           const std::array<std::uint8_t, 3>& colour) const;

  /// Specular term of a channel, 16 fraction bits.
  std::int64_t term(const columns& results, std::size_t row, std::size_t channel,
                    const energy_share& by = {}) const;

  /// Whether the colour outputs carry 0..255 and no more.
  bool is_limited() const;

  /// The code of a channel's output, of a device that computes on integers.
  std::int64_t code(const columns& results, std::size_t row, std::size_t channel) const {
    return results[result_column_[channel]].get(row);
  }

  /// What a channel's output can carry.
  const wire_format& result_format(std::size_t channel) const { return result_format_[channel]; }

  /// Whether red, green and blue are all 0.
  bool is_dark(const columns& results, std::size_t row) const;

 private:
  std::vector<port> ports_;
  int cos_fraction_ = 0;
  std::array<std::size_t, 3> result_column_{};
  std::array<wire_format, 3> result_format_{};
};

/// Where the lobe of a device begins.
class lobe_table {
 public:
  /// \param law  gives the same numbers as the engine that shades
  lobe_table(const selection& asked, engine& law) : ports_(asked), law_(law) {}

  /// The smallest code of cos at which a write of exponent n with all colours at 255 gives anything but 0; one above the
  /// largest code if there is none. Found by computing every code below it.
  std::int64_t begin(int n);

 private:
  device_ports ports_;
  engine& law_;
  std::map<int, std::int64_t> known_;
};

}  // namespace blysk::render
