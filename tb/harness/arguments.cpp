// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/arguments.h"

#include <fmt/format.h>

namespace blysk::harness {

std::string arguments_of(const selection& asked) {
  std::string text = fmt::format("--device {} --format {}", asked.of().name(), asked.format());
  for (const option& each : asked.of().options()) {
    if (asked.value(each.name) == each.preset) continue;
    text += each.is_flag() ? fmt::format(" --{}", each.name)
                           : fmt::format(" --{} {}", each.name, asked.value(each.name));
  }
  return text;
}

}  // namespace blysk::harness
