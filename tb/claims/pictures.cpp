// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/pictures.h"

#include <algorithm>
#include <map>
#include <vector>

#include "tb/claims/claim.h"
#include "tb/claims/table_form.h"

namespace blysk::golden {
namespace {

/// What the scenes share: the cosines of the lit pixels, which alone can hold a highlight, and the sums of which the
/// energy of a picture without one is made.
struct lit_sphere {
  std::vector<double> cosines;  ///< N . H, lit pixels
  std::vector<double> diffuse;  ///< N . L, lit pixels
  double pixels = 0;            ///< lit or not
  double diffuse_sum = 0;
  double diffuse_square = 0;
};

const lit_sphere& sphere() {
  static const lit_sphere result = [] {
    const sphere_scene scene;
    const vec3<double> half_vec = half_vector(scene.light, scene.view);
    lit_sphere lit;
    for (const auto& pixel : sphere_pixels(scene)) {
      ++lit.pixels;
      if (!faces_both(pixel.normal, scene.light, scene.view)) continue;
      const double diffuse = clamped_cosine(pixel.normal, scene.light);
      lit.cosines.push_back(clamped_cosine(pixel.normal, half_vec));
      lit.diffuse.push_back(diffuse);
      lit.diffuse_sum += diffuse;
      lit.diffuse_square += diffuse * diffuse;
    }
    return lit;
  }();
  return result;
}

std::vector<double> highlight(lobe which, int n) {
  std::vector<double> result(sphere().cosines.size());
  evaluate(which, n, sphere().cosines, result);
  for (double& value : result) value = std::max(0.0, value);
  return result;
}

std::vector<double> highlight(const table_form& form) {
  std::vector<double> result;
  for (const double c : sphere().cosines) result.push_back(form(c));
  return result;
}

double squared_distance(const std::vector<double>& a, const std::vector<double>& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) result += (a[i] - b[i]) * (a[i] - b[i]);
  return result;
}

/// Sums of Blinn's highlight b over the lit pixels, of which the energy of every scene's picture is made.
struct reference_sums {
  double plain, square, diffuse;  ///< b, b^2, b (N . L)
};

struct sphere_sums {
  std::vector<reference_sums> reference;                       ///< entry n - 1
  std::map<std::string_view, std::vector<double>> difference;  ///< by lobe's name: sum (b - f)^2, entry n - 1
};

/// All lobes at once, as each needs Blinn's highlights.
sphere_sums measure() {
  sphere_sums result;
  const auto& diffuse = sphere().diffuse;
  for (int n = 1; n <= kMaxExponent; ++n) {
    const auto blinn = highlight(lobe::blinn, n);
    reference_sums sums{};
    for (std::size_t i = 0; i < blinn.size(); ++i) {
      sums.square += blinn[i] * blinn[i];
      sums.diffuse += blinn[i] * diffuse[i];
      sums.plain += blinn[i];
    }
    result.reference.push_back(sums);
    for (const lobe which : kApproximations)
      result.difference[name_of(which)].push_back(squared_distance(blinn, highlight(which, n)));
    result.difference[table_form::kName].push_back(
        squared_distance(blinn, highlight(best_table_form(epicentre::level_060, n))));
  }
  return result;
}

const sphere_sums& sums() {
  static const sphere_sums result = measure();
  return result;
}

}  // namespace

double sphere_nmse(std::string_view which, const picture_scene& scene, int n) {
  const auto index = static_cast<std::size_t>(n) - 1;
  const auto& [ambient_light, point_light, ka, kd, ks] = scene.light;
  const double ambient = ambient_light * ka;
  const double diffuse = point_light * kd;
  const double specular = point_light * ks;
  const double base = sphere().pixels * ambient * ambient + 2 * ambient * diffuse * sphere().diffuse_sum +
                      diffuse * diffuse * sphere().diffuse_square;
  const auto& b = sums().reference[index];
  const double energy =
      base + 2 * specular * (ambient * b.plain + diffuse * b.diffuse) + specular * specular * b.square;
  return specular * specular * sums().difference.at(which)[index] / energy;
}

std::vector<table> picture_tables() {
  constexpr std::array kListed{1, 2, 3, 5, 10, 20, 50, 100, 169, 170, 200, 500, 1000};
  std::string text =
      "# NMSE on the sphere against Blinn's lobe\n\n512 x 512 pixels, orthographic view (0, 0, 1), one light "
      "along (0.4, 0.5, 0.75), radius 0.9 of half the side; negative lobes set to zero; real-valued "
      "pictures. "
      "The light's colour cancels. [T] reads up to 1e-4 as no visible difference, to 2.5e-4 slight, to 1e-3 "
      "visible, above strong. The last column is the largest over every n in 1..1000. schlick-modified-e is "
      "the form of [T] table 3.2, a fitted to the error where c^n >= 0.6.\n";
  for (const auto& scene : kPictureScenes) {
    std::vector<std::vector<std::string>> rows{{"lobe \\ n"}};
    for (const int n : kListed) rows.front().push_back(std::to_string(n));
    rows.front().push_back("largest, at n");
    for (const auto& [name, differences] : sums().difference) {
      rows.push_back({std::string(name)});
      const auto value = [&, which = name](int n) { return sphere_nmse(which, scene, n); };
      for (const int n : kListed) rows.back().push_back(number(value(n), 2));
      const worst w = worst_over(1, kMaxExponent, value);
      rows.back().push_back("**" + number(w.value, 2) + "**, " + std::to_string(w.n));
    }
    text += "\n## " + std::string(scene.name) + "\n\n" + markdown(rows);
  }
  return {{"nmse.md", text}};
}

}  // namespace blysk::golden
