// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tb/program.h"
#include "tb/render/experiments/experiments.h"
#include "tb/scene/shapes.h"

namespace {

using namespace blysk;
using namespace blysk::render;

constexpr std::array kShown{1, 2, 3, 5, 10, 20, 50, 100, 169, 170, 200, 500, 1000};

struct span_of_n {
  int first, last;
};
constexpr std::array kSpans{span_of_n{1, 1000}, span_of_n{1, 169}, span_of_n{170, 1000}};

void append_nmse(std::string& csv, std::string& page) {
  const scene::shape& shape = *scene::find_shape("teapot");
  const scene::mesh mesh = shape.make(shape.density);
  const listing_picture teapot(mesh, scene::fitted_camera(mesh));
  csv = "lobe,scene,first_n,last_n,largest,at_n\n";
  std::array<std::string, kListingScenes.size()> tables;
  for (const golden::named_lobe& each : golden::kLobes) {
    if (each.which == golden::lobe::blinn || each.name.find("normalised") != std::string_view::npos ||
        each.name.find("energy") != std::string_view::npos)
      continue;
    std::array<std::vector<double>, kListingScenes.size()> by_n;
    for (int n = 1; n <= 1000; ++n) {
      const auto found = teapot.nmse(each.which, n);
      for (std::size_t s = 0; s < found.size(); ++s) by_n[s].push_back(found[s]);
    }
    for (std::size_t s = 0; s < by_n.size(); ++s) {
      tables[s] += fmt::format("| {} |", each.name);
      for (const int n : kShown)
        tables[s] += fmt::format(" {:.2g} |", by_n[s][static_cast<std::size_t>(n - 1)]);
      for (const auto& [first, last] : kSpans) {
        const auto begin = by_n[s].begin() + (first - 1);
        const auto worst = std::max_element(begin, by_n[s].begin() + last);
        const auto at = worst - by_n[s].begin() + 1;
        csv += fmt::format("{},{},{},{},{:.6g},{}\n", each.name, s, first, last, *worst, at);
        if (first == 1 && last == 1000) tables[s] += fmt::format(" **{:.2g}**, {} |\n", *worst, at);
      }
    }
  }
  page += fmt::format(
      "## NMSE on the teapot against Blinn's lobe\n\n"
      "Table 3.2 of [T] on Newell's teapot, {} pixels of 512 x 512, as `blysk render teapot` shows it; light "
      "(0.4, 0.5, "
      "0.75). Colours as in [nmse.md](nmse.md), which has the sphere. The limits that the table states are "
      "those of rows "
      "T33 to T36 of [verification.md](../verification.md). The last column is the largest over every n.\n",
      teapot.pixels());
  for (std::size_t s = 0; s < tables.size(); ++s) {
    page += fmt::format("\n### {}\n\n| lobe \\ n |", kListingScenes[s].name);
    for (const int n : kShown) page += fmt::format(" {} |", n);
    page += " largest, at n |\n|---|";
    for (std::size_t i = 0; i <= kShown.size(); ++i) page += "---|";
    page += "\n" + tables[s];
  }
}

void append_segments(std::string& csv, std::string& page) {
  const selection device = choose(devices().front()->name(), "q16");
  const auto make = [&] { return device.of().make_bit(device); };
  const auto only = make();
  const device_source from{device, [&](unsigned) { return only.get(); }, false, make};
  csv = "scene,measure,limit,inner,traced,interpolated,nmse,largest,elements_2_29,elements_2_31\n";
  page +=
      "\n## Segments of rows, [T] 2.6\n\n"
      "`blysk render SCENE --renderer segments`, 512 x 512 pixels, segments of 8 pixels, the preset device, "
      "q16. NMSE and "
      "the largest difference of a channel are against the picture with every pixel traced. [T] states K = "
      "2.3 and no "
      "measure. (2.29) counts segments of 8 pixels that are never halved; (2.31) has the row's segments as "
      "they came "
      "out. bilinear and bicubic are by blocks of 8 x 8 pixels, (2.28) in both directions; (2.31) then "
      "counts the rows "
      "with a traced "
      "pixel.\n\n"
      "| scene | measure | K | inner pixels | traced, % | NMSE | largest, in 1/255 | traced | (2.29) | "
      "(2.31) |\n"
      "|---|---|---:|---|---:|---:|---:|---:|---:|---:|\n";
  for (const segment_run& each : run_segments(from)) {
    const char* measure = each.asked.measure == colour_measure::rgb ? "rgb" : "cie76";
    const std::string_view inner =
        std::ranges::find(kInnerColours, each.asked.inner, &named_inner_colours::are)->name;
    const auto& counts = each.counts;
    const double share =
        100 * static_cast<double>(counts.traced) / static_cast<double>(counts.traced + counts.interpolated);
    csv += fmt::format("{},{},{},{},{},{},{:.6g},{},{},{}\n", each.scene, measure, each.asked.limit, inner,
                       counts.traced, counts.interpolated, each.nmse, each.largest, counts.elements_2_29,
                       counts.elements_2_31);
    page += fmt::format("| {} | {} | {} | {} | {:.1f} | {:.2g} | {} | {} | {} | {} |\n", each.scene, measure,
                        each.asked.limit, inner, share, each.nmse, each.largest, counts.traced,
                        counts.elements_2_29, counts.elements_2_31);
  }
}

void write(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace

int main(int argc, char** argv) {
  std::string folder;
  return run_program(
      argc, argv, "Writes teapot_nmse.csv, segments.csv and thesis_pictures.md, the tables of both",
      [&](CLI::App& program) {
        program.add_option("FOLDER", folder, "of the tables, such as docs/tables")->required();
      },
      [&] {
        std::string nmse;
        std::string rows;
        std::string page =
            "<!-- generated by the target update_thesis_pictures; do not edit -->\n"
            "# Pictures of the thesis's experiments\n\n";
        append_nmse(nmse, page);
        append_segments(rows, page);
        write(folder + "/teapot_nmse.csv", nmse);
        write(folder + "/segments.csv", rows);
        write(folder + "/thesis_pictures.md", page);
        return 0;
      });
}
