// SPDX-License-Identifier: Apache-2.0
#include "tb/device_arguments.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace blysk {
namespace {

/// An option of the command line: what the devices that have it say of it.
struct shared_option {
  option first;
  std::vector<std::string> owners;
};

std::vector<shared_option> all_options() {
  std::vector<shared_option> all;
  for (const device* each : devices()) {
    for (const option& own : each->options()) {
      const auto known =
          std::ranges::find(all, own.name, [](const shared_option& of) { return of.first.name; });
      if (known == all.end()) {
        all.push_back({own, {each->name()}});
      } else {
        known->owners.push_back(each->name());
      }
    }
  }
  return all;
}

std::string help_of(const shared_option& of, purpose is_for) {
  std::string text = of.first.help;
  if (is_for == purpose::formula && of.first.is_wired) text += "; not for engine golden";
  if (!of.first.is_flag() && !of.first.values.empty()) {
    text += fmt::format(" [{}]: {}", of.first.preset, fmt::join(of.first.values, ", "));
    if (is_for == purpose::formula && !of.first.formula_values.empty())
      text += fmt::format("; engine golden also {}", fmt::join(of.first.formula_values, ", "));
  }
  return fmt::format("{} (of {})", text, fmt::join(of.owners, ", "));
}

}  // namespace

void add_device_arguments(CLI::App& verb, asked_device& arguments, purpose is_for) {
  std::vector<std::string> names;
  std::ranges::transform(devices(), std::back_inserter(names),
                         [](const device* each) { return each->name(); });
  verb.add_option("--device", arguments.device, fmt::format("{}", fmt::join(names, ", ")))
      ->capture_default_str();
  verb.add_option("--format", arguments.format,
                  fmt::format("fraction bits of the cosine: {}", fmt::join(format_names, ", ")))
      ->capture_default_str();
  for (const shared_option& each : all_options()) {
    const std::string& name = each.first.name;
    if (each.first.is_flag()) {
      verb.add_flag_callback(
          "--" + name, [&arguments, name] { arguments.options[name] = "on"; }, help_of(each, is_for));
    } else {
      verb.add_option_function<std::string>(
          "--" + name, [&arguments, name](const std::string& value) { arguments.options[name] = value; },
          help_of(each, is_for));
    }
  }
}

}  // namespace blysk
