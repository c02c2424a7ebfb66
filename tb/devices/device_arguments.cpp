// SPDX-License-Identifier: Apache-2.0
#include "tb/device_arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace blysk {
namespace {

/// An option of the command line: what the devices that have it say of it.
struct shared_option {
  struct owner {
    std::string device;
    option own;
  };
  std::vector<owner> owners;

  const option& first() const { return owners.front().own; }
};

std::vector<shared_option> all_options() {
  std::vector<shared_option> all;
  for (const device* each : devices()) {
    for (const option& own : each->options()) {
      auto known = std::ranges::find(all, own.name, [](const shared_option& of) { return of.first().name; });
      if (known == all.end()) known = all.insert(all.end(), shared_option{});
      known->owners.push_back({each->name(), own});
    }
  }
  return all;
}

/// "[derived]: derived, published", and what engine golden takes besides.
std::string values_of(const option& own, purpose is_for) {
  if (own.is_flag()) return {};
  if (own.values.empty()) return own.preset.empty() ? "" : fmt::format(" [{}]", own.preset);
  std::string text = fmt::format(" [{}]: {}", own.preset, fmt::join(own.values, ", "));
  if (is_for == purpose::formula && !own.formula_values.empty())
    text += fmt::format("; engine golden also {}", fmt::join(own.formula_values, ", "));
  return text;
}

/// Devices that say the same of it and take the same values are named together.
std::string help_of(const shared_option& of, purpose is_for) {
  struct group {
    std::string help, values, devices;
  };
  std::vector<group> groups;
  for (const auto& [device, own] : of.owners) {
    std::string help = own.help;
    if (is_for == purpose::formula && own.is_wired) help += "; not for engine golden";
    const std::string values = values_of(own, is_for);
    const auto known = std::ranges::find_if(
        groups, [&](const group& each) { return each.help == help && each.values == values; });
    if (known == groups.end()) {
      groups.push_back(group{help, values, device});
    } else {
      known->devices += ", " + device;
    }
  }
  std::string text;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto& [help, values, names] = groups[i];
    if (i > 0) text += values.empty() || help != groups[i - 1].help ? "; " : ";";
    if (i == 0 || help != groups[i - 1].help) text += help;
    text += fmt::format("{} (of {})", values, names);
  }
  return text;
}

}  // namespace

std::string asked_device::export_name() const {
  std::string name = device;
  std::ranges::replace(name, '-', '_');
  return fmt::format("blysk_{}_{}", name, format);
}

void add_device_arguments(CLI::App& verb, asked_device& arguments, purpose is_for,
                          const std::function<bool(const device&)>& takes) {
  std::vector<std::string> names;
  for (const device* each : devices()) {
    if (takes && !takes(*each)) continue;
    std::string with_aliases;
    for (const device_alias& other : each->aliases())
      with_aliases += (with_aliases.empty() ? " or " : ", ") + other.name;
    names.push_back(each->name() + with_aliases);
  }
  verb.add_option("--device", arguments.device, fmt::format("{}", fmt::join(names, ", ")))
      ->capture_default_str();
  verb.add_option("--format", arguments.format,
                  fmt::format("fraction bits of the cosine: {}", fmt::join(format_names, ", ")))
      ->capture_default_str();
  for (const shared_option& each : all_options()) {
    const std::string& name = each.first().name;
    const auto is_flag = [](const shared_option::owner& of) { return of.own.is_flag(); };
    if (std::ranges::all_of(each.owners, is_flag)) {
      verb.add_flag_callback(
              "--" + name, [&arguments, name] { arguments.options[name] = "on"; }, help_of(each, is_for))
          ->disable_flag_override();  // "--flag=false" would not reach a device that has no such flag
      continue;
    }
    CLI::Option* const added = verb.add_option_function<std::string>(
        "--" + name,
        [&arguments, name](const std::string& value) {
          if (value.starts_with("--"))
            throw std::invalid_argument(fmt::format("--{} is followed by {}, expected a value", name, value));
          arguments.options[name] = value.empty() ? "on" : value;
        },
        help_of(each, is_for));
    // A flag of some device has no value.
    if (std::ranges::any_of(each.owners, is_flag)) added->expected(0, 1);
  }
}

}  // namespace blysk
