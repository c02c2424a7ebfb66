// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/measured.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tb/cost/digest.h"
#include "tb/formats_of_build.h"
#include "tb/usage_error.h"

namespace blysk::cost {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

struct named_text {
  std::string path, text;
};

/// \param name  "cost_q8.json"
bool is_row(const std::string& name) {
  return name.ends_with(".json") &&
         (name.starts_with("cost_") || name.starts_with("errors_") || name.starts_with("energy_") ||
          name.starts_with("reference_") || name.starts_with("roundings_"));
}

constexpr const char* kHostTimes = "host_times.json";

std::vector<named_text> texts_of(const std::string& folder) {
  std::vector<named_text> texts;
  if (folder.empty()) {
    for (const measured_file& each : embedded_files())
      texts.push_back({std::string(each.path), std::string(each.text)});
    return texts;
  }
  for (const std::string& path : measured_paths(folder)) texts.push_back({path, read_text(path)});
  if (texts.empty())
    throw file_error(folder, 0, "holds no measured rows, expected cost_*.json or errors_*.json");
  return texts;
}

/// The configuration of a row, a new one if there is none yet.
/// \throws usage_error if the program has no such device, format or option
configuration& find_or_add(std::vector<configuration>& all, const std::string& path,
                           const std::string& device, const std::string& format,
                           const std::map<std::string, std::string>& options) {
  const auto found = std::ranges::find_if(all, [&](const configuration& each) {
    return each.asked.of().name() == device && each.asked.format() == format &&
           given_options(each.asked) == options;
  });
  if (found != all.end()) return *found;
  try {
    all.push_back({.asked = choose(device, format, options)});
    return all.back();
  } catch (const std::invalid_argument& error) {
    throw file_error(path, 0, fmt::format("is no row of this program: {}", error.what()));
  }
}

/// A row stands in the file that its name says, and no other does for that configuration: the last one would win.
void expect_name(const std::string& path, const std::string& kind, const selection& asked, bool is_known) {
  if (is_known)
    throw file_error(path, 0, fmt::format("is one more {} row of {}, expected one", kind, asked.text()));
  const std::string expected = fs::path(row_path(kind, asked)).filename().string();
  if (fs::path(path).filename() != expected)
    throw file_error(path, 0, fmt::format("is a row of another name, expected {}", expected));
}

void add_errors(std::vector<configuration>& all, const named_text& file) {
  const json row = parse_json(file.path, file.text);
  read_stored(file.path, "a row of the target update_errors", [&] {
    configuration& of = find_or_add(all, file.path, row.at("device"), row.at("format"), row.at("options"));
    expect_name(file.path, "errors", of.asked, of.errors.has_value());
    of.errors = parse_errors(file.path, row.at("domains"));
  });
}

void add_roundings(std::vector<configuration>& all, const named_text& file) {
  const json rows = parse_json(file.path, file.text);
  read_stored(file.path, "rows of the target update_roundings", [&] {
    // The built rounding's row alone knows the format.
    const json& first = rows.at(0);
    find_or_add(all, file.path, first.at("device"), first.at("format"), first.at("options")).roundings = rows;
  });
}

void add_host_times(std::vector<configuration>& all, const named_text& file) {
  const json times = parse_json(file.path, file.text);
  read_stored(file.path, "what the target update_host_times writes", [&] {
    for (const json& row : times.at("rows")) {
      const std::string device = row.at("device"), format = row.at("format");
      const host_time time{positive_of(row, "seconds"), positive_of(row, "ratio")};
      for (configuration& each : all) {
        if (each.asked.of().name() == device && each.asked.format() == format && each.asked.is_preset())
          each.host[row.at("engine")] = time;
      }
    }
  });
}

std::size_t place_of(const std::string& format) {
  return static_cast<std::size_t>(std::ranges::find(format_names, format) - std::begin(format_names));
}

std::size_t place_of(const device& of) {
  return static_cast<std::size_t>(std::ranges::find(devices(), &of) - devices().begin());
}

/// The part was measured of another Verilog.
template <class Part>
bool differs(const std::optional<Part>& part, const std::string& digest) {
  return part && part->from.digest != digest;
}

}  // namespace

std::optional<int> configuration::latency_cycles() const {
  return is_in_build(asked.format()) ? asked.of().latency_cycles(asked) : std::nullopt;
}

int configuration::cycles_per_result() const {
  if (!is_in_build(asked.format())) return 0;
  const bool is_steady = asked.of().draws_lines() || asked.of().latency_cycles(asked).has_value();
  return is_steady ? asked.of().cycles_per_row(asked) : 0;
}

double configuration::results_per_us(double mhz) const {
  const int cycles = cycles_per_result();
  return cycles > 0 ? mhz / cycles : 0;
}

double configuration::ice40_mhz() const {
  return cost.hx8k ? cost.hx8k->least() : 0;
}

double configuration::energy_pj() const {
  if (!energy) return 0;
  const auto found = energy->stimuli.find("sphere");
  return found == energy->stimuli.end() ? 0 : found->second.whole.with_delays.pj;
}

double configuration::asic_mhz() const {
  return cost.osu018 ? 1e3 / cost.osu018->path_ns : 0;
}

std::string configuration::command() const {
  const std::string words = option_words(given_options(asked));
  const std::string hardware = fmt::format("scripts/synth {} {}{}", asked.of().name(), asked.format(), words);
  if (!is_judged(asked)) return hardware;
  return fmt::format("{} && build/bin/blysk explore --measure --device {} --format {}{}", hardware,
                     asked.of().name(), asked.format(), words);
}

bool configuration::has_errors_in(domain where) const {
  return errors && errors_in(where).points > 0;
}

const cost::errors& configuration::errors_in(domain where) const {
  return errors->at(static_cast<std::size_t>(where));
}

std::string configuration::label() const {
  std::string text = asked.of().name() + " " + asked.format();
  for (const auto& [name, value] : given_options(asked))
    text += value == "on" ? fmt::format(", {}", name) : fmt::format(", {} {}", name, value);
  return text;
}

std::vector<std::string> measured_paths(const std::string& folder) {
  std::vector<std::string> paths;
  if (folder.empty()) return paths;
  std::error_code failed;
  if (!fs::is_directory(folder, failed)) {
    throw file_error(
        folder, 0,
        failed && failed != std::errc::no_such_file_or_directory
            ? fmt::format("cannot be read ({}), expected a folder with measured rows", failed.message())
            : "is no folder, expected one with measured rows");
  }
  fs::path last = folder;
  for (fs::recursive_directory_iterator entry(folder, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    last = entry->path();
    const std::string name = last.filename().string();
    std::error_code unknown;
    if ((is_row(name) || name == kHostTimes) && entry->is_regular_file(unknown))
      paths.push_back(last.string());
  }
  if (failed) throw file_error(last.string(), 0, fmt::format("cannot be read ({})", failed.message()));
  std::ranges::sort(paths);
  return paths;
}

std::vector<configuration> read_measured(const std::string& folder) {
  std::vector<configuration> all;
  const std::vector<named_text> texts = texts_of(folder);
  for (const named_text& file : texts) {
    const std::string name = fs::path(file.path).filename().string();
    if (name.starts_with("cost_")) {
      cost_row row = parse_cost_row(file.path, file.text);
      configuration& of = find_or_add(all, file.path, row.device, row.format, row.options);
      expect_name(file.path, "cost", of.asked, !of.cost.device.empty());
      of.cost = std::move(row);
    } else if (name.starts_with("reference_")) {
      cost_row row = parse_cost_row(file.path, file.text);
      configuration& of = find_or_add(all, file.path, row.device, row.format, row.options);
      expect_name(file.path, "reference", of.asked, !of.reference.device.empty());
      of.reference = std::move(row);
    } else if (name.starts_with("energy_")) {
      energy_row row = parse_energy_row(file.path, file.text);
      configuration& of = find_or_add(all, file.path, row.device, row.format, row.options);
      expect_name(file.path, "energy", of.asked, of.energy.has_value());
      of.energy = std::move(row);
    } else if (name.starts_with("errors_")) {
      add_errors(all, file);
    } else if (name.starts_with("roundings_")) {
      add_roundings(all, file);
    }
  }
  for (const named_text& file : texts) {
    if (fs::path(file.path).filename() == kHostTimes) add_host_times(all, file);
  }
  for (configuration& each : all) {
    const std::optional<selection> other = each.asked.of().computes_as(each.asked);
    if (!other || each.errors) continue;
    const auto found = std::ranges::find_if(all, [&](const configuration& of) {
      return &of.asked.of() == &other->of() && of.asked.format() == other->format() &&
             of.asked.values() == other->values();
    });
    if (found != all.end()) each.errors = found->errors;
  }
  std::ranges::stable_sort(all, {}, [](const configuration& each) {
    return std::tuple(place_of(each.asked.of()), given_options(each.asked), place_of(each.asked.format()));
  });
  return all;
}

std::optional<std::string> embedded_text(const std::string& path) {
  const auto found = std::ranges::find(embedded_files(), path, &measured_file::path);
  if (found == embedded_files().end()) return std::nullopt;
  return std::string(found->text);
}

std::optional<cost_row> measured_cost(const selection& asked) {
  const std::string path = row_path("cost", asked);
  const std::optional<std::string> text = embedded_text(path);
  if (!text) return std::nullopt;
  return parse_cost_row(path, *text);
}

void look_for_stale(std::vector<configuration>& all) {
  std::vector<selection> asked;
  std::ranges::transform(all, std::back_inserter(asked), &configuration::asked);
  const std::vector<std::string> digests = exported_digests(asked);
  for (std::size_t i = 0; i < all.size(); ++i) {
    configuration& each = all[i];
    each.digest = digests[i];
    if (!is_in_build(each.asked.format())) continue;
    each.is_stale = differs(each.cost.ice40, each.digest) || differs(each.cost.ice40_dsp, each.digest) ||
                    differs(each.cost.hx8k, each.digest) || differs(each.cost.osu018, each.digest) ||
                    (each.energy && each.energy->digest != each.digest);
  }
}

}  // namespace blysk::cost
