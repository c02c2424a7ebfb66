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
#include <memory>
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

specular::rounding find_rounding(const std::string& name) {
  const auto found = std::ranges::find(specular::kRoundings, name, &specular::named_rounding::name);
  if (found != specular::kRoundings.end()) return found->which;
  std::string names;
  for (const specular::named_rounding& each : specular::kRoundings) names += fmt::format("{}, ", each.name);
  throw std::invalid_argument(fmt::format("rounding {} does not exist, expected {}or all", name, names));
}

std::string text_of(const width_range& of) {
  return of.first == of.last ? fmt::format("{}", of.first) : fmt::format("{}..{}", of.first, of.last);
}

json json_of(const sweep& of, const shard& part) {
  json ranges = json::object();
  for (const auto& [name, range] : of.widths) ranges[name] = text_of(range);
  json roundings = json::array();
  for (const specular::rounding how : of.roundings) roundings.push_back(specular::name_of(how));
  json result{{"device", of.device},
              {"options", of.options},
              {"word_lengths", ranges},
              {"roundings", roundings},
              {"shard", fmt::format("{}/{}", part.index, part.count)}};
  if (!of.format.empty()) result["format"] = of.format;
  return result;
}

/// Whether there is something of that name.
/// \throws usage_error if that cannot be told
bool is_there(const fs::path& path, const char* expected) {
  std::error_code unknown;
  const bool found = fs::exists(path, unknown);
  if (unknown)
    throw file_error(path.string(), 0,
                     fmt::format("cannot be read ({}), expected {}", unknown.message(), expected));
  return found;
}

/// The sweep that a folder belongs to.
std::pair<sweep, shard> read_description(const fs::path& folder) {
  const std::string path = (folder / kDescription).string();
  if (!is_there(path, "the folder of a sweep"))
    throw file_error(folder.string(), 0,
                     fmt::format("has no {}, expected the folder of a sweep", kDescription));
  const json stored = parse_json(path, read_text(path), "JSON as blysk explore writes it");
  try {
    sweep of{stored.at("device"), stored.at("options"), {}, {}, stored.value("format", "")};
    for (const auto& [name, range] : stored.at("word_lengths").items())
      of.widths[name] = parse_range(name, range);
    for (const json& name : stored.at("roundings")) of.roundings.push_back(find_rounding(name));
    of.check();
    return {of, parse_shard(stored.at("shard"))};
  } catch (const json::exception&) {
    throw file_error(path, 0,
                     "is damaged: a key is missing or of another type, expected what blysk explore wrote");
  } catch (const std::invalid_argument& error) {
    throw file_error(path, 0, fmt::format("is damaged: {}", error.what()));
  }
}

std::string file_of(const sweep& of, const sweep_point& point) {
  return point.name(of) + ".json";
}

/// What a row says of itself besides its errors.
json head_of(const sweep_point& point) {
  return {
      {"word_lengths", point.bits}, {"options", point.options}, {"rounding", specular::name_of(point.how)}};
}

/// \param path  for messages
error_table parse_row(const std::string& path, const std::string& text, const sweep_point& point) {
  const json stored =
      parse_json(path, text, "JSON as blysk explore writes it; removing the file measures its row again");
  const json head = head_of(point);
  bool is_row = stored.is_object() && stored.contains("domains");
  for (const auto& [key, value] : head.items())
    is_row = is_row && stored.contains(key) && stored[key] == value;
  if (!is_row)
    throw file_error(path, 0, "is damaged, expected a row of this sweep; removing it measures it again");
  return parse_errors(path, stored["domains"]);
}

std::string row_text(const sweep_point& point, const error_table& table) {
  json row = head_of(point);
  row["domains"] = json_of(table);
  return stored_text(row);
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

/// \returns whether the folder is that of the sweep's part; false: it is empty
/// \throws usage_error if it holds anything else
bool belongs_to(const fs::path& folder, const sweep& of, const shard& part) {
  if (is_there(folder / kDescription, "a folder to write into")) {
    const auto [there, its_part] = read_description(folder);
    if (json_of(there, its_part) != json_of(of, part))
      throw file_error(
          folder.string(), 0,
          fmt::format("belongs to another sweep or shard, see {}; expected a new folder", kDescription));
    return true;
  }
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with('.'))
      throw file_error(folder.string(), 0,
                       fmt::format("holds {}, expected an empty folder or that of the same sweep", name));
  }
  if (failed) throw file_error(folder.string(), 0, fmt::format("cannot be read ({})", failed.message()));
  return false;
}

/// Makes the folder that of the sweep, or finds that it is.
void claim(const fs::path& folder, const sweep& of, const shard& part) {
  if (!belongs_to(folder, of, part)) write_text(folder / kDescription, stored_text(json_of(of, part)));
}

/// The named format whose word lengths go with so many bits of the cosine.
std::string format_for(int cos_bits) {
  std::string best(format_names[0]);
  for (const std::string_view format : format_names) {
    if (const auto bits = read_int(format.substr(1)); bits && *bits <= cos_bits) best = format;
  }
  return best;
}

/// \throws std::invalid_argument for what is there twice, or nothing
template <class T, class Name>
void check_list(const std::string& option, std::vector<T> list, Name name) {
  if (list.empty())
    throw std::invalid_argument(fmt::format("--{} has no value, expected one or more", option));
  std::ranges::sort(list);
  const auto twice = std::ranges::adjacent_find(list);
  if (twice != list.end())
    throw std::invalid_argument(fmt::format("--{} has {} twice, expected each once", option, name(*twice)));
}

/// The combinations at so many bits of the cosine, and how many the laws refuse.
void add_points(const sweep& of, const option_values& line, int cos, std::vector<sweep_point>& points,
                std::size_t& refused) {
  const selection asked = choose(of.device, of.format.empty() ? format_for(cos) : of.format, line);
  word_lengths bits = asked.of().widths(asked);
  bits["cos"] = cos;
  for (const auto& [name, range] : of.widths) {
    if (name != "cos") bits[name] = range.first;
  }
  // An odometer over the other ranges, the last of them fastest.
  for (bool is_more = true; is_more;) {
    for (const specular::rounding how : of.roundings) {
      try {
        judge(asked, bits, how);
        points.push_back({bits, line, how, asked});
      } catch (const std::invalid_argument&) {
        ++refused;
      }
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

std::string command_of(const sweep& of, const sweep_point& point) {
  std::string command =
      fmt::format("build/bin/blysk explore --device {}{}", of.device, option_words(point.options));
  for (const auto& [name, width] : point.bits) command += fmt::format(" --{} {}", name, width);
  if (point.how != specular::rounding::nearest)
    command += fmt::format(" --rounding {}", specular::name_of(point.how));
  return command;
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

std::vector<std::string> split_list(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t end = text.find(','); end != std::string::npos; end = text.find(',', begin)) {
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  parts.push_back(text.substr(begin));
  return parts;
}

std::vector<specular::rounding> parse_roundings(const std::string& text) {
  std::vector<specular::rounding> roundings;
  if (text == "all") {
    for (const specular::named_rounding& each : specular::kRoundings) roundings.push_back(each.which);
    return roundings;
  }
  for (const std::string& name : split_list(text)) {
    if (name == "all")
      throw std::invalid_argument(
          fmt::format("--rounding is {}, expected all alone or a list of names", text));
    roundings.push_back(find_rounding(name));
  }
  return roundings;
}

std::vector<option_values> sweep::option_lines() const {
  std::vector<option_values> lines{{}};
  for (const auto& [name, values] : options) {
    std::vector<option_values> longer;
    for (const option_values& line : lines) {
      for (const std::string& value : values) {
        longer.push_back(line);
        longer.back()[name] = value;
      }
    }
    lines = std::move(longer);
  }
  return lines;
}

void sweep::check() const {
  for (const auto& [name, values] : options)
    check_list(name, values, [](const std::string& value) { return value; });
  check_list("rounding", roundings, [](specular::rounding how) { return specular::name_of(how); });
  for (const option_values& line : option_lines()) {
    const selection asked = choose(device, format.empty() ? std::string(format_names[0]) : format, line);
    const word_lengths known = asked.of().widths(asked);
    for (const specular::rounding how : roundings) judge(asked, known, how);
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
}

std::pair<std::vector<sweep_point>, std::size_t> points_of(const sweep& of) {
  of.check();
  std::pair<std::vector<sweep_point>, std::size_t> found;
  for (const option_values& line : of.option_lines()) {
    width_range cosines{16, 16};
    if (!of.format.empty()) {
      const selection asked = choose(of.device, of.format, line);
      cosines.first = cosines.last = asked.of().widths(asked).at("cos");
    }
    if (of.widths.contains("cos")) cosines = of.widths.at("cos");
    for (int cos = cosines.first; cos <= cosines.last; ++cos)
      add_points(of, line, cos, found.first, found.second);
  }
  return found;
}

std::optional<std::string> sweep_point::format() const {
  const bool is_built = how == specular::rounding::nearest && bits == asked.of().widths(asked);
  return is_built ? std::optional(asked.format()) : std::nullopt;
}

std::string sweep_point::name(const sweep& of) const {
  std::string text;
  const auto add = [&](const auto& key, const auto& value) {
    text += fmt::format("{}{}_{}", text.empty() ? "" : "_", key, value);
  };
  for (const auto& [key, width] : bits) add(key, width);
  for (const auto& [key, value] : options) {
    if (of.options.at(key).size() > 1) add(key, value);
  }
  if (how != specular::rounding::nearest) add("rounding", specular::name_of(how));
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
    const fs::path place = is_kept ? fs::path(settings.folder) / file_of(of, point) : fs::path();
    const auto share = [&](double of_row) {
      if (advanced)
        advanced((static_cast<double>(rows.size()) + of_row) / static_cast<double>(points.size()));
    };
    if (is_kept && is_there(place, "the folder of a sweep")) {
      rows.push_back({point, parse_row(place.string(), read_text(place), point)});
    } else {
      const error_table table =
          measure_errors(judge(point.asked, point.bits, point.how), settings.threads, share);
      const std::string text = row_text(point, table);
      if (is_kept) write_text(place, text);
      // What is printed now is what another run reads.
      rows.push_back({point, parse_row(place.string(), text, point)});
    }
    share(0);
  }
  return rows;
}

std::pair<sweep, std::vector<sweep_row>> merge_shards(const std::vector<std::string>& folders,
                                                      const std::string& to) {
  std::optional<sweep> of;
  std::set<int> missing;
  std::vector<std::unique_ptr<locked_folder>> locks;
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
    locks.push_back(std::make_unique<locked_folder>(folder));
  }
  if (!of) throw usage_error("merge has no folders, expected those of all shards");
  if (!missing.empty())
    throw usage_error(
        fmt::format("shard {}/{} is missing, expected the folders of all shards", *missing.begin(), count));
  if (is_there(to, "a folder to write into")) {
    for (const std::string& folder : folders) {
      std::error_code unknown;
      if (fs::equivalent(folder, to, unknown))
        throw file_error(to, 0, "is one of the shards, expected another folder for the whole");
    }
    locks.push_back(std::make_unique<locked_folder>(to));
    belongs_to(to, *of, {});
  }
  std::vector<sweep_row> rows;
  std::map<std::string, std::string> texts{{kDescription, stored_text(json_of(*of, {}))}};
  for (const sweep_point& point : points_of(*of).first) {
    const std::string name = file_of(*of, point);
    const auto shard_of = std::ranges::find_if(
        folders, [&](const std::string& folder) { return is_there(fs::path(folder) / name, "a shard"); });
    if (shard_of == folders.end())
      throw usage_error(fmt::format("row {} is in no shard, expected shards that came to their ends", name));
    const fs::path place = fs::path(*shard_of) / name;
    texts[name] = read_text(place);
    rows.push_back({point, parse_row(place.string(), texts[name], point)});
  }
  write_directory(to, texts);
  return {*of, rows};
}

nlohmann::ordered_json json_rows(const sweep& of, const std::vector<sweep_row>& rows,
                                 const std::vector<domain>& domains) {
  json result = json::array();
  for (const auto& [point, errors] : rows) {
    const std::string command = command_of(of, point);
    const std::optional<std::string> format = point.format();
    for (const domain where : domains) {
      json each{{"device", of.device},
                {"format", format ? json(*format) : json(nullptr)},
                {"options", point.options},
                {"word_lengths", point.bits},
                {"rounding", specular::name_of(point.how)}};
      put_errors(each, &errors, where);
      each["command"] = command;
      result.push_back(std::move(each));
    }
  }
  return result;
}

}  // namespace blysk::cost
