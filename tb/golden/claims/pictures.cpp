// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/claims/pictures.h"

#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "tb/golden/claims/claim.h"

namespace blysk::golden {
double sphere_nmse(lobe which, const picture_scene& scene, int n) {
  static const sphere_scene sphere;
  static std::map<std::pair<std::string_view, int>, std::vector<double>> references;
  static std::map<std::tuple<lobe, std::string_view, int>, double> known;
  const auto [entry, is_new] = known.try_emplace({which, scene.name, n}, 0);
  if (is_new) {
    auto& reference = references[{scene.name, n}];
    if (reference.empty()) reference = shade_sphere(sphere, scene.light, lobe::blinn, n);
    entry->second = nmse(reference, shade_sphere(sphere, scene.light, which, n));
  }
  return entry->second;
}

worst worst_nmse(lobe which, const picture_scene& scene, int first, int last) {
  worst result{-std::numeric_limits<double>::infinity(), first};
  for (const int n : kPictureExponents) {
    if (n < first || n > last) continue;
    const double value = sphere_nmse(which, scene, n);
    if (value > result.value) result = {value, n};
  }
  return result;
}

std::vector<table> picture_tables() {
  std::string text =
      "# NMSE on the sphere against Blinn's lobe\n\n512 x 512 pixels, orthographic view (0, 0, 1), one light "
      "along "
      "(0.4, 0.5, 0.75), radius 0.9 of half the side; negative lobes set to zero; real-valued pictures, "
      "white light. "
      "[T] reads up to 1e-4 as no visible difference, to 2.5e-4 slight, to 1e-3 visible, above strong.\n";
  for (const auto& scene : kPictureScenes) {
    std::vector<std::vector<std::string>> rows{{"lobe \\ n"}};
    for (const int n : kPictureExponents) rows.front().push_back(std::to_string(n));
    for (const lobe which : kApproximations) {
      rows.push_back({std::string(name_of(which))});
      for (const int n : kPictureExponents) rows.back().push_back(number(sphere_nmse(which, scene, n), 2));
    }
    text += "\n## " + std::string(scene.name) + "\n\n" + markdown(rows);
  }
  return {{"nmse.md", text}};
}

}  // namespace blysk::golden
