// SPDX-License-Identifier: Apache-2.0
/// The effects of a plan through a device that adds them up, light by light, in the place of their laws on the host.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tb/engine.h"
#include "tb/render/attached_device.h"
#include "tb/render/device_ports.h"
#include "tb/render/effects/fixed.h"

namespace blysk::render {

using channel_rgb = std::array<std::uint8_t, 3>;

/// The device of the list that adds up effects: the one with columns for them.
/// \param has_energy  with the column for an energy factor
/// \throws std::logic_error if there is none
selection choose_effect_units(const std::string& format, bool has_energy = false);

/// \throws std::invalid_argument if the units do not take what a device that shades points puts out
void expect_fitting(const attached_device& units, const selection& shades);

/// Collects points with their lights, runs them, and hands out their colours.
class effect_units {
 public:
  /// By the numbers of points.
  struct results {
    std::span<sum_rgb> sums;          ///< saturated
    std::span<channel_rgb> channels;  ///< the same, rounded
  };

  effect_units(const attached_device& from, results to);

  /// The lights that are added from now on are those of a point.
  /// \param ambient  UQ8.8
  /// \param is_grey  all terms of the point are: green and blue are given zeros, and red's results serve all three
  void begin(std::uint32_t point, const coefficient_rgb& ambient, bool is_grey);

  /// Adds a light to the point.
  /// \param diffuse  UQ8.8
  /// \param cosine   N.L, with the fraction bits of the device that shades
  /// \return         a number for set_specular()
  std::uint32_t add(const coefficient_rgb& diffuse, std::int64_t cosine);

  /// The code of the factor that multiplies the specular terms of a light.
  void set_energy(std::uint32_t light, std::int64_t code) { rows_[light].energy = code; }

  /// The code of a colour output of the device that shades; 0 if it is never set.
  void set_specular(std::uint32_t light, std::size_t channel, std::int64_t code);

  /// Lights that wait.
  std::size_t waiting() const { return rows_.size(); }

  /// Runs them; the last point is whole.
  void run();

  /// Rows that the device has taken.
  std::uint64_t rows() const { return taken_; }
  double seconds() const { return seconds_; }

 private:
  struct row {
    std::uint32_t point;
    bool is_first;  // of its point
    bool is_grey;
    coefficient_rgb ambient, diffuse;
    std::int64_t cosine;
    std::array<std::int64_t, 3> specular;
    std::int64_t energy = 0;
  };

  engine& through_;
  results to_;
  std::vector<row> rows_;
  bool has_light_ = false;  // the row of the point's beginning
  columns inputs_, outputs_;
  bool has_energy_;  // a column of the inputs
  std::uint64_t taken_ = 0;
  double seconds_ = 0;
};

}  // namespace blysk::render
