// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/engines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "tb/harness/systemc_engine.h"

namespace blysk::cli {

using cosim::waves;

const std::vector<engine_choice>& engine_choices() {
  static const std::vector<engine_choice> choices{
      {"golden", "the device's formula in double", purpose::formula, false,
       [](const selection& asked, waves) { return asked.of().make_golden(asked); }},
      {"bit", "its laws on integers", purpose::hardware, false,
       [](const selection& asked, waves) { return asked.of().make_bit(asked); }},
      {"systemc", "its blocks under clock and strobes", purpose::hardware, true,
       [](const selection& asked, waves) -> std::unique_ptr<engine> { return harness::make_systemc(asked); }},
      {"verilator", "their exported Verilog", purpose::hardware, true,
       [](const selection& asked, waves recorded) -> std::unique_ptr<engine> {
         return cosim::make_verilator(asked, recorded);
       }}};
  return choices;
}

const engine_choice& find_engine(const std::string& name, const std::vector<std::string_view>& others) {
  const auto found = std::ranges::find(engine_choices(), name, &engine_choice::name);
  if (found != engine_choices().end()) return *found;
  std::vector<std::string_view> names;
  std::ranges::transform(engine_choices(), std::back_inserter(names), &engine_choice::name);
  std::ranges::copy(others, std::back_inserter(names));
  throw std::invalid_argument(
      fmt::format("engine {} does not exist, expected {}", name, fmt::join(names, ", ")));
}

}  // namespace blysk::cli
