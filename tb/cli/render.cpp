// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <systemc>
#include <vector>

#include "tb/cli/animation.h"
#include "tb/cli/engines.h"
#include "tb/cli/render_engines.h"
#include "tb/cli/render_options.h"
#include "tb/cli/verbs.h"
#include "tb/harness/process_counter.h"
#include "tb/harness/systemc_engine.h"
#include "tb/output_file.h"
#include "tb/progress.h"
#include "tb/render/render.h"
#include "tb/render/report.h"
#include "tb/run_program.h"
#include "tb/scene/read_scene.h"
#include "tb/scene/turn.h"
#include "tb/waves_file.h"

namespace blysk::cli {
namespace {

void list_modules(const std::vector<sc_core::sc_object*>& objects, std::vector<std::string>& to) {
  for (const sc_core::sc_object* each : objects) {
    if (dynamic_cast<const sc_core::sc_module*>(each) == nullptr) continue;
    if (!std::string_view(each->name()).starts_with("host")) to.emplace_back(each->name());
    list_modules(each->get_child_objects(), to);
  }
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

/// The files that were asked for: opened first, so that none is written if one cannot be.
class result_files {
 public:
  explicit result_files(const render_options& asked) {
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
void animate(const render_options& asked, scene::world& of, const std::vector<std::string>& read,
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
    const render::circumstances before = around();
    if (frame > 0) of.surface = scene::turned(still, middle, of.view->up, turn_rad);
    const render::outcome done = render_shown(job, fmt::format("frame {} of {}", frame + 1, made.frames()));
    output_file picture(made.path(frame));
    picture.write(render::png_of(done.image));
    picture.close();
    picture.commit();
    if (report) {
      report->write(frame == 0 ? "[\n" : ",\n");
      report->write(render::report_json(job, done, render::since(before, around())));
    }
    writes += done.device_writes;
  }
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - started;
  if (report) {
    report->write("]\n");
    report->close();
    report->commit();  // it is there whatever becomes of the film
  }
  made.make_film();
  fmt::print(takes_stdout(asked) ? stderr : stdout,
             "{} frames of {} x {}: {} device writes, {:.2f} s, {:.1f} frames/s\n", made.frames(), job.width,
             job.height, writes, taken.count(), made.frames() / taken.count());
}

void run(const CLI::App& verb, render_options asked) {
  const auto started = std::chrono::steady_clock::now();
  scene::read_world read = scene::read_scene(asked.scene, asked.density);
  take_presets(verb, read.options, asked);
  expect_sound(verb, asked);
  expect_apart(asked, read.files);
  apply(asked, read.of);
  for (const std::string& each : read.of.messages) say("blysk", fmt::format("{}: {}", asked.scene, each));
  const engine_choice choice = find_engine(asked.engine);
  const selection device = asked.device.choose(choice.serves);
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
  asked_units units(asked.units, asked.normalisation != "none", device);
  const asked_spans spans(asked.spans, device.format());
  render::job job{.of = &read.of,
                  .shading = &render::find_shading(asked.shading),
                  .device = &source,
                  .units = units.source(),
                  .spans = spans.source()};
  set_options(asked, job);
  std::unique_ptr<engine> law;
  std::optional<render::lobe_table> lobes;
  if (job.asked == render::effects::automatic && render::needs_device(read.of, job.asked)) {
    law = source.make_law();
    job.lobes = &lobes.emplace(device, *law);
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
  if (!asked.watch.empty() && made.watched_writes == 0)
    say("blysk", "--watch: no watched pixel is in a highlight, so the device has no write of them");
  else if (!asked.vcd.empty() && made.device_writes == 0)
    say("blysk", "--vcd: no pixel is in a highlight, so the device has no write");
  if (!asked.units_vcd.empty() && made.unit_rows == 0)
    say("blysk", "--units-vcd: no pixel sees the mesh, so the units have no row");
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
  auto asked = std::make_shared<render_options>();
  add_render_options(*verb, *asked);
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
