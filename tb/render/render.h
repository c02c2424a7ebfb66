// SPDX-License-Identifier: Apache-2.0
/// A picture of a scene whose highlights a device computes.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tb/device.h"
#include "tb/render/effect_units.h"
#include "tb/render/picture.h"
#include "tb/render/plan.h"
#include "tb/render/points.h"
#include "tb/render/segments.h"
#include "tb/render/spans.h"

namespace blysk::render {

/// Pixels from the upper left corner.
struct rectangle {
  int x, y, width, height;
};

/// What makes the highlights.
struct device_source {
  selection device;
  /// The engine of a thread, from 0; called when the plan has use for it. A clocked one has one thread.
  std::function<engine*(unsigned thread)> engine_of;
  bool is_clocked = false;
  /// An engine that gives the same numbers, for the table of where a lobe begins.
  std::function<std::unique_ptr<engine>()> make_law;
};

/// The writes of some pixels, through an engine of their own and before all others.
struct watched {
  std::optional<rectangle>
      pixels;       ///< none: of the row through the brightest highlight, three eighths of its width
  engine* through;  ///< null if no device is needed
  std::function<void()> done;  ///< called when they have run
};

struct job {
  const scene::world* of;
  int width = 512, height = 512;
  const shading_method* shading;
  bool is_corrected = true;  ///< perspective correction
  effects asked = effects::automatic;
  bool checks_triangles = true;                ///< the inner specular check, if effects are automatic
  normalisation energy = normalisation::none;  ///< of the specular terms
  unsigned threads = 1;
  const device_source* device;
  lobe_table* lobes = nullptr;             ///< kept from picture to picture; null: made for each
  const attached_device* units = nullptr;  ///< of the effects; null: their laws on the host
  const attached_device* spans =
      nullptr;  ///< of shading gouraud: rows of a triangle's pixels; null: in double on the host
  std::optional<watched> watch = {};
  std::optional<segments> by_segments = {};  ///< rays at the ends of segments in place of a z-buffer
  std::function<void(std::size_t done, std::size_t total)> progress =
      {};  ///< of points; from any thread, one at a time
};

/// Counted and measured.
struct outcome {
  picture image;
  picture reference;  ///< Blinn's model in double, in place of the device
  plan planned;
  std::size_t pixels = 0;               ///< that see the mesh
  std::size_t points = 0;               ///< that were shaded
  std::size_t pixels_in_highlight = 0;  ///< to which a specular term adds
  std::size_t triangles_visible = 0;
  std::size_t triangles_in_highlight = 0;  ///< that have such a pixel
  std::size_t triangles_left_out =
      0;                           ///< in which the inner specular check finds a light without a highlight
  std::size_t tests_left_out = 0;  ///< by it: pixels times lights with a highlight
  std::uint64_t device_writes = 0;
  std::uint64_t watched_writes = 0;  ///< of these, those of watched pixels
  std::uint64_t unit_rows = 0;       ///< lights that the effect units have added; 0 where the host does
  std::uint64_t span_lines =
      0;  ///< rows of triangles that the device for them has drawn; 0 where the host does
  std::optional<segment_counts> by_segments = {};
  std::map<std::string, double> host_s = {};  ///< by phase
};

/// The plan alone.
/// \throws std::invalid_argument as render() does
plan plan_of(const job& asked);

/// \throws std::invalid_argument for a device that does not shade points or does not fit the effect units or an energy factor, and
/// for segments that are watched or not shaded pixel by pixel, and for lines of a method that has no colours at corners
outcome render(const job& asked);

}  // namespace blysk::render
