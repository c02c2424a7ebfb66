// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/cost_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "tb/line_reader.h"
#include "tb/output_file.h"
#include "tb/usage_error.h"

namespace blysk::cost {
namespace {

using json = nlohmann::ordered_json;

std::vector<double> sorted(std::vector<double> values) {
  std::ranges::sort(values);
  return values;
}

json json_of(const origin& from) {
  return {{"digest", from.digest}, {"tools", from.tools}, {"script", from.script}};
}

json json_of(const ice40_cells& cells) {
  json result = json_of(cells.from);
  result["lut"] = cells.lut;
  result["carry"] = cells.carry;
  result["ff"] = cells.ff;
  result["dsp"] = cells.dsp;
  result["ram_bits"] = cells.ram_bits;
  return result;
}

json json_of(const placement& placed) {
  json result = json_of(placed.from);
  result["part"] = placed.part;
  result["seeds"] = placed.seeds;
  result["fmax_mhz"] = placed.fmax_mhz;
  return result;
}

json json_of(const standard_cells& cells) {
  json result = json_of(cells.from);
  result["cells"] = cells.cells;
  result["area_nand2"] = cells.area_nand2;
  result["path_ns"] = cells.path_ns;
  return result;
}

origin origin_of(const json& of) {
  return {of.at("digest"), of.at("tools"), of.at("script")};
}

ice40_cells ice40_of(const json& of) {
  return {origin_of(of),      count_of(of, "lut"), count_of(of, "carry"),
          count_of(of, "ff"), count_of(of, "dsp"), count_of(of, "ram_bits")};
}

placement placement_of(const json& of) {
  placement placed{origin_of(of), of.at("part"), of.at("seeds"), of.at("fmax_mhz")};
  const bool counts =
      placed.fmax_mhz.size() == placed.seeds.size() && !placed.seeds.empty() &&
      std::ranges::all_of(placed.fmax_mhz, [](double mhz) { return std::isfinite(mhz) && mhz > 0; });
  if (!counts) throw std::domain_error("fmax_mhz is not one clock above zero for each seed");
  return placed;
}

standard_cells standard_cells_of(const json& of) {
  return {origin_of(of), count_of(of, "cells"), positive_of(of, "area_nand2"), positive_of(of, "path_ns")};
}

template <class Part>
void take(const json& row, const char* key, std::optional<Part>& part, Part (*read)(const json&)) {
  if (row.contains(key)) part = read(row.at(key));
}

}  // namespace

std::int64_t count_of(const json& of, const char* key) {
  const json& value = of.at(key);
  if (!value.is_number_integer() || value.get<std::int64_t>() < 0)
    throw std::domain_error(fmt::format("{} is no count", key));
  return value;
}

double positive_of(const json& of, const char* key) {
  const double value = of.at(key);
  if (!(std::isfinite(value) && value > 0)) throw std::domain_error(fmt::format("{} is not above zero", key));
  return value;
}

double placement::least() const {
  return std::ranges::min(fmax_mhz);
}

double placement::median() const {
  return sorted(fmax_mhz)[(fmax_mhz.size() - 1) / 2];
}

double placement::most() const {
  return std::ranges::max(fmax_mhz);
}

std::map<std::string, std::string> given_options(const selection& asked) {
  std::map<std::string, std::string> given;
  for (const option& each : asked.of().options()) {
    if (asked.value(each.name) != each.preset) given[each.name] = asked.value(each.name);
  }
  return given;
}

std::string option_words(const std::map<std::string, std::string>& options) {
  std::string words;
  for (const auto& [name, value] : options)
    words += fmt::format(" --{}{}", name, value == "on" ? "" : " " + value);
  return words;
}

std::string row_path(const std::string& kind, const selection& asked) {
  std::string path = fmt::format("{}/{}_{}", asked.of().identifier(), kind, asked.format());
  for (const auto& [name, value] : given_options(asked))
    path += value == "on" ? fmt::format("_{}", name) : fmt::format("_{}_{}", name, value);
  return path + ".json";
}

nlohmann::ordered_json json_of(const cost_row& row) {
  json result{{"device", row.device}, {"format", row.format}, {"options", row.options}};
  const auto add = [&](const char* key, const auto& part) {
    if (part) result[key] = json_of(*part);
  };
  add("ice40", row.ice40);
  add("ice40_dsp", row.ice40_dsp);
  add("hx8k", row.hx8k);
  add("osu018", row.osu018);
  return result;
}

nlohmann::ordered_json parse_json(const std::string& path, const std::string& text,
                                  const std::string& expected) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
    throw file_error(path, 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n')),
                     "is damaged, expected " + expected);
  } catch (const json::out_of_range&) {
    throw file_error(path, 0, "is damaged: a number is beyond 1.8e308, expected " + expected);
  }
}

cost_row parse_cost_row(const std::string& path, const std::string& text) {
  const json row = parse_json(path, text);
  return read_stored(path, "a row of scripts/synth", [&] {
    cost_row result{row.at("device"), row.at("format"), row.at("options"), {}, {}, {}, {}};
    take(row, "ice40", result.ice40, ice40_of);
    take(row, "ice40_dsp", result.ice40_dsp, ice40_of);
    take(row, "hx8k", result.hx8k, placement_of);
    take(row, "osu018", result.osu018, standard_cells_of);
    constexpr std::array kKnown{"device", "format", "options", "ice40", "ice40_dsp", "hx8k", "osu018"};
    for (const auto& [key, value] : row.items()) {
      if (std::ranges::find(kKnown, key) == kKnown.end())
        throw std::domain_error(fmt::format("'{}' is no part of it", shown(key)));
    }
    return result;
  });
}

usage_error damaged(const std::string& path, const std::string& what, const std::string& expected) {
  return file_error(path, 0, fmt::format("is damaged: {}, expected {}", what, expected));
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  // A folder can be opened, but not read.
  if (!file || (file.peek() != std::ifstream::traits_type::eof() && !(text << file.rdbuf())) || file.bad())
    throw file_error(path, 0, fmt::format("cannot be read ({}), expected a file", system_reason()));
  return text.str();
}

void write_text(const std::string& path, const std::string& text) {
  output_file file(path);
  file.write(text);
  file.close();
  file.commit();
}

std::string stored_text(const nlohmann::ordered_json& json) {
  return json.dump(2) + "\n";
}

}  // namespace blysk::cost
