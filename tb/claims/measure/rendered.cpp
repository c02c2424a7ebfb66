// SPDX-License-Identifier: Apache-2.0
// [T] on rendered pictures, as thesis_pictures found them: docs/tables/teapot_nmse.csv, segments.csv.
#include <fmt/format.h>

#include <array>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tb/claims/figure.h"

namespace blysk::claims {
namespace {

/// What follows in the row of a table whose first fields, joined by commas, are `key`.
std::vector<std::string> fields_after(const std::string& table, const std::string& key) {
  std::ifstream file(std::string(BLYSK_TABLES) + "/" + table);
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(key + ",")) continue;
    std::istringstream rest(line.substr(key.size() + 1));
    std::vector<std::string> fields;
    for (std::string field; std::getline(rest, field, ',');) fields.push_back(field);
    return fields;
  }
  throw std::runtime_error("no row " + key + " in docs/tables/" + table);
}

double number(const std::vector<std::string>& fields, std::size_t place) {
  return std::stod(fields.at(place));
}

}  // namespace

void measure_rendered(measurements& into) {
  into["T38"] = [] {
    constexpr std::array kScenes{"orange", "half", "white"};
    struct stated {
      const char* key;
      const char* lobe;
      const char* exponents;
    };
    constexpr std::array kStated{
        stated{"cq", "cosine-quadratic", "1,1000"}, stated{"schlick", "schlick-modified", "1,1000"},
        stated{"below_170", "quadratic-exact", "1,169"}, stated{"from_170", "quadratic-exact", "170,1000"}};
    figures result;
    for (const auto& [key, lobe, exponents] : kStated) {
      for (std::size_t s = 0; s < kScenes.size(); ++s) {
        const auto found = fields_after("teapot_nmse.csv", fmt::format("{},{},{}", lobe, s, exponents));
        const std::string name = fmt::format("{}_{}", key, kScenes[s]);
        result[name] = number(found, 0);
        result[name + "_n"] = number(found, 1);
      }
    }
    return result;
  };
  into["T54"] = [] {
    figures result;
    for (const char* scene : {"sphere", "teapot"}) {
      for (const char* measure : {"cie76", "rgb"}) {
        const auto found = fields_after("segments.csv", fmt::format("{},{},2.3,mean", scene, measure));
        const std::string key = fmt::format("{}_{}", scene, measure);
        result[key] = 100 * number(found, 0) / (number(found, 0) + number(found, 1));
        result[key + "_nmse"] = number(found, 2);
        result[key + "_largest"] = number(found, 3);
      }
    }
    const auto strict = fields_after("segments.csv", "teapot,cie76,0,mean");
    result["strict"] = 100 * number(strict, 0) / (number(strict, 0) + number(strict, 1));
    result["strict_largest"] = number(strict, 3);
    return result;
  };
}

}  // namespace blysk::claims
