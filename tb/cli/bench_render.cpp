// SPDX-License-Identifier: Apache-2.0
// What a scene costs against what it needs: ratios of renderings of one run, as a table. A program of its own, not a test:
// times depend on the machine.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "tb/run_program.h"

namespace {

using json = nlohmann::json;
namespace fs = std::filesystem;

const fs::path kFolder = fs::temp_directory_path() / fmt::format("blysk bench {}", getpid());

/// The report of the fastest of some renderings.
json rendered(const std::string& arguments, int times = 5) {
  json best;
  double least = 0;
  const std::string report = (kFolder / "r.json").string();
  for (int i = 0; i < times; ++i) {
    const std::string command = fmt::format("'{}' render {} --process-runs off --report '{}' >/dev/null 2>&1",
                                            BLYSK_PROGRAM, arguments, report);
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
    const json now = json::parse(std::ifstream(report));
    const double frames = now["frames_per_second"];
    if (frames > least) {
      least = frames;
      best = now;
    }
  }
  return best;
}

double phase(const json& of, const char* name) {
  return of["host_s"][name];
}
double frame(const json& of) {
  return 1 / of["frames_per_second"].get<double>();
}

std::string write(const std::string& name, const std::string& text) {
  const std::string path = (kFolder / name).string();
  std::ofstream(path) << text;
  return "'" + path + "'";
}

void row(const std::string& what, double value) {
  fmt::print("| {} | {:.3g} |\n", what, value);
}

/// The reports of the fastest of some renderings of either, in turn.
std::pair<json, json> fastest_in_turn(const std::string& first, const std::string& second, int times = 30) {
  std::pair<json, json> best;
  const auto keep_faster = [](const json& now, json& than) {
    if (than.empty() || frame(now) < frame(than)) than = now;
  };
  for (int i = 0; i < times; ++i) {
    keep_faster(rendered(first, 1), best.first);
    keep_faster(rendered(second, 1), best.second);
  }
  return best;
}

void compare_checks(const char* name, const std::string& scene) {
  const auto [on, off] = fastest_in_turn(scene + " --threads 1", scene + " --threads 1 --inner-check off");
  row(fmt::format("inner specular check, {}: shading, on / off", name),
      phase(on, "shading") / phase(off, "shading"));
  row(fmt::format("inner specular check, {}: tests of pixels, on / off", name),
      1 - on["tests_left_out"].get<double>() / on["pixels"].get<double>());
}

void compare_segments(const std::string& scene) {
  const auto [segments, all] =
      fastest_in_turn(scene + " --threads 1 --renderer segments", scene + " --threads 1");
  row(fmt::format("segments / z-buffer, {}: visibility, shading and device", scene),
      frame(segments) / frame(all));
}

void bench() {
  const std::string systemc = " --engine systemc --threads 1 ";
  fmt::print("| sphere, 512 x 512, one thread | ratio |\n|---|---|\n");
  for (const int n : {10, 50, 200, 1000}) {
    const std::string scene = fmt::format("sphere --exponent {}", n) + systemc;
    const json few = rendered(scene);
    const json all = rendered(scene + "--effects all", 2);
    row(fmt::format("n = {}: device writes / pixels in a highlight", n),
        few["device_writes"].get<double>() / few["pixels_in_highlight"].get<double>());
    row(fmt::format("n = {}: device writes, all / auto", n),
        all["device_writes"].get<double>() / few["device_writes"].get<double>());
    row(fmt::format("n = {}: time in SystemC, auto / all", n), phase(few, "device") / phase(all, "device"));
    row(fmt::format("n = {}: time of the frame, auto / all", n), frame(few) / frame(all));
  }
  const json full = rendered("sphere" + systemc + "--effects all", 2);
  const std::string ambient = write("ambient.json", R"({"mesh": "sphere", "lights": []})") + systemc;
  const std::string diffuse =
      write("diffuse.json", R"({"mesh": "sphere", "materials": {"*": {"ks": [0, 0, 0]}}})") + systemc;
  const std::string grey =
      write("grey.json", R"({"mesh": "sphere", "materials": {"*": {"ks": [0.75, 0.75, 0.75]}}})") + systemc;
  const json dark = rendered(ambient);
  row("ambient alone: time of shading and device / all effects",
      (phase(dark, "shading") + phase(dark, "device")) / (phase(full, "shading") + phase(full, "device")));
  row("ambient alone: time of the frame / all effects", frame(dark) / frame(full));
  row("diffuse alone: SystemC modules elaborated",
      static_cast<double>(rendered(diffuse, 1)["blocks"].size()));
  const std::string large = " --size 1024x1024 --exponent 10";
  row("coloured / grey, 1024 x 1024, n = 10, time in SystemC",
      phase(rendered("sphere" + systemc + large), "device") / phase(rendered(grey + large), "device"));
  const std::string units = systemc + "--units systemc --size 256x256 --exponent 10";
  const std::string all_grey = write(
      "all_grey.json",
      R"({"mesh": "sphere", "materials": {"*": {"ka": [0.5, 0.5, 0.5], "kd": [0.5, 0.5, 0.5], "ks": [0.75, 0.75, 0.75]}}})");
  const auto [in_colours, in_grey] = fastest_in_turn("sphere" + units, all_grey + units, 5);
  row("coloured / grey scene, 256 x 256, n = 10, time in SystemC with the effect units",
      (phase(in_colours, "device") + phase(in_colours, "units")) /
          (phase(in_grey, "device") + phase(in_grey, "units")));
  const json bit = rendered("sphere --threads 1", 9);
  row("engine bit: visibility, shading and device / visibility and reference with std::pow",
      frame(bit) / (phase(bit, "visibility") + phase(bit, "reference")));
  row("engine bit: shading / reference", phase(bit, "shading") / phase(bit, "reference"));
  row("engine bit: device / reference", phase(bit, "device") / phase(bit, "reference"));
  const std::string shiny =
      write("shiny.json", R"({"mesh": "sphere", "materials": {"*": {"kd": [0, 0, 0]}}})");
  compare_checks("sphere", "sphere");
  compare_checks("teapot, 1024 x 1024", "teapot --size 1024x1024");
  compare_checks("torus, 1024 x 1024", "torus --size 1024x1024");
  compare_checks("sphere without diffuse light", shiny);
  compare_segments("sphere");
  compare_segments("teapot");
  const json small = rendered("sphere --threads 1 --size 256x256");
  row("four times the pixels: shading", phase(bit, "shading") / phase(small, "shading"));
  row("four times the triangles: visibility",
      phase(rendered("sphere --threads 1 --density 128"), "visibility") / phase(bit, "visibility"));
}

}  // namespace

int main() {
  return blysk::run_program("bench_render", [] {
    fs::create_directory(kFolder);
    bench();
    fs::remove_all(kFolder);
    return 0;
  });
}
