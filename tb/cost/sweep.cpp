// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/sweep.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>

#include "tb/cost/cost_row.h"
#include "tb/cost/table.h"
#include "tb/output_file.h"
#include "tb/usage_error.h"

namespace blysk::cost {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

constexpr const char* kDescription = "sweep.json";
constexpr int kWidestCosine = 24;  // all of whose 1.7e10 inputs can be tried in minutes

std::optional<int> read_int(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string text_of(const width_range& of) {
  return of.first == of.last ? fmt::format("{}", of.first) : fmt::format("{}..{}", of.first, of.last);
}

json json_of(const sweep& of, const shard& part) {
  json ranges = json::object();
  for (const auto& [name, range] : of.widths) ranges[name] = text_of(range);
  return {{"device", of.device},
          {"options", of.options},
          {"word_lengths", ranges},
          {"shard", fmt::format("{}/{}", part.index, part.count)}};
}

/// The sweep that a folder belongs to.
std::pair<sweep, shard> read_description(const fs::path& folder) {
  const std::string path = (folder / kDescription).string();
  if (!fs::exists(path))
    throw file_error(folder.string(), 0,
                     fmt::format("has no {}, expected the folder of a sweep", kDescription));
  const json stored = parse_json(path, read_text(path));
  try {
    sweep of{stored.at("device"), stored.at("options"), {}};
    for (const auto& [name, range] : stored.at("word_lengths").items())
      of.widths[name] = parse_range(name, range);
    of.check();
    return {of, parse_shard(stored.at("shard"))};
  } catch (const json::exception&) {
    throw file_error(path, 0,
                     "is damaged: a key is missing or of another type, expected what blysk explore wrote");
  } catch (const std::invalid_argument& error) {
    throw file_error(path, 0, fmt::format("is damaged: {}", error.what()));
  }
}

fs::path place_of(const fs::path& folder, const word_lengths& bits) {
  return folder / (name_of(bits) + ".json");
}

error_table read_row(const fs::path& path, const word_lengths& bits) {
  const json stored = parse_json(path.string(), read_text(path));
  if (!stored.is_object() || !stored.contains("domains") ||
      stored.value("word_lengths", json()) != json(bits))
    throw file_error(path.string(), 0,
                     "is damaged, expected a row of this sweep; removing it measures it again");
  return parse_errors(path.string(), stored["domains"]);
}

std::string row_text(const word_lengths& bits, const error_table& table) {
  return stored_text({{"word_lengths", bits}, {"domains", json_of(table)}});
}

/// The folder of a sweep, made if it does not exist and locked for one run as long as this object lives.
class locked_folder {
 public:
  explicit locked_folder(const std::string& folder)
      : directory_(folder), file_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (file_ < 0) throw file_error(folder, 0, fmt::format("cannot be read ({})", system_reason()));
    if (flock(file_, LOCK_EX | LOCK_NB) == 0) return;
    close(file_);
    throw file_error(folder, 0, "is in use by another run, expected a folder for each");
  }
  ~locked_folder() { close(file_); }
  locked_folder(const locked_folder&) = delete;
  locked_folder& operator=(const locked_folder&) = delete;

 private:
  output_directory directory_;
  int file_;
};

/// Makes the folder that of the sweep, or finds that it is.
void claim(const fs::path& folder, const sweep& of, const shard& part) {
  const fs::path path = folder / kDescription;
  const json wanted = json_of(of, part);
  if (fs::exists(path)) {
    const auto [there, its_part] = read_description(folder);
    if (json_of(there, its_part) != wanted)
      throw file_error(
          folder.string(), 0,
          fmt::format("belongs to another sweep or shard, see {}; expected a new folder", kDescription));
    return;
  }
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with('.'))
      throw file_error(folder.string(), 0,
                       fmt::format("holds {}, expected an empty folder or that of the same sweep", name));
  }
  write_text(path, stored_text(wanted));
}

/// The named format whose word lengths go with so many bits of the cosine.
std::string format_for(int cos_bits) {
  std::string best(format_names[0]);
  for (const std::string_view format : format_names) {
    if (const auto bits = read_int(format.substr(1)); bits && *bits <= cos_bits) best = format;
  }
  return best;
}

}  // namespace

width_range parse_range(const std::string& name, const std::string& text) {
  const std::size_t dots = text.find("..");
  const std::optional<int> first = read_int(text.substr(0, dots));
  const std::optional<int> last = dots == std::string::npos ? first : read_int(text.substr(dots + 2));
  if (!first || !last || *first < 1 || *last < *first || *last > 64) {
    throw std::invalid_argument(
        fmt::format("--{} is {}, expected bits such as 12 or a range such as 8..12, in 1..64", name, text));
  }
  return {*first, *last};
}

shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const std::optional<int> index = read_int(std::string_view(text).substr(0, slash));
    const std::optional<int> count = read_int(std::string_view(text).substr(slash + 1));
    if (index && count && 1 <= *index && *index <= *count) return {*index, *count};
  }
  throw std::invalid_argument(
      fmt::format("--shard is {}, expected one of so many, such as 1/4 .. 4/4", text));
}

void sweep::check() const {
  const selection asked = choose(device, std::string(format_names[0]), options);
  judge(asked);
  const word_lengths known = asked.of().widths(asked);
  std::string names;
  for (const auto& [name, width] : known) names += (names.empty() ? "" : ", ") + name;
  for (const auto& [name, range] : widths) {
    if (!known.contains(name))
      throw std::invalid_argument(
          fmt::format("device {} has no word length {}, expected {}", device, name, names));
    if (name == "cos" && range.last > kWidestCosine)
      throw std::invalid_argument(
          fmt::format("--cos goes to {}, expected at most {}, where every input can be tried", range.last,
                      kWidestCosine));
  }
}

std::pair<std::vector<sweep_point>, std::size_t> points_of(const sweep& of) {
  of.check();
  std::vector<sweep_point> points;
  std::size_t refused = 0;
  const auto cosines = of.widths.contains("cos") ? of.widths.at("cos") : width_range{16, 16};
  // An odometer over the other ranges, the last of them fastest.
  for (int cos = cosines.first; cos <= cosines.last; ++cos) {
    const selection asked = choose(of.device, format_for(cos), of.options);
    word_lengths bits = asked.of().widths(asked);
    bits["cos"] = cos;
    for (const auto& [name, range] : of.widths) {
      if (name != "cos") bits[name] = range.first;
    }
    for (bool is_more = true; is_more;) {
      try {
        judge(asked, bits);
        points.push_back({bits, asked});
      } catch (const std::invalid_argument&) {
        ++refused;
      }
      is_more = false;
      for (auto digit = of.widths.rbegin(); digit != of.widths.rend() && !is_more; ++digit) {
        const auto& [name, range] = *digit;
        if (name == "cos") continue;
        is_more = bits[name] < range.last;
        bits[name] = is_more ? bits[name] + 1 : range.first;
      }
    }
  }
  return {points, refused};
}

std::string name_of(const word_lengths& bits) {
  std::string text;
  for (const auto& [name, width] : bits) text += fmt::format("{}{}_{}", text.empty() ? "" : "_", name, width);
  return text;
}

std::vector<sweep_row> run_sweep(const sweep& of, const sweep_settings& settings,
                                 const std::function<void(double)>& advanced) {
  std::vector<sweep_point> points;
  const auto [all, refused] = points_of(of);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i % static_cast<std::size_t>(settings.part.count) + 1 ==
        static_cast<std::size_t>(settings.part.index))
      points.push_back(all[i]);
  }
  const bool is_kept = !settings.folder.empty();
  std::optional<locked_folder> lock;
  if (is_kept) {
    lock.emplace(settings.folder);
    claim(settings.folder, of, settings.part);
  }
  std::vector<sweep_row> rows;
  for (const sweep_point& point : points) {
    const fs::path place = is_kept ? place_of(settings.folder, point.bits) : fs::path();
    const auto share = [&](double of_row) {
      if (advanced)
        advanced((static_cast<double>(rows.size()) + of_row) / static_cast<double>(points.size()));
    };
    if (is_kept && fs::exists(place)) {
      rows.push_back({point.bits, read_row(place, point.bits)});
    } else {
      const error_table table = measure_errors(judge(point.asked, point.bits), settings.threads, share);
      const std::string text = row_text(point.bits, table);
      if (is_kept) write_text(place, text);
      // What is printed now is what another run reads.
      rows.push_back({point.bits, parse_errors(place.string(), json::parse(text)["domains"])});
    }
    share(0);
  }
  return rows;
}

std::pair<sweep, std::vector<sweep_row>> merge_shards(const std::vector<std::string>& folders,
                                                      const std::string& to) {
  std::optional<sweep> of;
  std::map<std::string, std::string> texts;
  std::set<int> missing;
  int count = 0;
  for (const std::string& folder : folders) {
    const auto [its, part] = read_description(folder);
    if (!of) {
      of = its;
      count = part.count;
      for (int i = 1; i <= count; ++i) missing.insert(i);
    }
    if (json_of(its, {}) != json_of(*of, {}) || part.count != count)
      throw file_error(folder, 0,
                       fmt::format("is of another sweep than {}, expected shards of one", folders.front()));
    if (missing.erase(part.index) == 0)
      throw file_error(folder, 0,
                       fmt::format("is shard {}/{} once more, expected each once", part.index, count));
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string();
      if (!name.starts_with('.') && name != kDescription) texts[name] = read_text(entry.path());
    }
  }
  if (!of) throw usage_error("merge has no folders, expected those of all shards");
  if (!missing.empty())
    throw usage_error(
        fmt::format("shard {}/{} is missing, expected the folders of all shards", *missing.begin(), count));
  std::vector<sweep_row> rows;
  for (const sweep_point& point : points_of(*of).first) {
    const std::string name = name_of(point.bits) + ".json";
    const auto found = texts.find(name);
    if (found == texts.end())
      throw usage_error(fmt::format("row {} is in no shard, expected shards that came to their ends", name));
    rows.push_back({point.bits, parse_errors(name, parse_json(name, found->second)["domains"])});
  }
  texts[kDescription] = stored_text(json_of(*of, {}));
  write_directory(to, texts);
  return {*of, rows};
}

nlohmann::ordered_json json_rows(const sweep& of, const std::vector<sweep_row>& rows,
                                 const std::vector<domain>& domains) {
  std::string options;
  for (const auto& [name, value] : of.options)
    options += fmt::format(" --{}{}", name, value == "on" ? "" : " " + value);
  json result = json::array();
  for (const sweep_row& row : rows) {
    std::string command = fmt::format("build/bin/blysk explore --device {}{}", of.device, options);
    for (const auto& [name, width] : row.bits) command += fmt::format(" --{} {}", name, width);
    for (const domain where : domains) {
      json each{{"device", of.device}, {"options", of.options}, {"word_lengths", row.bits}};
      put_errors(each, &row.errors, where);
      each["command"] = command;
      result.push_back(std::move(each));
    }
  }
  return result;
}

}  // namespace blysk::cost
