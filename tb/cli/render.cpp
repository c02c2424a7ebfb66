// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <systemc>
#include <thread>
#include <type_traits>
#include <vector>

#include "tb/cli/animation.h"
#include "tb/cli/engines.h"
#include "tb/cli/verbs.h"
#include "tb/cli/whole_number.h"
#include "tb/device_arguments.h"
#include "tb/harness/process_counter.h"
#include "tb/harness/systemc_engine.h"
#include "tb/output_file.h"
#include "tb/progress.h"
#include "tb/read_number.h"
#include "tb/render/render.h"
#include "tb/render/report.h"
#include "tb/run_program.h"
#include "tb/scene/read_scene.h"
#include "tb/scene/shapes.h"
#include "tb/scene/turn.h"
#include "tb/waves_file.h"

namespace blysk::cli {
namespace {

struct options {
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

/// What the command line says of the scene comes before what its file says.
void apply(const options& asked, scene::world& to) {
  if (!asked.lights.empty()) {
    to.lights.clear();
    std::ranges::transform(asked.lights, std::back_inserter(to.lights), light_of);
  }
  if (!asked.ambient.empty()) to.ambient = colour_of("--ambient", asked.ambient);
  if (!asked.background.empty()) to.background = colour_of("--background", asked.background);
  if (asked.exponent > 0) {
    for (scene::material& each : to.surface.materials) each.n = asked.exponent;
  }
  // CLI::Range takes NaN, which is on no wrong side of a bound.
  if (std::isnan(asked.fov_deg)) throw usage_error("--fov is nan, expected a number in [0.001, 179]");
  if (std::isnan(asked.by_segments.limit))
    throw usage_error("--segment-limit is nan, expected a number in [0, 1000]");
  if (!asked.eye.empty() || !asked.target.empty() || asked.fov_deg > 0) {
    if (!to.view) to.view = scene::fitted_camera(to.surface);
    if (!asked.eye.empty()) to.view->eye = place_of("--eye", asked.eye);
    if (!asked.target.empty()) to.view->target = place_of("--target", asked.target);
    if (asked.fov_deg > 0) to.view->fov_deg = asked.fov_deg;
    scene::check_camera("camera", *to.view);
  }
}

/// Engines of a job, each made when the plan has use for it: SystemC elaborates once, and only what is needed.
class job_engines {
 public:
  job_engines(const engine_choice& choice, const selection& device) : choice_(choice), device_(device) {}

  engine* of_thread(unsigned thread) {
    if (choice_.name == "systemc") return systemc();
    while (made_.size() <= thread) made_.push_back(choice_.make(device_, cosim::waves::off));
    return made_[thread].get();
  }

  harness::systemc_engine* systemc() {
    if (!systemc_) systemc_ = harness::make_systemc(device_);
    return systemc_.get();
  }

  /// Of all that have a clock.
  std::uint64_t cycles() const {
    std::uint64_t sum = systemc_ ? systemc_->cycles() : 0;
    for (const auto& each : made_) {
      if (const auto* clocked = dynamic_cast<const clocked_engine*>(each.get())) sum += clocked->cycles();
    }
    return sum;
  }

 private:
  const engine_choice& choice_;
  const selection& device_;
  std::vector<std::unique_ptr<engine>> made_;
  std::unique_ptr<harness::systemc_engine> systemc_;
};

/// The effect units in hardware, with a count of the cycles of their own runs: in SystemC their clock goes on while the device
/// that makes the highlights runs.
class unit_engine final : public engine {
 public:
  /// \param name  of the engine: systemc or verilator
  unit_engine(const std::string& name, const selection& device)
      : engine(columns(device.of().ports(device), port::role::result).layout()) {
    if (name == "systemc") {
      auto made = harness::make_systemc(device);
      systemc_ = made.get();
      through_ = std::move(made);
    } else {
      through_ = cosim::make_verilator(device);
    }
  }

  harness::systemc_engine* systemc() { return systemc_; }
  std::uint64_t cycles() const { return cycles_; }

 private:
  void compute(const columns& in, columns& out) override {
    const std::uint64_t before = through_->cycles();
    through_->run(in, out);
    cycles_ += through_->cycles() - before;
    // To the end of the cycle, where the other device begins.
    if (systemc_ != nullptr) sc_core::sc_start(sc_core::sc_time(harness::kClockPeriodNs / 2, sc_core::SC_NS));
  }

  std::unique_ptr<clocked_engine> through_;
  harness::systemc_engine* systemc_ = nullptr;
  std::uint64_t cycles_ = 0;
};

/// What --spans asks for; nothing where the host interpolates.
class asked_spans {
 public:
  asked_spans(const options& asked, const std::string& format) {
    if (asked.spans == "host") return;
    const selection device = render::choose_span_device(format);
    if (asked.spans == "bit") {
      model_ = device.of().make_bit(device);
    } else {
      hardware_ = std::make_unique<unit_engine>(asked.spans, device);
    }
    source_ = render::attached_device{device, model_ ? model_.get() : hardware_.get(), asked.spans};
  }

  const render::attached_device* source() const { return source_ ? &*source_ : nullptr; }
  std::uint64_t cycles() const { return hardware_ ? hardware_->cycles() : 0; }

 private:
  std::unique_ptr<engine> model_;
  std::unique_ptr<unit_engine> hardware_;
  std::optional<render::attached_device> source_;
};

/// What --units asks for; nothing where the host adds up the effects.
class asked_units {
 public:
  asked_units(const options& asked, const selection& shades) {
    if (asked.units == "bit") return;
    const selection device = render::choose_effect_units(shades.format(), asked.normalisation != "none");
    render::expect_fitting({device, nullptr, asked.units}, shades);
    engine_ = std::make_unique<unit_engine>(asked.units, device);
    source_ = render::attached_device{device, engine_.get(), asked.units};
  }

  const render::attached_device* source() const { return source_ ? &*source_ : nullptr; }
  harness::systemc_engine* systemc() { return engine_->systemc(); }
  std::uint64_t cycles() const { return engine_ ? engine_->cycles() : 0; }

 private:
  std::unique_ptr<unit_engine> engine_;
  std::optional<render::attached_device> source_;
};

void list_modules(const std::vector<sc_core::sc_object*>& objects, std::vector<std::string>& to) {
  for (const sc_core::sc_object* each : objects) {
    if (dynamic_cast<const sc_core::sc_module*>(each) == nullptr) continue;
    if (!std::string_view(each->name()).starts_with("host")) to.emplace_back(each->name());
    list_modules(each->get_child_objects(), to);
  }
}

bool makes_files(const options& asked) {
  return !asked.output.empty() || !asked.report.empty() || !asked.compare.empty();
}

/// Whether a result goes to standard output, so that nothing else may.
bool takes_stdout(const options& asked) {
  return is_standard_output(asked.output) || is_standard_output(asked.report) ||
         is_standard_output(asked.compare);
}

/// A picture is PNG whatever its name, so the name of another form would lie.
void expect_png(const std::string& path) {
  const std::string ending = scene::ending_of(path);
  for (const std::string_view other : {".jpg", ".jpeg", ".ppm", ".pgm", ".pnm", ".bmp", ".gif", ".tif",
                                       ".tiff", ".tga", ".webp", ".exr", ".hdr", ".svg", ".pdf", ".eps"}) {
    if (ending == other) throw file_error(path, 0, "names another form of picture, expected .png");
  }
}

/// No result replaces a file that was read, nor another result.
/// \param read  files of the scene
void expect_apart(const options& asked, const std::vector<std::string>& read) {
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

void check(const options& asked) {
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
}

/// None: the row through the highlight.
std::optional<render::rectangle> watch_of(const options& asked, const render::job& job) {
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

void set_size(const options& asked, render::job& job) {
  const auto size = numbers_of<int>("--size", asked.size, "WIDTHxHEIGHT, each 1 to 16384", {2}, 'x');
  if (std::ranges::any_of(size, [](int each) { return each < 1 || each > kMostPixels; }))
    throw usage_error(
        fmt::format("--size is {}, expected WIDTHxHEIGHT, each 1 to {}", asked.size, kMostPixels));
  job.width = size[0];
  job.height = size[1];
}

/// Opens the waves of what is watched, or of everything, and closes them when it is done.
class waves {
 public:
  /// \param of  makes the engine, or finds it
  waves(const std::string& path, std::function<harness::systemc_engine*()> of) : of_(std::move(of)) {
    if (path.empty()) return;
    file_.emplace(path);
  }
  void start() {
    if (!file_) return;
    of_()->trace(file_->recorded_path());
    is_running_ = true;
  }
  void stop() {
    if (!is_running_) return;
    is_running_ = false;
    is_whole_ = of_()->stop_trace();
  }
  void commit() {
    if (file_) file_->commit(is_whole_);
  }

 private:
  std::function<harness::systemc_engine*()> of_;
  std::optional<waves_file> file_;
  bool is_running_ = false;
  bool is_whole_ = true;
};

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

/// A member of a scene file that gives an option: where it goes, and what refuses a value that no option has.
struct preset {
  const char* name;
  std::string* place;
  std::function<void()> check;
};

/// What the scene file says where the command line says nothing.
/// \throws usage_error with the file and the member
void take_presets(const CLI::App& verb, const std::map<std::string, std::string>& from, options& to) {
  const std::vector<preset> presets{
      {"size", &to.size,
       [&] {
         render::job unused{};
         set_size(to, unused);
       }},
      {"shading", &to.shading, [&] { render::find_shading(to.shading); }},
      {"perspective", &to.perspective, [&] { is_corrected(to.perspective); }},
      {"engine", &to.engine, [&] { find_engine(to.engine); }},
      {"device", &to.device.device, [&] { find_device(to.device.device); }},
      {"format", &to.device.format, [&] { choose(devices().front()->name(), to.device.format); }},
      {"normalisation", &to.normalisation, [&] { normalisation_of(to.normalisation); }}};
  for (const preset& each : presets) {
    const auto found = from.find(each.name);
    if (found == from.end() || verb.get_option(std::string("--") + each.name)->count() > 0) continue;
    *each.place = found->second;
    try {
      each.check();
    } catch (const std::exception& error) {
      throw file_error(to.scene, 0, fmt::format("{}: {}", each.name, error.what()));
    }
  }
}

/// What the command line says of a picture, its devices apart.
void set_options(const options& asked, render::job& job) {
  set_size(asked, job);
  job.is_corrected = is_corrected(asked.perspective);
  job.asked = asked.effects == "all" ? render::effects::all : render::effects::automatic;
  job.checks_triangles = asked.inner_check == "on";
  job.threads = asked.threads;
  if (asked.renderer != "segments") return;
  job.by_segments = asked.by_segments;
  job.by_segments->measure =
      asked.segment_measure == "rgb" ? render::colour_measure::rgb : render::colour_measure::cie76;
  job.by_segments->inner = inner_colours_of(asked.segment_inner);
  if (!job.shading->is_by_pixel || !asked.watch.empty())
    throw usage_error("renderer segments traces pixels, expected shading phong and no --watch");
}

/// The files that were asked for: opened first, so that none is written if one cannot be.
class result_files {
 public:
  explicit result_files(const options& asked) {
    open(picture_, asked.output);
    open(report_, asked.report);
    open(sheet_, asked.compare);
  }
  void write(const render::job& job, const render::outcome& made, const render::circumstances& in) {
    if (picture_) picture_->write(render::png_of(made.image));
    if (report_) report_->write(render::report_json(job, made, in));
    if (sheet_) sheet_->write(render::png_of(render::comparison(made, in)));
    for (auto* each : {&picture_, &report_, &sheet_}) {
      if (*each) (*each)->close();
    }
  }
  void commit() {
    for (auto* each : {&picture_, &report_, &sheet_}) {
      if (*each) (*each)->commit();
    }
  }

 private:
  static void open(std::optional<output_file>& file, const std::string& path) {
    if (!path.empty()) file.emplace(path);
  }
  std::optional<output_file> picture_, report_, sheet_;
};

/// Renders one picture, with what its user sees of its progress.
render::outcome render_shown(render::job job, const std::string& what) {
  std::optional<progress> shown;
  std::size_t before = 0;
  job.progress = [&](std::size_t done, std::size_t total) {
    if (!shown) shown.emplace(what, total);
    shown->advance(done - before);
    before = done;
  };
  return render::render(job);
}

/// A whole turn of the object, seen by a camera that stays, in the light that stays.
/// \param read  files of the scene
void animate(const options& asked, scene::world& of, const std::vector<std::string>& read,
             const render::job& job, const std::function<render::circumstances()>& around) {
  animation made(asked.frames, asked.output, asked.film);
  for (int frame = 0; frame < made.frames(); ++frame) {
    expect_different_files({"--report", "--output"}, {asked.report, made.path(frame)});
    expect_different_files({"--film", "--output"}, {asked.film, made.path(frame)});
    for (const std::string& each : read)
      expect_different_files({"SCENE", "--output"}, {each, made.path(frame)});
  }
  std::optional<output_file> report;
  if (!asked.report.empty()) report.emplace(asked.report);
  if (!of.view) of.view = scene::fitted_camera(of.surface);
  const scene::vec middle = scene::fitted_camera(of.surface).target;
  const scene::mesh still = of.surface;
  const auto started = std::chrono::steady_clock::now();
  std::uint64_t writes = 0;
  for (int frame = 0; frame < made.frames(); ++frame) {
    const double turn_rad = 2 * golden::pi<double>() * frame / made.frames();
    if (frame > 0) of.surface = scene::turned(still, middle, of.view->up, turn_rad);
    const render::outcome done = render_shown(job, fmt::format("frame {} of {}", frame + 1, made.frames()));
    output_file picture(made.path(frame));
    picture.write(render::png_of(done.image));
    picture.close();
    picture.commit();
    if (report) {
      report->write(frame == 0 ? "[\n" : ",\n");
      report->write(render::report_json(job, done, around()));
    }
    writes += done.device_writes;
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - started;
  if (report) {
    report->write("]\n");
    report->close();
  }
  made.make_film();
  if (report) report->commit();
  fmt::print(takes_stdout(asked) ? stderr : stdout,
             "{} frames of {} x {}: {} device writes, {:.2f} s, {:.1f} frames/s\n", made.frames(), job.width,
             job.height, writes, taken.count(), made.frames() / taken.count());
}

void run(const CLI::App& verb, options asked) {
  const auto started = std::chrono::steady_clock::now();
  scene::read_world read = scene::read_scene(asked.scene, asked.density);
  take_presets(verb, read.options, asked);
  check(asked);
  expect_apart(asked, read.files);
  apply(asked, read.of);
  for (const std::string& each : read.of.messages) say("blysk", fmt::format("{}: {}", asked.scene, each));
  const engine_choice choice = find_engine(asked.engine);
  const selection device = asked.device.choose(choice.serves);
  const render::normalisation energy = normalisation_of(asked.normalisation);
  // What the report says of processes takes time, and is counted for it alone.
  std::optional<harness::process_counter> processes;
  if (!asked.report.empty() && asked.process_runs == "on" &&
      (asked.engine == "systemc" || asked.units == "systemc" || asked.spans == "systemc" ||
       !asked.watch.empty()))
    processes.emplace();
  job_engines engines(choice, device);
  const bool is_clocked = asked.engine == "systemc" || asked.engine == "verilator";
  const render::device_source source{
      device, [&](unsigned thread) { return engines.of_thread(thread); }, is_clocked,
      [&] {
        return choice.serves == purpose::formula ? device.of().make_golden(device)
                                                 : device.of().make_bit(device);
      }};
  asked_units units(asked, device);
  const asked_spans spans(asked, device.format());
  render::job job{.of = &read.of,
                  .shading = &render::find_shading(asked.shading),
                  .device = &source,
                  .units = units.source(),
                  .spans = spans.source()};
  set_options(asked, job);
  job.energy = energy;
  for (const char* option : {"--segment", "--segment-limit", "--segment-measure", "--segment-inner"}) {
    if (asked.renderer != "segments" && verb.count(option) > 0)
      throw usage_error(fmt::format("{} is about segments, expected --renderer segments", option));
  }
  const auto watch = watch_of(asked, job);
  const auto around = [&] {
    render::circumstances in{asked.scene,      asked.engine,
                             asked.shading,    device,
                             job.is_corrected, is_clocked || job.units != nullptr ? 1 : job.threads};
    in.unit_cycles = units.cycles();
    in.cycles = engines.cycles() + in.unit_cycles + spans.cycles();
    in.simulated_ns = static_cast<double>(in.cycles) * harness::kClockPeriodNs;
    in.delta_cycles = in.cycles > 0 ? sc_core::sc_delta_count() : 0;
    if (processes) in.process_runs = processes->runs();
    list_modules(sc_core::sc_get_top_level_objects(), in.blocks);
    in.messages = read.of.messages;
    return in;
  };
  if (asked.explains) {
    const render::plan planned = render::plan_of(job);
    fmt::print(takes_stdout(asked) ? stderr : stdout, "units: {}\n{}\n", fmt::join(planned.units, ", "),
               fmt::join(planned.reasons, "\n"));
    if (!makes_files(asked)) return;
  }
  if (asked.frames > 0) {
    animate(asked, read.of, read.files, job, around);
    return;
  }
  result_files files(asked);
  waves traced(asked.vcd, [&] { return engines.systemc(); });
  waves traced_units(asked.units_vcd, [&] { return units.systemc(); });
  const bool needs_device = render::needs_device(read.of, job.asked);
  if (!needs_device && !asked.vcd.empty())
    throw usage_error("--vcd has nothing to record: the scene calls for no device, see --explain");
  if (needs_device) traced.start();
  traced_units.start();
  if (!asked.watch.empty() && (needs_device || job.units != nullptr)) {
    job.watch = render::watched{watch, needs_device ? engines.systemc() : nullptr, [&] {
                                  traced.stop();
                                  traced_units.stop();
                                }};
  }
  const std::chrono::duration<double> reading = std::chrono::steady_clock::now() - started;
  render::outcome made = render_shown(job, "shading");
  traced.stop();
  traced_units.stop();
  made.host_s["reading"] = reading.count();
  const render::circumstances in = around();
  files.write(job, made, in);
  traced.commit();
  traced_units.commit();
  files.commit();
  fmt::print(takes_stdout(asked) ? stderr : stdout, "{}", render::report_table(job, made, in));
}

}  // namespace

void add_render(CLI::App& program) {
  auto* verb = program.add_subcommand("render", "Make a picture of a scene, its highlights by a device");
  auto asked = std::make_shared<options>();
  std::string shapes;
  for (const scene::shape& each : scene::shapes()) shapes += fmt::format("{} ({}), ", each.name, each.help);
  verb->add_option(
          "scene", asked->scene,
          shapes +
              "or a file: OBJ with MTL, a mesh that assimp reads (3DS, glTF, PLY), or a scene in JSON, see "
              "docs/scenes.md")
      ->required();
  verb->add_option("--output", asked->output, "PNG to write; - for standard output");
  verb->add_option("--report", asked->report,
                   "JSON to write: what was computed, what it cost; - for standard output");
  verb->add_option("--compare", asked->compare,
                   "PNG to write: Blinn's picture, the device's and four times their difference");
  add_device_arguments(*verb, asked->device, purpose::formula);
  std::string engines;
  for (const engine_choice& each : engine_choices())
    engines += fmt::format("{}{}: {}", engines.empty() ? "" : "; ", each.name, each.help);
  verb->add_option("--engine", asked->engine, engines)->capture_default_str();
  verb->add_option(
          "--units", asked->units,
          "what computes ambient and diffuse terms, their sum and saturation; bit: their laws on the "
          "host; systemc, verilator: a device for them, the same picture")
      ->check(CLI::IsMember({"bit", "systemc", "verilator"}))
      ->capture_default_str();
  verb->add_option("--effects", asked->effects,
                   "auto: what the scene calls for; all: every effect for every point")
      ->check(CLI::IsMember({"auto", "all"}))
      ->capture_default_str();
  verb->add_option(
          "--renderer", asked->renderer,
          "z-buffer: every pixel; segments: rays at the ends of segments of rows, the pixels between "
          "them interpolated where the ends are alike")
      ->check(CLI::IsMember({"z-buffer", "segments"}))
      ->capture_default_str();
  verb->add_option("--segment", asked->by_segments.length, "of renderer segments: pixels from end to end")
      ->transform(whole_number(1, kMostPixels))
      ->capture_default_str();
  verb->add_option("--segment-limit", asked->by_segments.limit,
                   "the largest difference of its ends at which a segment is interpolated")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  verb->add_option("--segment-measure", asked->segment_measure,
                   "of that difference; cie76: in CIELAB; rgb: of the codes 0..255")
      ->check(CLI::IsMember({"cie76", "rgb"}))
      ->capture_default_str();
  std::vector<std::string> inner;
  for (const render::named_inner_colours& each : render::kInnerColours) inner.emplace_back(each.name);
  verb->add_option("--segment-inner", asked->segment_inner,
                   "how the pixels between are interpolated; bilinear: in blocks of as many rows as pixels, "
                   "from their four corners; bicubic: from 16 pixels of their grid")
      ->check(CLI::IsMember(inner))
      ->capture_default_str();
  verb->add_option("--inner-check", asked->inner_check,
                   "on: triangles that no highlight can lie in are left out as a whole; off: pixel by pixel")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str();
  verb->add_option("--spans", asked->spans,
                   "of shading gouraud: how the pixels of a triangle's row get their colours; host: in "
                   "double; bit, systemc, "
                   "verilator: a device draws a line between the colours of its ends, dividing by shifts")
      ->check(CLI::IsMember({"host", "bit", "systemc", "verilator"}))
      ->capture_default_str();
  std::string factors;
  for (const render::named_normalisation& each : render::kNormalisations)
    factors += fmt::format("{}{}: {}", factors.empty() ? "" : "; ", each.name, each.formula);
  verb->add_option("--normalisation", asked->normalisation,
                   "energy factor of the specular terms, n the exponent; " + factors)
      ->capture_default_str();
  verb->add_flag("--explain", asked->explains, "print the plan: which effects are computed, and why");
  verb->add_option("--size", asked->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  std::string methods;
  for (const render::shading_method& each : render::shading_methods())
    methods += fmt::format("{}{}: {}", methods.empty() ? "" : "; ", each.name, each.help);
  verb->add_option("--shading", asked->shading, methods)->capture_default_str();
  verb->add_option("--perspective", asked->perspective,
                   "corrected: interpolated on the surface; screen: on the picture")
      ->capture_default_str();
  verb->add_option(
          "--animate", asked->frames,
          "frames of a whole turn of the object, OUTPUT-0001.png and so on; the report has one for each")
      ->transform(whole_number(1, 9999));
  verb->add_option(
          "--process-runs", asked->process_runs,
          "on: the report says how often SystemC's processes ran, which takes time; off: 0 in its place")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str();
  verb->add_option("--film", asked->film,
                   "film to write of them: .mp4 or .webm (by ffmpeg), .gif (by ffmpeg or ImageMagick)");
  verb->add_option("--watch", asked->watch,
                   "X,Y or X,Y,WIDTH,HEIGHT, or highlight, the row through the brightest one: the writes of "
                   "these pixels go through SystemC, before all others");
  verb->add_option("--vcd", asked->vcd, "record the waves of what is watched, or of engine systemc");
  verb->add_option("--units-vcd", asked->units_vcd,
                   "record the waves of --units systemc, of what is watched, or of all points");
  verb->add_option("--light", asked->lights,
                   "X,Y,Z[,R,G,B]: light from that direction; @X,Y,Z[,R,G,B]: at that place; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  verb->add_option("--ambient", asked->ambient, "R,G,B of the light from everywhere, each in [0, 1]");
  verb->add_option("--background", asked->background, "R,G,B, each in [0, 1]");
  verb->add_option("--eye", asked->eye, "X,Y,Z of the camera");
  verb->add_option("--target", asked->target, "X,Y,Z of what it looks at");
  verb->add_option("--fov", asked->fov_deg, "degrees over the shorter side")->check(CLI::Range(0.001, 179.0));
  verb->add_option("--exponent", asked->exponent, "of all materials, in place of their own")
      ->transform(whole_number(1, 1000));
  verb->add_option("--density", asked->density, "of a built-in shape's mesh")
      ->transform(whole_number(scene::kLeastDensity, scene::kMostDensity));
  verb->add_option("--threads", asked->threads, "of the host")
      ->transform(whole_number(1, 256))
      ->capture_default_str();
  for (CLI::Option* each : verb->get_options({})) {
    if (each->get_expected_max() == 1) each->take_last();  // a script's own come first
  }
  verb->footer(
      "Examples:\n"
      "  blysk render teapot --output teapot.png --report teapot.json\n"
      "  blysk render spheres --explain\n"
      "  blysk render sphere --size 64x64 --engine systemc --output sphere.png --vcd sphere.vcd\n"
      "  blysk render torus --size 128x128 --watch 64,40,8,1 --vcd pixels.vcd --output torus.png\n"
      "  blysk render teapot --size 128x128 --animate 8 --output turn.png");
  verb->callback([verb, asked] { run(*verb, *asked); });
}

}  // namespace blysk::cli
