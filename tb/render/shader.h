// SPDX-License-Identifier: Apache-2.0
/// The effects of a plan on points: ambient and diffuse terms at once, specular ones by writes to a device.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tb/engine.h"
#include "tb/render/effect_units.h"
#include "tb/render/incidence.h"
#include "tb/render/plan.h"
#include "tb/render/points.h"

namespace blysk::render {

class shader {
 public:
  /// What is computed for each point of a point_source, by its index.
  struct results {
    std::span<sum_rgb> sums;               ///< 16 fraction bits
    std::span<channel_rgb> channels;       ///< by the effect units; empty where the host adds up
    std::span<std::uint8_t> in_highlight;  ///< 1 where a specular term is not 0
  };

  /// The arguments outlive the shader.
  /// \param device  null if the plan has no specular effect
  /// \param units   null: their laws on the host
  shader(const std::vector<scene::light>& lights, const vec& eye, const plan& planned,
         const device_ports& ports, engine* device, const attached_device* units, results to);

  /// Whether any light does anything on a material; if not, its points are add_unlit().
  /// \param dark  lights that have no highlight at the point
  bool is_lit(std::uint32_t material, light_set dark) const {
    return has_diffuse_[material] || (specular_[material] & ~dark) != 0;
  }

  void add(std::uint32_t index, const point& at, light_set dark);
  void add_unlit(std::uint32_t index, std::uint32_t material);

  /// Runs the writes and the lights that wait; after the last point.
  void flush();

  std::uint64_t writes() const { return writes_; }
  double device_s() const { return device_s_; }
  std::uint64_t unit_rows() const { return units_ ? units_->rows() : 0; }
  double units_s() const { return units_ ? units_->seconds() : 0; }

 private:
  struct write {
    std::uint32_t point;
    std::uint32_t slot;  // of plan::of_lights
    std::uint32_t cosine;
    std::uint32_t light;  // of the effect units
    bool is_lit;
  };
  static constexpr std::size_t kBatch = 16384;

  void begin(std::uint32_t index, std::uint32_t material);
  void flush_if_full();
  void run_writes();
  void run(std::span<const write> batch);

  const std::vector<scene::light>& lights_;
  const vec& eye_;
  const plan& plan_;
  const device_ports& ports_;
  engine* device_;
  results to_;
  std::optional<effect_units> units_;
  std::vector<bool> has_diffuse_;    // of materials
  std::vector<light_set> specular_;  // of materials
  std::vector<write> waiting_;
  columns inputs_, outputs_;
  std::uint64_t writes_ = 0;
  double device_s_ = 0;
};

}  // namespace blysk::render
