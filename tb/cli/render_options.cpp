// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/render_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <string_view>
#include <type_traits>
#include <utility>

#include "tb/cli/engines.h"
#include "tb/cli/numbers.h"
#include "tb/formats_of_build.h"
#include "tb/output_file.h"
#include "tb/read_number.h"
#include "tb/run_program.h"
#include "tb/scene/read_scene.h"
#include "tb/scene/shapes.h"
#include "tb/usage_error.h"

namespace blysk::cli {
namespace {

constexpr int kMostPixels = 1 << 14;  // of a side

/// Numbers of a text, separated by commas or by another character.
template <class Number>
std::vector<Number> numbers_of(const std::string& option, const std::string& text, const char* form,
                               char separator = ',') {
  std::vector<Number> numbers;
  const char* next = text.data();
  const char* const end = text.data() + text.size();
  while (true) {
    const char* const behind = std::find(next, end, separator);
    const std::string_view word(next, behind);
    if constexpr (std::is_floating_point_v<Number>) {
      const std::optional<double> value = read_real(word);
      if (!value) break;
      numbers.push_back(*value);
    } else {
      Number value{};
      const auto [stop, error] = std::from_chars(next, behind, value);
      if (error != std::errc{} || stop != behind) break;
      numbers.push_back(value);
    }
    if (behind == end) return numbers;
    next = behind + 1;
  }
  throw usage_error(fmt::format("{} is '{}', expected {}", option, printable(text), form));
}

template <class Number>
std::vector<Number> numbers_of(const std::string& option, const std::string& text, const char* form,
                               std::initializer_list<std::size_t> counts, char separator = ',') {
  auto numbers = numbers_of<Number>(option, text, form, separator);
  if (std::ranges::find(counts, numbers.size()) == counts.end())
    throw usage_error(fmt::format("{} is '{}', expected {}", option, printable(text), form));
  return numbers;
}

scene::vec place_of(const std::string& option, const std::string& text) {
  const auto at = numbers_of<double>(option, text, "X,Y,Z", {3});
  for (const double each : at) {
    if (!(std::abs(each) <= scene::mesh::kLargest))
      throw usage_error(fmt::format("{} has {}, expected at most {}", option, each, scene::mesh::kLargest));
  }
  return {at[0], at[1], at[2]};
}

scene::rgb colour_of(const std::string& option, const std::string& text) {
  const auto colour = numbers_of<double>(option, text, "R,G,B, each in [0, 1]", {3});
  if (!std::ranges::all_of(colour, [](double each) { return each >= 0 && each <= 1; }))
    throw usage_error(fmt::format("{} is '{}', expected R,G,B, each in [0, 1]", option, text));
  return {colour[0], colour[1], colour[2]};
}

/// "X,Y,Z" or "X,Y,Z,R,G,B": a direction; "@X,Y,Z": a place.
scene::light light_of(const std::string& text) {
  scene::light made;
  made.is_point = text.starts_with('@');
  const std::string numbers = text.substr(made.is_point ? 1 : 0);
  const auto values =
      numbers_of<double>("--light", numbers, "X,Y,Z or X,Y,Z,R,G,B, with @ before it a place", {3, 6});
  const std::size_t split = numbers.find(',', numbers.find(',', numbers.find(',') + 1) + 1);
  made.at = place_of("--light", numbers.substr(0, split));
  if (values.size() == 6) made.colour = colour_of("--light", numbers.substr(split + 1));
  const scene::vec towards = golden::normalised(made.at);
  if (!made.is_point && golden::dot(towards, towards) == 0)
    throw usage_error("--light is 0,0,0, expected a direction");
  return made;
}

void set_size(const render_options& asked, render::job& job) {
  const auto size = numbers_of<int>("--size", asked.size, "WIDTHxHEIGHT, each 1 to 16384", {2}, 'x');
  if (std::ranges::any_of(size, [](int each) { return each < 1 || each > kMostPixels; }))
    throw usage_error(
        fmt::format("--size is {}, expected WIDTHxHEIGHT, each 1 to {}", asked.size, kMostPixels));
  job.width = size[0];
  job.height = size[1];
}

render::normalisation normalisation_of(const std::string& name) {
  std::vector<std::string_view> names;
  for (const render::named_normalisation& each : render::kNormalisations) {
    if (each.name == name) return each.is;
    names.push_back(each.name);
  }
  throw usage_error(
      fmt::format("normalisation {} does not exist, expected {}", printable(name), fmt::join(names, ", ")));
}

render::inner_colours inner_colours_of(const std::string& name) {
  for (const render::named_inner_colours& each : render::kInnerColours) {
    if (each.name == name) return each.are;
  }
  throw usage_error(fmt::format("inner colours {} do not exist", printable(name)));
}

bool is_corrected(const std::string& perspective) {
  if (perspective == "corrected") return true;
  if (perspective == "screen") return false;
  throw usage_error(fmt::format("perspective {} does not exist, expected corrected or screen", perspective));
}

/// \throws std::invalid_argument for a device that does not exist or shades no point
void expect_shading(const std::string& device) {
  const auto format = std::ranges::find_if(format_names, is_in_build);
  render::device_ports unused(choose(device, std::string(*format)));
}

bool shades_points(const device& of) {
  try {
    expect_shading(of.name());
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

/// A member of a scene file that gives an option: where it goes, and what refuses a value that no option has.
struct preset {
  const char* name;
  std::string* place;
  std::function<void()> check;
};

/// A picture is PNG whatever its name, so the name of another form would lie.
void expect_png(const std::string& path) {
  const std::string ending = scene::ending_of(path);
  for (const std::string_view other : {".jpg", ".jpeg", ".ppm", ".pgm", ".pnm", ".bmp", ".gif", ".tif",
                                       ".tiff", ".tga", ".webp", ".exr", ".hdr", ".svg", ".pdf", ".eps"}) {
    if (ending == other) throw file_error(path, 0, "names another form of picture, expected .png");
  }
}

}  // namespace

void add_render_options(CLI::App& verb, render_options& to) {
  std::string shapes;
  for (const scene::shape& each : scene::shapes()) shapes += fmt::format("{} ({}), ", each.name, each.help);
  verb.add_option(
          "scene", to.scene,
          shapes +
              "or a file: OBJ with MTL, a mesh that assimp reads (3DS, glTF, PLY), or a scene in JSON, see "
              "docs/scenes.md")
      ->required();
  verb.add_option("--output", to.output, "PNG to write; - for standard output");
  verb.add_option("--report", to.report,
                  "JSON to write: what was computed, what it cost; - for standard output");
  verb.add_option("--compare", to.compare,
                  "PNG to write: Blinn's picture, the device's and four times their difference");
  add_device_arguments(verb, to.device, purpose::formula, shades_points);
  std::string engines;
  for (const engine_choice& each : engine_choices())
    engines += fmt::format("{}{}: {}", engines.empty() ? "" : "; ", each.name, each.help);
  verb.add_option("--engine", to.engine, engines)->capture_default_str();
  verb.add_option("--units", to.units,
                  "what computes ambient and diffuse terms, their sum and saturation; bit: their laws on the "
                  "host; systemc, verilator: a device for them, the same picture")
      ->check(CLI::IsMember({"bit", "systemc", "verilator"}))
      ->capture_default_str();
  verb.add_option("--effects", to.effects,
                  "auto: what the scene calls for; all: every effect for every point")
      ->check(CLI::IsMember({"auto", "all"}))
      ->capture_default_str();
  verb.add_option("--renderer", to.renderer,
                  "z-buffer: every pixel; segments: rays at the ends of segments of rows, the pixels between "
                  "them interpolated where the ends are alike")
      ->check(CLI::IsMember({"z-buffer", "segments"}))
      ->capture_default_str();
  verb.add_option("--segment", to.by_segments.length, "of renderer segments: pixels from end to end")
      ->transform(whole_number(1, kMostPixels))
      ->capture_default_str();
  verb.add_option("--segment-limit", to.by_segments.limit,
                  "the largest difference of its ends at which a segment is interpolated")
      ->transform(real_number(0, 1000))
      ->capture_default_str();
  verb.add_option("--segment-measure", to.segment_measure,
                  "of that difference; cie76: in CIELAB; rgb: of the codes 0..255")
      ->check(CLI::IsMember({"cie76", "rgb"}))
      ->capture_default_str();
  std::vector<std::string> inner;
  for (const render::named_inner_colours& each : render::kInnerColours) inner.emplace_back(each.name);
  verb.add_option("--segment-inner", to.segment_inner,
                  "how the pixels between are interpolated; bilinear: in blocks of as many rows as pixels, "
                  "from their four corners; bicubic: from 16 pixels of their grid")
      ->check(CLI::IsMember(inner))
      ->capture_default_str();
  verb.add_option("--inner-check", to.inner_check,
                  "on: triangles that no highlight can lie in are left out as a whole; off: pixel by pixel")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str();
  verb.add_option("--spans", to.spans,
                  "of shading gouraud: how the pixels of a triangle's row get their colours; host: in "
                  "double; bit, systemc, "
                  "verilator: a device draws a line between the colours of its ends, dividing by shifts")
      ->check(CLI::IsMember({"host", "bit", "systemc", "verilator"}))
      ->capture_default_str();
  std::string factors;
  for (const render::named_normalisation& each : render::kNormalisations)
    factors += fmt::format("{}{}: {}", factors.empty() ? "" : "; ", each.name, each.formula);
  verb.add_option("--normalisation", to.normalisation,
                  "energy factor of the specular terms, n the exponent; " + factors)
      ->capture_default_str();
  verb.add_flag("--explain", to.explains, "print the plan: which effects are computed, and why");
  verb.add_option("--size", to.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  std::string methods;
  for (const render::shading_method& each : render::shading_methods())
    methods += fmt::format("{}{}: {}", methods.empty() ? "" : "; ", each.name, each.help);
  verb.add_option("--shading", to.shading, methods)->capture_default_str();
  verb.add_option("--perspective", to.perspective,
                  "corrected: interpolated on the surface; screen: on the picture")
      ->capture_default_str();
  verb.add_option(
          "--animate", to.frames,
          "frames of a whole turn of the object, OUTPUT-0001.png and so on; the report has one for each")
      ->transform(whole_number(1, 9999));
  verb.add_option(
          "--process-runs", to.process_runs,
          "on: the report says how often SystemC's processes ran, which takes time; off: 0 in its place")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str();
  verb.add_option("--film", to.film,
                  "film to write of them: .mp4 or .webm (by ffmpeg), .gif (by ffmpeg or ImageMagick)");
  verb.add_option("--watch", to.watch,
                  "X,Y or X,Y,WIDTH,HEIGHT, or highlight, the row through the brightest one: the writes of "
                  "these pixels go through SystemC, before all others");
  verb.add_option("--vcd", to.vcd, "record the waves of what is watched, or of engine systemc");
  verb.add_option("--units-vcd", to.units_vcd,
                  "record the waves of --units systemc, of what is watched, or of all points");
  verb.add_option("--light", to.lights,
                  "X,Y,Z[,R,G,B]: light from that direction; @X,Y,Z[,R,G,B]: at that place; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  verb.add_option("--ambient", to.ambient, "R,G,B of the light from everywhere, each in [0, 1]");
  verb.add_option("--background", to.background, "R,G,B, each in [0, 1]");
  verb.add_option("--eye", to.eye, "X,Y,Z of the camera");
  verb.add_option("--target", to.target, "X,Y,Z of what it looks at");
  verb.add_option("--fov", to.fov_deg, "degrees over the shorter side")->transform(real_number(0.001, 179));
  verb.add_option("--exponent", to.exponent, "of all materials, in place of their own")
      ->transform(whole_number(1, 1000));
  verb.add_option("--density", to.density, "of a built-in shape's mesh")
      ->transform(whole_number(scene::kLeastDensity, scene::kMostDensity));
  verb.add_option("--threads", to.threads, "of the host")
      ->transform(whole_number(1, 256))
      ->capture_default_str();
  for (CLI::Option* each : verb.get_options({})) {
    if (each->get_expected_max() == 1) each->take_last();  // a script's own come first
  }
}

void take_presets(const CLI::App& verb, const std::map<std::string, scene::given_option>& from,
                  render_options& to) {
  const std::vector<preset> presets{
      {"size", &to.size,
       [&] {
         render::job unused{};
         set_size(to, unused);
       }},
      {"shading", &to.shading, [&] { render::find_shading(to.shading); }},
      {"perspective", &to.perspective, [&] { is_corrected(to.perspective); }},
      {"engine", &to.engine, [&] { find_engine(to.engine); }},
      {"device", &to.device.device, [&] { expect_shading(to.device.device); }},
      {"format", &to.device.format, [&] { choose(devices().front()->name(), to.device.format); }},
      {"normalisation", &to.normalisation, [&] { normalisation_of(to.normalisation); }}};
  for (const preset& each : presets) {
    const auto found = from.find(each.name);
    if (found == from.end()) continue;
    const std::string asked = std::exchange(*each.place, found->second.text);
    try {
      each.check();
    } catch (const std::exception& error) {
      throw file_error(to.scene, found->second.line, fmt::format("{}: {}", each.name, error.what()));
    }
    if (verb.get_option(std::string("--") + each.name)->count() > 0) *each.place = asked;
  }
}

void expect_sound(const CLI::App& verb, const render_options& asked) {
  if (asked.frames == 0) expect_png(asked.output);
  expect_png(asked.compare);
  if (asked.frames > 0 && !(asked.watch.empty() && asked.vcd.empty() && asked.compare.empty()))
    throw usage_error(
        "--animate goes with --output, --film and --report, expected no --watch, --vcd or --compare");
  if (asked.frames > 0 && !asked.units_vcd.empty())
    throw usage_error("--animate goes with --output, --film and --report, expected no --units-vcd");
  if (asked.frames == 0 && !asked.film.empty())
    throw usage_error("--film is made of frames, expected --animate N");
  if (!makes_files(asked) && !asked.explains)
    throw usage_error("nothing to do, expected --output, --report, --compare or --explain");
  if (!makes_files(asked)) {
    const std::pair<const char*, bool> of_pictures[]{{"--animate", asked.frames > 0},
                                                     {"--vcd", !asked.vcd.empty()},
                                                     {"--units-vcd", !asked.units_vcd.empty()},
                                                     {"--watch", !asked.watch.empty()}};
    for (const auto& [name, is_given] : of_pictures) {
      if (is_given)
        throw usage_error(fmt::format("{} is of a picture, expected {} with it", name,
                                      asked.frames > 0 ? "--output" : "--output, --report or --compare"));
    }
  }
  if (!asked.vcd.empty() && asked.watch.empty() && asked.engine != "systemc") {
    throw usage_error(fmt::format(
        "--vcd records signals and engine {} has none, expected --watch or engine systemc", asked.engine));
  }
  if (!asked.units_vcd.empty() && asked.units != "systemc")
    throw usage_error(fmt::format(
        "--units-vcd records signals in SystemC, and the effect units run in {}, expected --units "
        "systemc",
        asked.units));
  if (asked.units != "bit" && asked.engine == "golden")
    throw usage_error(
        fmt::format("--units {} takes what hardware puts out, and engine golden has none, expected bit, "
                    "systemc or verilator",
                    asked.units));
  if (!asked.watch.empty() && asked.engine == "golden")
    throw usage_error(
        "--watch runs SystemC among other writes, expected an engine of the same numbers: bit, systemc, "
        "verilator");
  for (const char* option : {"--segment", "--segment-limit", "--segment-measure", "--segment-inner"}) {
    if (asked.renderer != "segments" && verb.count(option) > 0)
      throw usage_error(fmt::format("{} is about segments, expected --renderer segments", option));
  }
}

void expect_apart(const render_options& asked, const std::vector<std::string>& read) {
  const std::vector<std::string> options{"--output",    "--report",  "--vcd",
                                         "--units-vcd", "--compare", "--film"};
  const std::vector<std::string> results{asked.output,    asked.report,  asked.vcd,
                                         asked.units_vcd, asked.compare, asked.film};
  expect_different_files(options, results);
  for (const std::string& each : read) {
    for (std::size_t i = 0; i < results.size(); ++i)
      expect_different_files({"SCENE", options[i]}, {each, results[i]});
  }
}

bool makes_files(const render_options& asked) {
  return !asked.output.empty() || !asked.report.empty() || !asked.compare.empty();
}

bool takes_stdout(const render_options& asked) {
  return is_standard_output(asked.output) || is_standard_output(asked.report) ||
         is_standard_output(asked.compare);
}

void apply(const render_options& asked, scene::world& to) {
  if (!asked.lights.empty()) {
    to.lights.clear();
    std::ranges::transform(asked.lights, std::back_inserter(to.lights), light_of);
  }
  if (!asked.ambient.empty()) to.ambient = colour_of("--ambient", asked.ambient);
  if (!asked.background.empty()) to.background = colour_of("--background", asked.background);
  if (asked.exponent > 0) {
    for (scene::material& each : to.surface.materials) each.n = asked.exponent;
  }
  if (!asked.eye.empty() || !asked.target.empty() || asked.fov_deg > 0) {
    if (!to.view) to.view = scene::fitted_camera(to.surface);
    if (!asked.eye.empty()) to.view->eye = place_of("--eye", asked.eye);
    if (!asked.target.empty()) to.view->target = place_of("--target", asked.target);
    if (asked.fov_deg > 0) to.view->fov_deg = asked.fov_deg;
    scene::check_camera("camera", *to.view);
  }
}

void set_options(const render_options& asked, render::job& job) {
  set_size(asked, job);
  job.is_corrected = is_corrected(asked.perspective);
  job.asked = asked.effects == "all" ? render::effects::all : render::effects::automatic;
  job.checks_triangles = asked.inner_check == "on";
  job.energy = normalisation_of(asked.normalisation);
  job.threads = asked.threads;
  if (asked.renderer != "segments") return;
  job.by_segments = asked.by_segments;
  job.by_segments->measure =
      asked.segment_measure == "rgb" ? render::colour_measure::rgb : render::colour_measure::cie76;
  job.by_segments->inner = inner_colours_of(asked.segment_inner);
  if (!job.shading->is_by_pixel || !asked.watch.empty())
    throw usage_error("renderer segments traces pixels, expected shading phong and no --watch");
}

std::optional<render::rectangle> watch_of(const render_options& asked, const render::job& job) {
  if (asked.watch.empty() || asked.watch == "highlight") return {};
  const auto at =
      numbers_of<int>("--watch", asked.watch, "highlight, X,Y or X,Y,WIDTH,HEIGHT in pixels", {2, 4});
  const render::rectangle pixels{at[0], at[1], at.size() == 4 ? at[2] : 1, at.size() == 4 ? at[3] : 1};
  const bool is_inside = pixels.x >= 0 && pixels.y >= 0 && pixels.width >= 1 && pixels.height >= 1 &&
                         pixels.width <= job.width - pixels.x && pixels.height <= job.height - pixels.y;
  if (!is_inside)
    throw usage_error(fmt::format("--watch is {}, expected pixels of a picture of {} x {}", asked.watch,
                                  job.width, job.height));
  return pixels;
}

}  // namespace blysk::cli
