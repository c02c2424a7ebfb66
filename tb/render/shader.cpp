// SPDX-License-Identifier: Apache-2.0
#include "tb/render/shader.h"

#include <algorithm>
#include <chrono>

#include "tb/render/effects/ambient.h"
#include "tb/render/effects/diffuse.h"

namespace blysk::render {

shader::shader(const std::vector<scene::light>& lights, const vec& eye, const plan& planned,
               const device_ports& ports, engine* device, const attached_device* units, results to)
    : lights_(lights),
      eye_(eye),
      plan_(planned),
      ports_(ports),
      device_(device),
      to_(to),
      specular_(planned.specular_lights()),
      inputs_(ports.make_writes()) {
  if (units != nullptr) units_.emplace(*units, effect_units::results{to.sums, to.channels});
  for (std::uint32_t material = 0; material < specular_.size(); ++material) {
    bool has_diffuse = false;
    for (std::size_t k = 0; k < lights.size(); ++k)
      has_diffuse = has_diffuse || planned.at(material, k).has_diffuse;
    has_diffuse_.push_back(has_diffuse);
  }
}

void shader::add_unlit(std::uint32_t index, std::uint32_t material) {
  begin(index, material);
  flush_if_full();
}

void shader::begin(std::uint32_t index, std::uint32_t material) {
  const coefficient_rgb& ambient = plan_.ambient[material];
  if (units_) {
    units_->begin(index, ambient, plan_.grey_materials[material]);
    return;
  }
  for (std::size_t channel = 0; channel < 3; ++channel)
    to_.sums[index][channel] = ambient_term(ambient[channel]);
}

void shader::add(std::uint32_t index, const point& at, light_set dark) {
  begin(index, at.material);
  sum_rgb& sum = to_.sums[index];
  const light_set specular = specular_[at.material] & ~dark;
  const vec view = specular != 0 ? golden::normalised(eye_ - at.position) : vec{0, 0, 0};
  const int fraction = ports_.cos_fraction();
  const bool all = plan_.asked == effects::all;
  for (std::size_t k = 0; k < lights_.size(); ++k) {
    const light_plan& light = plan_.at(at.material, k);
    const bool has_specular = (specular >> k & 1) != 0;
    if (!light.has_diffuse && !has_specular) continue;
    const incidence met = incidence_of(at, view, lights_[k]);
    std::uint32_t number = 0;
    if (light.has_diffuse) {
      const std::int64_t cosine = cosine_code(met.nl, fraction);
      if (units_) number = units_->add(light.diffuse, cosine);
      for (std::size_t channel = 0; !units_ && channel < 3; ++channel)
        sum[channel] += diffuse_term(light.diffuse[channel], cosine, fraction);
    }
    if (!has_specular) continue;
    if (!all && !(met.is_lit && may_reach(at, view, met, light.below_lobe))) continue;
    // Away from the light or the eye, or where these are opposite, there is no highlight, whatever the lobe is at 0.
    const double nh = half_cosine(at, view, met);
    const bool is_lit = nh > 0;
    const std::int64_t cosine = cosine_code(nh, fraction);
    const bool adds = is_lit && cosine >= light.lobe_begin;
    if (!adds && !all) continue;
    if (units_ && !light.has_diffuse) number = units_->add({}, 0);
    if (units_) units_->set_energy(number, light.energy.code);
    waiting_.push_back({index, static_cast<std::uint32_t>(at.material * lights_.size() + k),
                        static_cast<std::uint32_t>(cosine), number, is_lit});
  }
  flush_if_full();
}

void shader::flush_if_full() {
  if (waiting_.size() >= kBatch || (units_ && units_->waiting() >= kBatch)) flush();
}

void shader::flush() {
  run_writes();
  if (units_) units_->run();
}

void shader::run_writes() {
  if (waiting_.empty()) return;
  // What a material and a light write into registers 1, 3, 4 and 5 is written once a batch.
  if (plan_.asked == effects::automatic) std::ranges::stable_sort(waiting_, {}, &write::slot);
  run(waiting_);
  waiting_.clear();
}

void shader::run(std::span<const write> batch) {
  inputs_.resize(batch.size());
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const light_plan& light = plan_.of_lights[batch[i].slot];
    auto colour = light.specular;
    if (light.is_grey) colour[1] = colour[2] = 0;
    ports_.set(inputs_, i, light.n, batch[i].cosine, colour);
  }
  const auto started = std::chrono::steady_clock::now();
  device_->run(inputs_, outputs_);
  device_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  writes_ += batch.size();
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!batch[i].is_lit) continue;
    if (!ports_.is_dark(outputs_, i)) to_.in_highlight[batch[i].point] = 1;
    sum_rgb& sum = to_.sums[batch[i].point];
    const light_plan& light = plan_.of_lights[batch[i].slot];
    const bool is_grey = light.is_grey;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      if (units_) {
        units_->set_specular(batch[i].light, channel, ports_.code(outputs_, i, is_grey ? 0 : channel));
      } else {
        sum[channel] += ports_.term(outputs_, i, is_grey ? 0 : channel, light.energy);
      }
    }
  }
}

}  // namespace blysk::render
