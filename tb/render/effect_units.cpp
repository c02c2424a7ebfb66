// SPDX-License-Identifier: Apache-2.0
#include "tb/render/effect_units.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace blysk::render {
namespace {

constexpr std::string_view kUnitColumns = "nl,first,ar,ag,ab,dr,dg,db,sr,sg,sb";
constexpr const char* kEnergyOption = "energy";
constexpr const char* kEnergyColumn = ",energy";
constexpr std::string_view kResults = "red_sum,green_sum,blue_sum,red,green,blue";
enum : std::size_t {
  kCosine,
  kFirst,
  kAmbient,
  kDiffuse = kAmbient + 3,
  kSpecular = kDiffuse + 3,
  kEnergy = kSpecular + 3
};
enum : std::size_t { kSum, kChannel = kSum + 3 };

std::vector<port> of(const selection& device, port::role role) {
  return of_role(device.of().ports(device), role);
}

bool adds_up_effects(const selection& device, bool has_energy) {
  const std::vector<port> ports = device.of().ports(device);
  if (column_names(ports, port::role::data) !=
          std::string(kUnitColumns) + (has_energy ? kEnergyColumn : "") ||
      column_names(ports, port::role::result) != kResults)
    return false;
  const std::vector<port> data = of_role(ports, port::role::data);
  if (has_energy && data[kEnergy].carries->frac != energy_of(normalisation::blinn, 1, device.fraction()).bits)
    return false;
  return data[kAmbient].carries->frac == kCoefficientBits &&
         data[kDiffuse].carries->frac == kCoefficientBits &&
         of_role(ports, port::role::result)[kSum].carries->frac == kSumBits;
}

}  // namespace

selection choose_effect_units(const std::string& format, bool has_energy) {
  for (const device* each : devices()) {
    if (!adds_up_effects(choose(each->name(), format), false)) continue;
    if (!has_energy) return choose(each->name(), format);
    const auto options = each->options();
    const auto found = std::ranges::find(options, kEnergyOption, &option::name);
    if (found == options.end() || !found->is_flag()) continue;
    selection chosen = choose(each->name(), format, {{kEnergyOption, "on"}});
    if (adds_up_effects(chosen, true)) return chosen;
  }
  throw std::logic_error("no device adds up effects");
}

void expect_fitting(const attached_device& units, const selection& shades) {
  const device_ports beside(shades);
  const std::vector<port> data = of(units.device, port::role::data);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const wire_format& put = beside.result_format(channel);
    const wire_format& taken = *data[kSpecular + channel].carries;
    const bool fits = !put.is_signed && put.width() == taken.width() && put.frac == taken.frac &&
                      data[kCosine].carries->frac == beside.cos_fraction();
    if (fits) continue;
    throw std::invalid_argument(
        fmt::format("{} takes specular terms of {}, and {} puts out {}, expected a "
                    "device with options that limit it to 255",
                    units.device.top_name(), taken.text(), shades.text(), put.text()));
  }
}

effect_units::effect_units(const attached_device& from, results to)
    : through_(*from.through),
      to_(to),
      inputs_(from.device.of().ports(from.device), port::role::data),
      has_energy_(of(from.device, port::role::data).size() > kEnergy) {}

void effect_units::begin(std::uint32_t point, const coefficient_rgb& ambient, bool is_grey) {
  rows_.push_back({point, true, is_grey, ambient, {}, 0, {}});
  has_light_ = false;
}

std::uint32_t effect_units::add(const coefficient_rgb& diffuse, std::int64_t cosine) {
  if (has_light_) {
    const row& first = rows_.back();
    rows_.push_back(row{first.point, false, first.is_grey, {}, {}, 0, {}});
  }
  has_light_ = true;
  rows_.back().diffuse = diffuse;
  rows_.back().cosine = cosine;
  return static_cast<std::uint32_t>(rows_.size() - 1);
}

void effect_units::set_specular(std::uint32_t light, std::size_t channel, std::int64_t code) {
  rows_[light].specular[channel] = code;
}

void effect_units::run() {
  if (rows_.empty()) return;
  inputs_.resize(rows_.size());
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const row& each = rows_[i];
    inputs_[kCosine].set(i, each.cosine);
    inputs_[kFirst].set(i, each.is_first ? 1 : 0);
    if (has_energy_) inputs_[kEnergy].set(i, each.energy);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const bool is_served = each.is_grey && channel > 0;
      inputs_[kAmbient + channel].set(i, is_served ? 0 : each.ambient[channel]);
      inputs_[kDiffuse + channel].set(i, is_served ? 0 : each.diffuse[channel]);
      inputs_[kSpecular + channel].set(i, is_served ? 0 : each.specular[channel]);
    }
  }
  const auto started = std::chrono::steady_clock::now();
  through_.run(inputs_, outputs_);
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  if (outputs_.size() != rows_.size())
    throw std::logic_error("the effect units gave another number of results than they took lights");
  // The results of a point's last light stay.
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const row& each = rows_[i];
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const std::size_t by = each.is_grey ? 0 : channel;
      to_.sums[each.point][channel] = outputs_[kSum + by].get(i);
      to_.channels[each.point][channel] = static_cast<std::uint8_t>(outputs_[kChannel + by].get(i));
    }
  }
  taken_ += rows_.size();
  rows_.clear();
}

}  // namespace blysk::render
