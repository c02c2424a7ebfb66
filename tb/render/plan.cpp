// SPDX-License-Identifier: Apache-2.0
#include "tb/render/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tb/usage_error.h"

namespace blysk::render {
namespace {

using scene::rgb;

bool is_zero(const auto& codes) {
  return std::ranges::all_of(codes, [](auto each) { return each == 0; });
}

bool is_grey(const auto& codes) {
  return codes[0] == codes[1] && codes[1] == codes[2];
}

std::array<std::uint8_t, 3> specular_codes(const rgb& light, const rgb& ks) {
  std::array<std::uint8_t, 3> codes{};
  for (std::size_t channel = 0; channel < 3; ++channel)
    codes[channel] = static_cast<std::uint8_t>(std::lround(255 * light[channel] * ks[channel]));
  return codes;
}

/// Materials that no triangle has take no part.
std::vector<bool> used_materials(const scene::mesh& surface) {
  std::vector<bool> used(surface.materials.size(), false);
  for (const scene::triangle& each : surface.triangles) used[each.material] = true;
  return used;
}

light_plan plan_light(const scene::material& of, const scene::light& from, bool all) {
  light_plan made;
  for (std::size_t channel = 0; channel < 3; ++channel)
    made.diffuse[channel] = coefficient_code(from.colour[channel] * of.kd[channel]);
  made.specular = specular_codes(from.colour, of.ks);
  made.n = of.n;
  made.has_diffuse = all || !is_zero(made.diffuse);
  made.has_specular = all || !is_zero(made.specular);
  made.is_grey = !all && is_grey(made.specular);
  return made;
}

/// Where the lobe begins, and what its results are multiplied by.
void add_lobe(lobe_table* table, int cos_fraction, normalisation by, light_plan& each) {
  if (table != nullptr) {
    each.lobe_begin = table->begin(each.n);
    each.below_lobe =
        std::ldexp(static_cast<double>(std::max<std::int64_t>(0, each.lobe_begin - 1)), -cos_fraction);
  }
  each.energy = energy_of(by, each.n, cos_fraction);
}

coefficient_rgb ambient_of(const scene::material& of, const rgb& light) {
  coefficient_rgb made{};
  for (std::size_t channel = 0; channel < 3; ++channel)
    made[channel] = coefficient_code(of.emitted[channel] + light[channel] * of.ka[channel]);
  return made;
}

/// What is said of a material under a light.
void explain(const std::string& what, const light_plan& of, bool all, int cos_fraction,
             std::vector<std::string>& to) {
  to.push_back(fmt::format("{}: diffuse {}", what,
                           of.has_diffuse ? (all ? "on, as asked" : "on, Il kd > 0") : "off, Il kd = 0"));
  if (!of.has_specular) {
    to.push_back(fmt::format("{}: specular off, Il ks = 0", what));
    return;
  }
  std::string text = fmt::format("{}: specular on, n = {}", what, of.n);
  if (all) {
    text += ", every point is written, as asked";
  } else {
    text += fmt::format(", a write where N.L > 0, N.V > 0 and cos >= {:.6f} (code {})",
                        std::ldexp(static_cast<double>(of.lobe_begin), -cos_fraction), of.lobe_begin);
    if (of.is_grey) text += "; grey, so red serves green and blue";
  }
  if (of.energy.bits > 0) text += fmt::format("; energy factor {:.6g}", of.energy.real);
  to.push_back(text);
}

}  // namespace

bool plan::has_specular() const {
  return std::ranges::any_of(of_lights, &light_plan::has_specular);
}

std::vector<light_set> plan::specular_lights() const {
  static_assert(kMostLights <= 64 && kMostLights == scene::kMostLights);
  std::vector<light_set> all(ambient.size(), 0);
  for (std::uint32_t material = 0; material < all.size(); ++material) {
    for (std::size_t k = 0; k < lights; ++k) all[material] |= light_set{at(material, k).has_specular} << k;
  }
  return all;
}

std::set<int> written_exponents(const scene::world& of, effects asked) {
  const std::vector<bool> used = used_materials(of.surface);
  std::set<int> exponents;
  for (std::size_t i = 0; i < used.size(); ++i) {
    for (const scene::light& each : of.lights) {
      const light_plan made = plan_light(of.surface.materials[i], each, asked == effects::all);
      if (used[i] && made.has_specular) exponents.insert(made.n);
    }
  }
  return exponents;
}

bool needs_device(const scene::world& of, effects asked) {
  return !written_exponents(of, asked).empty();
}

plan make_plan(const scene::world& of, effects asked, lobe_table* table, int cos_fraction,
               const std::string& device, normalisation by) {
  const bool all = asked == effects::all;
  const std::vector<bool> used = used_materials(of.surface);
  plan made;
  made.asked = asked;
  made.lights = of.lights.size();
  std::set<int> exponents;
  bool has_ambient = all;
  bool has_diffuse = false;
  for (std::size_t i = 0; i < used.size(); ++i) {
    const scene::material& material = of.surface.materials[i];
    const coefficient_rgb ambient = ambient_of(material, of.ambient);
    made.ambient.push_back(ambient);
    has_ambient = has_ambient || (used[i] && !is_zero(ambient));
    bool has_grey_terms = used[i] && !all && is_grey(ambient);
    for (std::size_t k = 0; k < of.lights.size(); ++k) {
      light_plan each = used[i] ? plan_light(material, of.lights[k], all) : light_plan{};
      if (each.has_specular) {
        add_lobe(table, cos_fraction, by, each);
        exponents.insert(each.n);
      }
      has_diffuse = has_diffuse || each.has_diffuse;
      has_grey_terms = has_grey_terms && is_grey(each.diffuse) && each.is_grey;
      if (used[i]) {
        explain(fmt::format("material '{}', light {}", printable(material.name), k + 1), each, all,
                cos_fraction, made.reasons);
      }
      made.of_lights.push_back(each);
    }
    made.grey_materials.push_back(has_grey_terms);
  }
  if (has_ambient) made.units.emplace_back("ambient");
  if (has_diffuse) made.units.emplace_back("diffuse");
  if (made.has_specular()) {
    made.units.insert(made.units.end(), {"specular", device});
    if (by != normalisation::none) made.units.emplace_back("energy");
  }
  made.units.emplace_back("saturation");
  if (!has_ambient) made.reasons.emplace_back("ambient off: Ia ka = 0 and nothing shines by itself");
  if (!made.has_specular()) {
    made.reasons.emplace_back(
        "no device is built and no clock runs: no light meets a material with Il ks > 0");
  } else if (!all && exponents.size() == 1) {
    made.reasons.push_back(fmt::format("register 1 is written once: n = {} everywhere", *exponents.begin()));
  }
  return made;
}

}  // namespace blysk::render
