// SPDX-License-Identifier: Apache-2.0
#include "tb/render/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "tb/render/text.h"

namespace blysk::render {
namespace {

/// Of everything but reading the scene, the reference and writing the files.
double frame_s(const outcome& of) {
  double sum = 0;
  for (const char* phase : {"plan", "visibility", "shading", "device", "units", "lines"}) {
    if (const auto found = of.host_s.find(phase); found != of.host_s.end()) sum += found->second;
  }
  return sum;
}

const named_normalisation& find(normalisation which) {
  return *std::ranges::find(kNormalisations, which, &named_normalisation::is);
}

}  // namespace

distance distance_of(const picture& reference, const picture& image) {
  double difference = 0;
  double energy = 0;
  distance found{0, {}, 0, 0};
  for (std::size_t pixel = 0; pixel < reference.rgb.size(); pixel += 3) {
    int largest = 0;
    for (std::size_t i = pixel; i < pixel + 3; ++i) {
      const int off = std::abs(reference.rgb[i] - image.rgb[i]);
      largest = std::max(largest, off);
      difference += off * off;
      energy += reference.rgb[i] * reference.rgb[i];
    }
    found.pixels_off += largest >= 3 ? 1 : 0;
    found.largest = std::max(found.largest, largest);
  }
  if (difference > 0) {
    found.nmse = energy > 0 ? std::optional(difference / energy) : std::nullopt;
    found.psnr_db = 10 * std::log10(255.0 * 255.0 * static_cast<double>(reference.rgb.size()) / difference);
  }
  return found;
}

std::string_view verdict(std::optional<double> measured) {
  if (!measured) return "undefined, the reference is black";
  const double nmse = *measured;
  if (nmse <= 1e-4) return "no visible difference";
  if (nmse <= 2.5e-4) return "slight difference";
  if (nmse <= 1e-3) return "visible difference";
  return "strong difference";
}

circumstances since(const circumstances& before, circumstances now) {
  now.simulated_ns -= before.simulated_ns;
  now.cycles -= before.cycles;
  now.delta_cycles -= before.delta_cycles;
  now.unit_cycles -= before.unit_cycles;
  if (now.process_runs) *now.process_runs -= before.process_runs.value_or(0);
  return now;
}

std::string report_json(const job& asked, const outcome& of, const circumstances& in) {
  const distance off = distance_of(of.reference, of.image);
  const nlohmann::ordered_json nmse =
      off.nmse ? nlohmann::ordered_json(*off.nmse) : nlohmann::ordered_json(nullptr);
  nlohmann::ordered_json report{{"scene", in.scene},
                                {"device", in.device.of().name()},
                                {"format", in.device.format()},
                                {"options", in.device.values()},
                                {"engine", in.engine},
                                {"effects", asked.asked == effects::all ? "all" : "auto"},
                                {"shading", in.shading},
                                {"perspective", in.is_corrected ? "corrected" : "screen"},
                                {"normalisation", find(asked.energy).name},
                                {"width", asked.width},
                                {"height", asked.height},
                                {"lights", asked.of->lights.size()},
                                {"triangles", asked.of->surface.triangles.size()},
                                {"triangles_visible", of.triangles_visible},
                                {"triangles_in_highlight", of.triangles_in_highlight},
                                {"triangles_left_out", of.triangles_left_out},
                                {"pixels", of.pixels},
                                {"pixels_in_highlight", of.pixels_in_highlight},
                                {"points", of.points},
                                {"tests_left_out", of.tests_left_out},
                                {"device_writes", of.device_writes},
                                {"watched_writes", of.watched_writes},
                                {"units", of.planned.units},
                                {"units_engine", asked.units != nullptr ? asked.units->name : "bit"},
                                {"spans_engine", asked.spans != nullptr ? asked.spans->name : "host"},
                                {"span_lines", of.span_lines},
                                {"unit_rows", of.unit_rows},
                                {"unit_cycles", in.unit_cycles},
                                {"plan", of.planned.reasons},
                                {"blocks", in.blocks},
                                {"simulated_ns", in.simulated_ns},
                                {"cycles", in.cycles},
                                {"delta_cycles", in.delta_cycles},
                                {"process_runs", in.process_runs.value_or(0)},
                                {"nmse", nmse},
                                {"verdict", verdict(off.nmse)},
                                {"psnr_db", nullptr},
                                {"pixels_off", off.pixels_off},
                                {"largest_difference", off.largest},
                                {"threads", in.threads},
                                {"host_s", of.host_s},
                                {"frames_per_second", 1 / frame_s(of)},
                                {"messages", in.messages}};
  if (off.psnr_db) report["psnr_db"] = *off.psnr_db;
  if (of.by_segments) {
    report["segments"] = {{"pixels_traced", of.by_segments->traced},
                          {"pixels_interpolated", of.by_segments->interpolated},
                          {"elements_2_29", of.by_segments->elements_2_29},
                          {"elements_2_31", of.by_segments->elements_2_31}};
  }
  return report.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

picture comparison(const outcome& of, const circumstances& in) {
  constexpr int kGain = 4;
  const distance off = distance_of(of.reference, of.image);
  const std::array<std::string, 3> titles{
      "Blinn, double", fmt::format("{} {}, {}", in.device.of().name(), in.device.format(), in.engine),
      fmt::format("{} x difference, NMSE {}", kGain, off.nmse ? fmt::format("{:.1e}", *off.nmse) : "-")};
  const std::array<picture, 3> shown{of.reference, of.image, difference(of.reference, of.image, kGain)};
  // A small picture's column is as wide as its title.
  constexpr int kMargin = 4;
  int column = of.image.width;
  for (const std::string& each : titles) column = std::max(column, text_width(each) + 2 * kMargin);
  picture sheet(3 * column, of.image.height + kTextHeight);
  for (std::size_t i = 0; i < titles.size(); ++i) {
    const int left = static_cast<int>(i) * column;
    paste(shown[i], sheet, left, kTextHeight);
    write_text(sheet, left + kMargin, 2, titles[i]);
  }
  return sheet;
}

std::string report_table(const job& asked, const outcome& of, const circumstances& in) {
  const distance off = distance_of(of.reference, of.image);
  std::string table;
  const auto row = [&](std::string_view what, const std::string& value) {
    table += fmt::format("{:<24}{}\n", what, value);
  };
  row("picture", fmt::format("{} x {}, {} shading, {} pixels of the mesh", asked.width, asked.height,
                             in.shading, of.pixels));
  row("device", fmt::format("{} {}, engine {}", in.device.of().name(), in.device.format(), in.engine));
  row("units", fmt::format("{}", fmt::join(of.planned.units, ", ")));
  if (asked.units != nullptr) {
    row("effect units", fmt::format("{}, engine {}: {} lights of {} points", asked.units->device.top_name(),
                                    asked.units->name, of.unit_rows, of.points));
  }
  if (asked.spans != nullptr) {
    row("lines of pixels",
        fmt::format("{}, engine {}: {}", asked.spans->device.top_name(), asked.spans->name, of.span_lines));
  }
  if (asked.energy != normalisation::none) row("energy factor", std::string(find(asked.energy).formula));
  row("pixels in a highlight", fmt::format("{}", of.pixels_in_highlight));
  row("device writes",
      fmt::format("{} of {} points times {} lights", of.device_writes, of.points, asked.of->lights.size()));
  if (of.by_segments) {
    row("segments",
        fmt::format("{} pixels traced, {} interpolated; processing elements by (2.29) {}, by (2.31) {}",
                    of.by_segments->traced, of.by_segments->interpolated, of.by_segments->elements_2_29,
                    of.by_segments->elements_2_31));
  }
  row("triangles", fmt::format("{} in a highlight, {} visible, {} in all", of.triangles_in_highlight,
                               of.triangles_visible, asked.of->surface.triangles.size()));
  if (of.triangles_left_out > 0) {
    row("inner specular check", fmt::format("{} triangles left out, {} tests of pixels spared",
                                            of.triangles_left_out, of.tests_left_out));
  }
  if (in.cycles > 0) {
    row("simulated",
        fmt::format("{} ns, {} clock cycles, {} delta cycles{}", in.simulated_ns, in.cycles, in.delta_cycles,
                    in.process_runs ? fmt::format(", {} runs of processes", *in.process_runs) : ""));
  }
  row("against Blinn's model",
      fmt::format("NMSE {} ({}), {}, {} pixels off by 3/255 or more, largest {}",
                  off.nmse ? fmt::format("{:.2e}", *off.nmse) : "-", verdict(off.nmse),
                  off.psnr_db ? fmt::format("PSNR {:.1f} dB", *off.psnr_db) : "equal", off.pixels_off,
                  off.largest));
  std::string times;
  for (const auto& [phase, seconds] : of.host_s)
    times += fmt::format("{}{} {:.1f} ms", times.empty() ? "" : ", ", phase, 1e3 * seconds);
  row("host time", fmt::format("{}; {:.1f} frames per second", times, 1 / frame_s(of)));
  return table;
}

}  // namespace blysk::render
