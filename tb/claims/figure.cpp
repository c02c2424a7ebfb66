// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/figure.h"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace blysk::claims {

double in_percent(double share) {
  return std::abs(share) < kRounding ? 0 : 100 * share;
}

std::string print(const figure& value, const std::string& spec) {
  if (const auto* words = std::get_if<std::string>(&value)) return *words;
  double number = std::get<double>(value);
  if (std::abs(number) < kRounding) number = 0;
  return fmt::format(fmt::runtime("{:" + spec + "}"), number);
}

std::map<std::string, std::string> print_all(const claim& c, const figures& measured) {
  std::map<std::string, std::string> result;
  for (const auto& [key, spec] : placeholders(c.measured)) {
    const auto found = measured.find(key);
    if (found == measured.end()) throw std::runtime_error("row " + c.id + ": {" + key + "} is not measured");
    result[key] = print(found->second, spec);
  }
  for (const auto& [key, value] : measured) {
    if (!result.contains(key)) throw std::runtime_error("row " + c.id + ": its text lacks {" + key + "}");
  }
  return result;
}

std::string to_json(const figure_list& list) {
  return nlohmann::json(list).dump(1) + "\n";
}

figure_list load_figures(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file.string() + ": cannot be read");
  try {
    return nlohmann::json::parse(in).get<figure_list>();
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

const measurements& all_measurements() {
  static const measurements result = [] {
    measurements all;
    for (const auto& add :
         {measure_patent, measure_article, measure_relative_errors, measure_absolute_errors, measure_energy,
          measure_pictures, measure_rendered, measure_settling, measure_whole_numbers, measure_errata})
      add(all);
    return all;
  }();
  return result;
}

figure_list measure_all() {
  figure_list result;
  for (const auto& section : all_claims()) {
    for (const claim& c : section.rows) {
      const auto found = all_measurements().find(c.id);
      auto printed = print_all(c, found == all_measurements().end() ? figures{} : found->second());
      if (!printed.empty()) result[c.id] = std::move(printed);
    }
  }
  return result;
}

}  // namespace blysk::claims
