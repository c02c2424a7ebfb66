// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tb/golden/lobe_formulas.h"
#include "tb/render/effects/energy.h"
#include "tb/render/incidence.h"

namespace blysk::render {

/// The colour that the picture is judged by: Ia ka + sum of Il (kd N.L + ks energy (N.H)^n) in double, before saturation.
/// [T] (1.2) (2.11)
/// \return  in units of 1/255 of full light
inline std::array<double, 3> reference_colour(const scene::world& of, const std::vector<scene::light>& lights,
                                              const vec& eye, const point& at, normalisation by) {
  const scene::material& material = of.surface.materials[at.material];
  const vec view = golden::normalised(eye - at.position);
  std::array<double, 3> sum{};
  for (std::size_t channel = 0; channel < 3; ++channel)
    sum[channel] = material.emitted[channel] + of.ambient[channel] * material.ka[channel];
  for (const scene::light& light : lights) {
    const incidence met = incidence_of(at, view, light);
    const double nh = half_cosine(at, view, met);
    const double lobe = nh > 0 ? energy_factor(by, material.n) * golden::blinn<double>(material.n, nh) : 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      sum[channel] += light.colour[channel] * (material.kd[channel] * met.nl + material.ks[channel] * lobe);
    }
  }
  for (double& each : sum) each *= 255;
  return sum;
}

}  // namespace blysk::render
