// SPDX-License-Identifier: Apache-2.0
#include "tb/wave_values.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace blysk {

std::string value_name(const port& of) {
  const bool has_value =
      of.carries && (of.is == port::role::result || (of.is == port::role::data && of.carries->frac > 0));
  return has_value ? of.column + "_real" : "";
}

std::size_t error_port(const std::vector<port>& ports) {
  const auto found = std::ranges::find_if(
      ports, [](const port& each) { return each.is == port::role::result && each.column == "brdf"; });
  return found == ports.end() ? find_role(ports, port::role::result)
                              : static_cast<std::size_t>(found - ports.begin());
}

wave_values::wave_values(const std::vector<port>& ports, std::unique_ptr<engine> golden)
    : ports_(ports), talks_(protocol_of(ports)), golden_(std::move(golden)), row_(ports, port::role::data) {
  if (talks_ == protocol::none) throw std::logic_error("the device's ports are not those of a protocol");
  row_.resize(1);
  reset_ = find_role(ports_, port::role::reset);
  valid_ = find_role(ports_, port::role::valid);
  if (talks_ == protocol::handshake) {
    start_ = find_role(ports_, port::role::start);
    ready_ = find_role(ports_, port::role::ready);
  }
  const auto number_of = [&](std::size_t index) {
    return number{index, std::ldexp(1.0, -ports_[index].carries->frac)};
  };
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    if (std::string name = value_name(ports_[i]); !name.empty()) {
      names_.push_back(std::move(name));
      numbers_.push_back(number_of(i));
    }
    if (ports_[i].is != port::role::data) continue;
    const auto strobe = std::ranges::find_if(ports_, [&](const port& each) {
      return each.is == port::role::strobe && each.writes == ports_[i].name;
    });
    registers_.push_back({i, static_cast<std::size_t>(strobe - ports_.begin()), *ports_[i].carries});
  }
  const std::size_t error = error_port(ports_);
  error_ = number_of(error);
  error_column_ = static_cast<std::size_t>(
      std::count_if(ports_.begin(), ports_.begin() + static_cast<std::ptrdiff_t>(error),
                    [](const port& each) { return each.is == port::role::result; }));
  names_.emplace_back(kErrorName);
  values_.resize(names_.size());
}

void wave_values::rise(std::span<const std::int64_t> levels) {
  if (levels[reset_] == 0) {
    for (data_register& each : registers_) {
      each.held = 0;
      each.was_up = false;
    }
    expected_.clear();
    return;
  }
  if (talks_ == protocol::strobes) {
    load(levels);
    return;
  }
  if (levels[valid_] != 0 && !expected_.empty()) expected_.pop_front();
  if (levels[start_] == 0 || levels[ready_] == 0) return;
  for (data_register& each : registers_) each.held = levels[each.port];
  evaluate();
}

// Registers with strobes: rtl_sysc/blocks has the same law between ports.
void wave_values::load(std::span<const std::int64_t> levels) {
  bool is_changed = false;
  for (data_register& each : registers_) {
    const bool is_up = levels[each.strobe] != 0;
    const bool is_trailing = ports_[each.strobe].edge == write_edge::trailing;
    if ((is_trailing ? each.was_up && !is_up : is_up) && each.held != levels[each.port]) {
      each.held = levels[each.port];
      is_changed = true;
    }
    each.was_up = is_up;
  }
  if (!is_changed) return;
  expected_.clear();
  evaluate();
}

/// Appends what the formula makes of the row that the registers hold.
void wave_values::evaluate() {
  for (std::size_t i = 0; i < registers_.size(); ++i) {
    const data_register& from = registers_[i];
    if (from.held < from.carries.min || from.held > from.carries.max) return;
    row_[i].set(0, from.held);
  }
  golden_->run(row_, formula_);
  for (std::size_t i = 0; i < formula_.size(); ++i) expected_.push_back(formula_[error_column_].real(i));
}

std::span<const double> wave_values::at(std::span<const std::int64_t> levels) {
  std::ranges::transform(numbers_, values_.begin(), [&](const number& each) {
    return static_cast<double>(levels[each.port]) * each.ulp;
  });
  const bool is_compared = !expected_.empty() && (talks_ == protocol::strobes || levels[valid_] != 0);
  values_.back() =
      is_compared ? static_cast<double>(levels[error_.port]) * error_.ulp - expected_.front() : 0;
  return values_;
}

}  // namespace blysk
