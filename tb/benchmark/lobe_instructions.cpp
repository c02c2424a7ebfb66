// SPDX-License-Identifier: Apache-2.0
// lobe_instructions --names: the lobes, a line each, but those that are others times a factor.
// lobe_instructions LOBE N TIMES: the values of a lobe at 1024 cosines one after the other, TIMES times over; or, with
// --picture, TIMES pictures of the golden sphere, 64 x 64. What valgrind counts for a time more is what one takes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "tb/golden/lobe.h"
#include "tb/golden/sphere.h"
#include "tb/program.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk::golden;

constexpr std::size_t kCosines = 1024;

volatile double kept;  // so that no value is left out

void run_values(lobe which, double n, int times) {
  std::array<double, kCosines> cosines{};
  for (std::size_t i = 0; i < kCosines; ++i)
    cosines[i] = static_cast<double>((i * 619) % kCosines) / static_cast<double>(kCosines);
  with_lobe(which, n, [&](const auto& f) {
    for (int i = 0; i < times; ++i) {
      for (const double cosine : cosines) kept = f(cosine);
    }
  });
}

void run_pictures(lobe which, double n, int times) {
  sphere_scene scene;
  scene.side = 64;
  for (int i = 0; i < times; ++i) kept = shade_sphere(scene, {1, 1, 0.1, 0.3, 0.6}, which, n).front();
}

bool has_factor(std::string_view name) {
  return name.find("normalised") != std::string_view::npos || name.find("energy") != std::string_view::npos;
}

}  // namespace

int main(int argc, char** argv) {
  std::string name;
  double n = 1;
  int times = 0;
  bool is_picture = false;
  bool lists = false;
  return blysk::run_program(
      argc, argv, "Evaluates a lobe, for a tool that counts instructions",
      [&](CLI::App& program) {
        program.add_option("LOBE", name, "of the golden models, such as blinn");
        program.add_option("N", n, "exponent")->check(CLI::Range(1.0, 1000.0));
        program.add_option("TIMES", times, "how often")->check(CLI::Range(0, 1000));
        program.add_flag("--picture", is_picture, "whole pictures");
        program.add_flag("--names", lists, "list the lobes");
      },
      [&] {
        if (lists) {
          for (const named_lobe& each : kLobes) {
            if (!has_factor(each.name)) fmt::print("{}\n", each.name);
          }
          return 0;
        }
        const auto found = std::ranges::find(kLobes, name, &named_lobe::name);
        if (found == kLobes.end())
          throw blysk::usage_error("lobe '" + name + "' does not exist, expected blinn or another");
        (is_picture ? run_pictures : run_values)(found->which, n, times);
        return 0;
      });
}
