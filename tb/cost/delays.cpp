// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/delays.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "tb/cost/cost_row.h"
#include "tb/cost/digest.h"
#include "tb/cost/measured.h"
#include "tb/formats_of_build.h"
#include "tb/usage_error.h"

namespace blysk::cost {
namespace {

using json = nlohmann::ordered_json;

constexpr const char* kMaker = "expected what scripts/synth --delays writes";
constexpr int kMostPs = 1'000'000;  // of one path through a block

/// The words of a line, separated by blanks.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    if (end > 0) words.push_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return words;
}

/// \throws std::domain_error unless it is a whole number from `low` to `high`
int number_of(std::string_view word, int low, int high) {
  int value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || value < low || value > high)
    throw std::domain_error(fmt::format("{} is no number from {} to {}", word, low, high));
  return value;
}

/// "d_i:9 clk:1"
std::string text_of(const std::vector<timed_pin>& pins) {
  std::string text;
  for (const timed_pin& each : pins)
    text += fmt::format("{}{}:{}", text.empty() ? "" : " ", each.name, each.width);
  return text;
}

std::vector<timed_pin> pins_of(const std::string& text) {
  std::vector<timed_pin> pins;
  for (const std::string_view word : words_of(text)) {
    const std::size_t colon = std::min(word.find(':'), word.size());
    pins.push_back({std::string(word.substr(0, colon)),
                    number_of(word.substr(std::min(colon + 1, word.size())), 1, 64)});
  }
  if (pins.empty()) throw std::domain_error("a block has no pins");
  return pins;
}

/// \throws std::domain_error unless it is a whole number above 0 that a path can take
int bound_of(const json& file, const char* key) {
  const json& value = file.at(key);
  if (!value.is_number_unsigned() || value == 0 || value > kMostPs)
    throw std::domain_error(fmt::format("{} is no time from 1 to {} ps", key, kMostPs));
  return value;
}

json json_of(const block_delays& of) {
  json result{{"inputs", text_of(of.inputs)}, {"outputs", text_of(of.outputs)}};
  json& rows = result["ps"] = json::object();
  for (std::size_t i = 0; i < of.outputs.size(); ++i) {
    for (std::size_t bit = 0; bit < of.ps[i].size(); ++bit) {
      std::string row;
      for (const int ps : of.ps[i][bit]) {
        if (!row.empty()) row += ' ';
        row += ps == block_delays::kNoPath ? "-" : fmt::format("{}", ps);
      }
      rows[fmt::format("{}[{}]", of.outputs[i].name, bit)] = row;
    }
  }
  return result;
}

block_delays block_of(const std::string& name, const json& from) {
  block_delays of{name, pins_of(from.at("inputs")), pins_of(from.at("outputs")), {}};
  const auto bits = static_cast<std::size_t>(of.input_bits());
  for (const timed_pin& output : of.outputs) {
    auto& rows = of.ps.emplace_back();
    for (int bit = 0; bit < output.width; ++bit) {
      const std::string line = from.at("ps").at(fmt::format("{}[{}]", output.name, bit));
      auto& row = rows.emplace_back();
      for (const std::string_view word : words_of(line))
        row.push_back(word == "-" ? block_delays::kNoPath : number_of(word, 0, kMostPs));
      if (row.size() != bits)
        throw std::domain_error(
            fmt::format("{}.{}[{}] has {} delays, not {}", name, output.name, bit, row.size(), bits));
    }
  }
  return of;
}

}  // namespace

nlohmann::ordered_json json_of(const device_delays& delays) {
  json result{{"device", delays.device}, {"format", delays.format}, {"options", delays.options},
              {"digest", delays.digest}, {"tools", delays.tools},   {"script", delays.script}};
  json& path = result["path_ps"] = json::array();
  for (const path_step& each : delays.path) path.push_back(fmt::format("{} {}", each.block, each.ps));
  result["bound_ps"] = delays.bound_ps;
  result["blocks_bound_ps"] = delays.blocks_bound_ps;
  json& blocks = result["blocks"] = json::object();
  for (const block_delays& each : delays.blocks) blocks[each.block] = json_of(each);
  return result;
}

device_delays parse_delays(const std::string& path, const std::string& text) {
  const json file = parse_json(path, text);
  try {
    device_delays result{file.at("device"),
                         file.at("format"),
                         file.at("options"),
                         file.at("digest"),
                         file.at("tools"),
                         file.at("script"),
                         {},
                         bound_of(file, "bound_ps"),
                         bound_of(file, "blocks_bound_ps"),
                         {}};
    if (result.blocks_bound_ps < result.bound_ps)
      throw std::domain_error("blocks_bound_ps is below bound_ps");
    for (const std::string line : file.at("path_ps")) {
      const auto words = words_of(line);
      if (words.size() != 2) throw std::domain_error("a step of the path is no block and a time");
      result.path.push_back({std::string(words[0]), number_of(words[1], 0, kMostPs)});
    }
    for (const auto& [name, block] : file.at("blocks").items())
      result.blocks.push_back(block_of(name, block));
    return result;
  } catch (const json::exception&) {
    throw file_error(path, 0, fmt::format("is damaged: a key is missing or of another type, {}", kMaker));
  } catch (const std::domain_error& error) {
    throw file_error(path, 0, fmt::format("is damaged: {}, {}", error.what(), kMaker));
  }
}

device_delays read_delays(const std::string& file, const selection& asked, const std::string& digest) {
  if (protocol_of(asked.of().ports(asked)) != protocol::strobes) {
    throw std::invalid_argument(fmt::format(
        "device {} takes its inputs by start and ready, expected one whose registers are written by "
        "strobes: no other has nets that take delays",
        asked.of().name()));
  }
  const std::string place = row_path("delays", asked);
  std::string path = file;
  std::string text;
  if (file.empty()) {
    const auto all = embedded_files();
    const auto found = std::ranges::find(all, place, &measured_file::path);
    if (found == all.end()) {
      throw std::invalid_argument(fmt::format(
          "the delays of device {} in format {}{} were not measured, expected --delays FILE; "
          "scripts/synth --delays measures them",
          asked.of().name(), asked.format(), given_options(asked).empty() ? "" : " with these options"));
    }
    path = "docs/tables/" + place;
    text = found->text;
  } else {
    text = read_text(file);
  }
  device_delays delays = parse_delays(path, text);
  delays.file = path;
  if (delays.device != asked.of().name() || delays.format != asked.format() ||
      delays.options != given_options(asked)) {
    throw file_error(
        path, 0,
        fmt::format("has the delays of device {}, format {}{}, expected those of device {}, format {}{}",
                    delays.device, delays.format, delays.options.empty() ? "" : " with options",
                    asked.of().name(), asked.format(),
                    given_options(asked).empty() ? "" : " with the options given"));
  }
  if (delays.digest != digest) {
    throw file_error(path, 0,
                     fmt::format("belongs to another Verilog ({}), expected the digest {}; scripts/synth "
                                 "--delays measures again",
                                 delays.digest, digest));
  }
  return delays;
}

std::string digest_of(const selection& asked) {
  expect_in_build(asked.format());
  std::string digest = exported_digests({asked}).front();
  if (digest.empty()) throw std::runtime_error("the device's Verilog cannot be exported");
  return digest;
}

}  // namespace blysk::cost
