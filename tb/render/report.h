// SPDX-License-Identifier: Apache-2.0
/// What a rendering did and cost.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tb/render/render.h"

namespace blysk::render {

/// How far a picture is from another, over the 8-bit channels of all pixels.
struct distance {
  std::optional<double> nmse;     ///< [T] (3.1); 0 for equal pictures, none if the reference alone is black
  std::optional<double> psnr_db;  ///< none for equal pictures
  std::size_t pixels_off;         ///< that differ by 3 or more in a channel
  int largest;                    ///< difference of a channel
};
distance distance_of(const picture& reference, const picture& image);

/// What [T] 3.4 says of an NMSE: "no visible difference" up to 1e-4, and so on.
std::string_view verdict(std::optional<double> nmse);

/// What only the caller knows.
struct circumstances {
  std::string scene, engine, shading;
  selection device;
  bool is_corrected;
  unsigned threads;
  double simulated_ns = 0;
  std::uint64_t cycles = 0;
  std::uint64_t delta_cycles = 0;
  std::uint64_t unit_cycles = 0;                   ///< of `cycles`, those of the effect units
  std::optional<std::uint64_t> process_runs = {};  ///< of SystemC, where they were counted
  std::vector<std::string> blocks = {};            ///< SystemC modules that were elaborated
  std::vector<std::string> messages = {};
};

/// What was counted since another picture of the same run.
circumstances since(const circumstances& before, circumstances now);

/// The report as JSON; docs/scenes.md describes the keys.
std::string report_json(const job& asked, const outcome& of, const circumstances& in);

/// Blinn's picture, the device's and their difference side by side, under a line that says what each is.
picture comparison(const outcome& of, const circumstances& in);

/// The same as a table for a terminal.
std::string report_table(const job& asked, const outcome& of, const circumstances& in);

}  // namespace blysk::render
