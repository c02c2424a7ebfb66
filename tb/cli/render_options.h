// SPDX-License-Identifier: Apache-2.0
/// What `blysk render` is asked for.
#pragma once

#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tb/device_arguments.h"
#include "tb/render/render.h"
#include "tb/scene/read_scene.h"

namespace blysk::cli {

struct render_options {
  asked_device device;
  std::string scene, output, report, vcd, compare, units_vcd;
  std::string engine = "bit";
  std::string units = "bit";
  std::string effects = "auto";
  std::string size = "512x512";
  std::string shading = "phong";
  std::string perspective = "corrected";
  std::string inner_check = "on";
  std::string normalisation = "none";
  std::string spans = "host";
  std::string process_runs = "on";
  std::string renderer = "z-buffer";
  std::string segment_measure = "cie76";
  std::string segment_inner = "mean";
  render::segments by_segments;
  std::string watch, eye, target, background, ambient, film;
  std::vector<std::string> lights;
  int density = 0;
  int exponent = 0;
  int frames = 0;
  double fov_deg = 0;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  bool explains = false;
};

/// Adds them to the command line.
/// \param to  outlives it
void add_render_options(CLI::App& verb, render_options& to);

/// What the scene file says where the command line says nothing.
/// \throws usage_error with the file, the line and the member
void take_presets(const CLI::App& verb, const std::map<std::string, scene::given_option>& from,
                  render_options& to);

/// Options that do not go together, and results of which the name tells that they are of another form.
/// \throws usage_error
void expect_sound(const CLI::App& verb, const render_options& asked);

/// No result replaces a file that was read, nor another result.
/// \param read  files of the scene
/// \throws usage_error
void expect_apart(const render_options& asked, const std::vector<std::string>& read);

/// Whether there is a picture or a report to make.
bool makes_files(const render_options& asked);

/// Whether a result goes to standard output, so that nothing else may.
bool takes_stdout(const render_options& asked);

/// What the command line says of the scene comes before what its file says.
/// \throws usage_error
void apply(const render_options& asked, scene::world& to);

/// What the command line says of a picture, its devices apart.
/// \throws usage_error
void set_options(const render_options& asked, render::job& job);

/// The pixels of --watch; none: the row through the highlight.
/// \throws usage_error if they are not in the picture
std::optional<render::rectangle> watch_of(const render_options& asked, const render::job& job);

}  // namespace blysk::cli
