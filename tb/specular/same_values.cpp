// SPDX-License-Identifier: Apache-2.0
#include "tb/specular/same_values.h"

#include <algorithm>

namespace blysk::specular {

const device& device_of_same_values::other() const {
  return *find_device(whose_).first;
}

selection device_of_same_values::of_other(const selection& asked) const {
  const std::vector<option> known = other().options();
  std::map<std::string, std::string> values = asked.values();
  std::erase_if(values, [&](const auto& each) {
    return std::ranges::find(known, each.first, &option::name) == known.end();
  });
  return choose(whose_, asked.format(), values, asked.is_for());
}

std::string device_of_same_values::source() const {
  return other().source();
}

std::vector<option> device_of_same_values::options() const {
  return other().options();
}

void device_of_same_values::check(const selection& asked) const {
  of_other(asked);  // which checks it
}

std::unique_ptr<engine> device_of_same_values::make_bit(const selection& asked) const {
  return other().make_bit(of_other(asked));
}

std::int64_t device_of_same_values::rom_bits(const selection& asked) const {
  return other().rom_bits(of_other(asked));
}

word_lengths device_of_same_values::widths(const selection& asked) const {
  return other().widths(of_other(asked));
}

std::unique_ptr<engine> device_of_same_values::make_bit(const selection& asked,
                                                        const word_lengths& bits) const {
  return other().make_bit(of_other(asked), bits);
}

std::unique_ptr<engine> device_of_same_values::make_golden(const selection& asked) const {
  return other().make_golden(of_other(asked));
}

std::size_t device_of_same_values::enumerated() const {
  return other().enumerated();
}

std::vector<std::int64_t> device_of_same_values::corners(const selection& asked,
                                                         std::span<const std::int64_t> before) const {
  return other().corners(of_other(asked), before);
}

std::optional<selection> device_of_same_values::computes_as(const selection& asked) const {
  return of_other(asked);
}

}  // namespace blysk::specular
