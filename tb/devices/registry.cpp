// SPDX-License-Identifier: Apache-2.0
#include "tb/device.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "tb/netlist/elaborated.h"
#include "tb/visit_format.h"

namespace blysk {

// Each is defined in its device's folder.
#define BLYSK_DEVICE(identifier, name) \
  namespace identifier##_device {      \
    const device& instance();          \
  }
#include "tb/devices/devices.def"
#undef BLYSK_DEVICE

const std::vector<const device*>& devices() {
  static const std::vector<const device*> all{
#define BLYSK_DEVICE(identifier, name) &identifier##_device::instance(),
#include "tb/devices/devices.def"
#undef BLYSK_DEVICE
  };
  return all;
}

// Defined in devices/per_format.cpp, which is compiled once for each format.
template <class Q>
std::vector<port> ports_in(const selection& asked);
template <class Q>
std::unique_ptr<netlist::elaborated> elaborate_in(const selection& asked, double clock_period_ns);

std::vector<port> device::ports(const selection& asked) const {
  return visit_format(asked.format(), [&]<class Q>() { return ports_in<Q>(asked); });
}

std::unique_ptr<netlist::elaborated> device::elaborate(const selection& asked, double clock_period_ns) const {
  return visit_format(asked.format(), [&]<class Q>() { return elaborate_in<Q>(asked, clock_period_ns); });
}

int device::cycles_per_row(const selection& asked) const {
  int cycles = 1;
  for (const port& each : ports(asked)) {
    if (each.is == port::role::valid) cycles += each.settling_cycles;
    if (each.is == port::role::strobe && each.edge == write_edge::trailing) ++cycles;
  }
  return cycles;
}

std::optional<int> device::latency_cycles(const selection& asked) const {
  const std::vector<port> all = ports(asked);
  const auto confirms = of_role(all, port::role::valid);
  if (confirms.empty() || draws_lines()) return std::nullopt;
  if (protocol_of(all) == protocol::handshake)
    return computes_as(asked) ? std::optional(confirms.front().settling_cycles) : std::nullopt;
  const bool by_trailing_edge = std::ranges::any_of(
      of_role(all, port::role::strobe), [](const port& each) { return each.edge == write_edge::trailing; });
  return (by_trailing_edge ? 2 : 1) + confirms.front().settling_cycles;
}

std::string device::identifier() const {
  std::string result = name();
  std::ranges::replace(result, '-', '_');
  return result;
}

int selection::fraction() const {
  int bits = 0;
  std::from_chars(format_.data() + 1, format_.data() + format_.size(), bits);
  return bits;
}

bool selection::is_preset() const {
  return std::ranges::all_of(device_->options(),
                             [this](const option& each) { return value(each.name) == each.preset; });
}

std::string selection::folder_name() const {
  return device_->identifier() + "_" + format_;
}

std::string selection::top_name() const {
  return "blysk_" + folder_name();
}

std::string selection::text() const {
  const std::string words = device_->words(*this);
  return fmt::format("device {}, format {}{}{}", device_->name(), format_, words.empty() ? "" : ", ", words);
}

std::pair<const device*, std::map<std::string, std::string>> find_device(const std::string& name) {
  std::vector<std::string> names;
  for (const device* each : devices()) {
    if (each->name() == name) return {each, {}};
    names.push_back(each->name());
    for (device_alias& other : each->aliases()) {
      if (other.name == name) return {each, std::move(other.options)};
      names.push_back(std::move(other.name));
    }
  }
  throw std::invalid_argument(
      fmt::format("device {} does not exist, expected {}", name, fmt::join(names, ", ")));
}

namespace {

void check_value(const option& known, const std::string& value, purpose is_for) {
  if (is_for == purpose::formula && known.is_wired && value != known.preset) {
    throw std::invalid_argument(
        fmt::format("--{} chooses wires and engine golden has none, expected another engine", known.name));
  }
  if (known.values.empty() || std::ranges::find(known.values, value) != known.values.end()) return;
  if (std::ranges::find(known.formula_values, value) != known.formula_values.end()) {
    if (is_for == purpose::formula) return;
    throw std::invalid_argument(fmt::format("--{} {} has no wires, expected {}, or engine golden", known.name,
                                            value, fmt::join(known.values, ", ")));
  }
  std::vector<std::string> allowed = known.values;
  if (is_for == purpose::formula) std::ranges::copy(known.formula_values, std::back_inserter(allowed));
  throw std::invalid_argument(
      fmt::format("--{} is {}, expected {}", known.name, value, fmt::join(allowed, ", ")));
}

}  // namespace

selection choose(const std::string& device_name, const std::string& format,
                 const std::map<std::string, std::string>& options, purpose is_for) {
  selection chosen;
  auto [found_device, fixed] = find_device(device_name);
  chosen.device_ = found_device;
  chosen.purpose_ = is_for;
  if (std::ranges::find(format_names, format) == std::end(format_names)) {
    throw std::invalid_argument(
        fmt::format("format {} does not exist, expected {}", format, fmt::join(format_names, ", ")));
  }
  chosen.format_ = format;
  const std::vector<option> known = chosen.device_->options();
  for (const option& each : known) chosen.values_[each.name] = each.preset;
  for (const auto& [name, value] : fixed) chosen.values_[name] = value;
  for (const auto& [name, value] : options) {
    const auto found = std::ranges::find(known, name, &option::name);
    if (found == known.end()) {
      std::vector<std::string> names;
      std::ranges::transform(known, std::back_inserter(names),
                             [](const option& each) { return fmt::format("--{}", each.name); });
      throw std::invalid_argument(
          fmt::format("device {} has no option --{}, expected {}", device_name, name,
                      names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
    }
    check_value(*found, value, is_for);
    if (const auto own = fixed.find(name); own != fixed.end() && own->second != value)
      throw std::invalid_argument(fmt::format("device {} has {} {}, expected no --{} {}", device_name, name,
                                              own->second, name, value));
    chosen.values_[name] = value;
  }
  chosen.device_->check(chosen);
  chosen.values_ = chosen.device_->canonical(chosen);
  return chosen;
}

}  // namespace blysk
