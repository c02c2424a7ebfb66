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

const verilated_entry& find_entry(std::span<const verilated_entry> table, const selection& asked,
                                  waves recorded) {
  const auto found = std::ranges::find(table, asked.folder_name(), &verilated_entry::folder);
  if (found != table.end()) return *found;
  std::vector<std::string_view> formats;
  for (const std::string_view format : format_names) {
    const selection other = choose(asked.of().name(), std::string(format));
    if (std::ranges::find(table, other.folder_name(), &verilated_entry::folder) != table.end())
      formats.push_back(format);
  }
  throw std::invalid_argument(
      fmt::format("engine verilator has no {}device {} in format {}, expected {}",
                  recorded == waves::on ? "waves of " : "", asked.of().name(), asked.format(),
                  formats.empty() ? "a build with Verilator" : fmt::format("{}", fmt::join(formats, ", "))));
}

}  // namespace

std::unique_ptr<verilator_engine> make_verilator(const selection& asked, waves recorded) {
  if (!asked.is_preset()) {
    throw std::invalid_argument(fmt::format(
        "engine verilator has the presets compiled in ({}), expected those; export the device for others",
        choose(asked.of().name(), asked.format()).text()));
  }
  auto made = find_entry(recorded == waves::on ? traced_table() : exported_table(), asked, recorded).make();
  made->set_device(asked);
  return made;
}

}  // namespace blysk::cosim
