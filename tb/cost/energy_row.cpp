// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/energy_row.h"

#include "tb/cost/cost_row.h"

namespace blysk::cost {
namespace {

using json = nlohmann::ordered_json;

switching_pair pair_of(const json& text) {
  const auto one = [&](const char* key) {
    return switching{text.at(key).at("toggles").get<double>(), text.at(key).at("pj").get<double>()};
  };
  return {one("with_delays"), one("without")};
}

}  // namespace

energy_row parse_energy_row(const std::string& path, const std::string& text) {
  const json row = parse_json(path, text);
  return read_stored(path, "a row of the target update_energy", [&] {
    energy_row made{row.at("device"), row.at("format"), row.at("digest"), row.at("options"), {}};
    for (const auto& [kind, use] : row.at("stimuli").items()) {
      energy_use& to = made.stimuli[kind];
      to.whole = pair_of(use);
      for (const auto& [block, each] : use.at("blocks").items()) to.blocks[block] = pair_of(each);
    }
    return made;
  });
}

}  // namespace blysk::cost
