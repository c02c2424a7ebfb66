// SPDX-License-Identifier: Apache-2.0
#include "tb/cosim/verilator_engine.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "tb/cosim/verilated_table.h"
#include "tb/harness/arguments.h"

namespace blysk::cosim {

namespace {

/// "--energy --stages 4": the options that differ from the presets, in the device's order.
std::string further_options(const selection& asked) {
  std::string text;
  for (const option& each : asked.of().options()) {
    const std::string& value = asked.value(each.name);
    if (value == each.preset) continue;
    text += fmt::format(" --{}{}", each.name, each.is_flag() ? "" : " " + value);
  }
  return text;
}

/// The options of the classes that are compiled in for the device and format besides that of the presets.
std::string compiled_options(std::span<const verilated_entry> table, const selection& asked) {
  std::string text;
  for (const verilated_entry& each : table) {
    if (!each.name.starts_with(asked.folder_name() + " ")) continue;
    text += fmt::format(" or with{}", each.name.substr(asked.folder_name().size()));
  }
  return text;
}

const verilated_entry& find_entry(std::span<const verilated_entry> table, const selection& asked,
                                  waves recorded) {
  const std::string options = further_options(asked);
  const auto found = std::ranges::find(table, asked.folder_name() + options, &verilated_entry::name);
  if (found != table.end()) return *found;
  if (!options.empty()) {
    throw std::invalid_argument(
        fmt::format("engine verilator has {}device {} compiled in with its presets ({}){}, expected those; "
                    "export the device for others",
                    recorded == waves::on ? "waves of " : "", asked.of().name(),
                    choose(asked.of().name(), asked.format()).text(), compiled_options(table, asked)));
  }
  std::vector<std::string_view> formats;
  for (const std::string_view format : format_names) {
    const selection other = choose(asked.of().name(), std::string(format));
    if (std::ranges::find(table, other.folder_name(), &verilated_entry::name) != table.end())
      formats.push_back(format);
  }
  throw std::invalid_argument(fmt::format("engine verilator has no {}device {} in format {}, expected {}",
                                          recorded == waves::on ? "waves of " : "", asked.of().name(),
                                          asked.format(),
                                          formats.empty() ? "a build with Verilator; scripts/build makes one"
                                                          : fmt::format("{}", fmt::join(formats, ", "))));
}

}  // namespace

std::unique_ptr<verilator_engine> make_verilator(const selection& asked, waves recorded) {
  auto made = find_entry(recorded == waves::on ? traced_table() : exported_table(), asked, recorded).make();
  made->set_device(asked);
  return made;
}

}  // namespace blysk::cosim
