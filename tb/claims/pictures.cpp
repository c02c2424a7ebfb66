// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/pictures.h"

#include <algorithm>
#include <map>
#include <vector>

#include "tb/claims/table_form.h"
#include "tb/golden/sphere.h"

namespace blysk::claims {

using namespace golden;
namespace {

constexpr int kWhite = 255;

/// A factor in [0, 1] as calcColor cuts it.
int code_of(double factor) {
  return static_cast<int>(factor * kWhite);
}

struct pixel {
  double cos_half;          ///< N . H
  std::array<int, 3> base;  ///< colours without a highlight
};

struct lit_sphere {
  std::vector<pixel> pixels;          ///< falling cos_half, so that a highlight comes first
  std::vector<double> energy_behind;  ///< entry i: sum of base^2 over the pixels from i on
};

const lit_sphere& sphere(std::size_t scene) {
  static const auto all = [] {
    std::array<lit_sphere, kPictureScenes.size()> result;
    const sphere_scene geometry;
    const vec3<double> half_vec = half_vector(geometry.light, geometry.view);
    for (std::size_t s = 0; s < result.size(); ++s) {
      const picture_scene& light = kPictureScenes[s];
      auto& pixels = result[s].pixels;
      for (const auto& [x, y, normal] : sphere_pixels(geometry)) {
        const int diffuse = code_of(light.kd * clamped_cosine(normal, geometry.light));
        pixel p{clamped_cosine(normal, half_vec), {}};
        for (std::size_t i = 0; i < p.base.size(); ++i) p.base[i] = light.colour[i] * diffuse / kWhite;
        pixels.push_back(p);
      }
      std::ranges::stable_sort(pixels, std::ranges::greater{}, &pixel::cos_half);
      auto& energy = result[s].energy_behind;
      energy.assign(pixels.size() + 1, 0);
      for (std::size_t i = pixels.size(); i-- > 0;) {
        energy[i] = energy[i + 1];
        for (const int base : pixels[i].base) energy[i] += base * base;
      }
    }
    return result;
  }();
  return all[scene];
}

/// Highlight of each pixel in the order of sphere(0), as far as it shows: a lobe falls with the angle.
template <class Lobe>
std::vector<double> highlight(const Lobe& lobe) {
  std::vector<double> result;
  for (const pixel& p : sphere(0).pixels) {
    const double value = lobe(p.cos_half);
    if (!(value * kWhite >= 1)) break;
    result.push_back(value);
  }
  return result;
}

std::vector<double> highlight(lobe which, int n) {
  return with_lobe(which, static_cast<double>(n), [](const auto& f) { return highlight(f); });
}

/// NMSE of the pictures with either highlight; beyond their ends they are 0.
double nmse_of(const std::vector<double>& reference, const std::vector<double>& tried, std::size_t scene) {
  const auto& [pixels, energy_behind] = sphere(scene);
  const double ks = kPictureScenes[scene].ks;
  double difference = 0;
  double energy = 0;
  const std::size_t end = std::max(reference.size(), tried.size());
  for (std::size_t i = 0; i < end; ++i) {
    const int a = i < reference.size() ? code_of(ks * reference[i]) : 0;
    const int b = i < tried.size() ? code_of(ks * tried[i]) : 0;
    for (const int base : pixels[i].base) {
      const int first = std::min(kWhite, base + a);
      const int second = std::min(kWhite, base + b);
      difference += (first - second) * (first - second);
      energy += first * first;
    }
  }
  return difference / (energy + energy_behind[end]);
}

using nmse_by_exponent = std::array<std::vector<double>, kPictureScenes.size()>;

std::map<std::string_view, nmse_by_exponent> measure() {
  std::map<std::string_view, nmse_by_exponent> result;
  for (int n = 1; n <= kMaxExponent; ++n) {
    const auto blinn = highlight(lobe::blinn, n);
    const auto add = [&](std::string_view name, const std::vector<double>& tried) {
      for (std::size_t s = 0; s < kPictureScenes.size(); ++s)
        result[name][s].push_back(nmse_of(blinn, tried, s));
    };
    for (const lobe which : kApproximations) add(name_of(which), highlight(which, n));
    add(table_form::kName, highlight(best_table_form(epicentre::level_060, n)));
  }
  return result;
}

const std::map<std::string_view, nmse_by_exponent>& measured() {
  static const auto result = measure();
  return result;
}

}  // namespace

double sphere_nmse(std::string_view which, std::size_t scene, int n) {
  return measured().at(which)[scene][static_cast<std::size_t>(n) - 1];
}

const std::vector<std::string_view>& pictured_lobes() {
  static const auto result = [] {
    std::vector<std::string_view> names;
    for (const auto& entry : measured()) names.push_back(entry.first);
    return names;
  }();
  return result;
}

}  // namespace blysk::claims
