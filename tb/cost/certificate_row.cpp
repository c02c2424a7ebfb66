// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/certificate_row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <tuple>
#include <vector>

#include "tb/cost/cost_row.h"
#include "tb/cost/table.h"
#include "tb/usage_error.h"

namespace blysk::cost {
namespace {

namespace fs = std::filesystem;

int fraction_of(const certificate& row) {
  return std::stoi(row.format.substr(1));
}

/// The device with its options as on a command line, "NAME --option 2".
std::string name_of(const certificate& row) {
  std::string name = row.device;
  for (const auto& [option, value] : row.options)
    name += value == "on" ? fmt::format(" --{}", option) : fmt::format(" --{} {}", option, value);
  return name;
}

}  // namespace

nlohmann::ordered_json json_of(const certificate& row) {
  nlohmann::ordered_json json{{"device", row.device}, {"format", row.format}};
  if (!row.options.empty()) json["options"] = row.options;
  json["digest"] = row.digest;
  json["gappa"] = row.gappa;
  json["bound"] = row.bound;
  json["seen"] = {{"status", row.seen.is_exhaustive ? "exhaustive" : "sampled"},
                  {"inputs", row.seen.inputs},
                  {"max_abs_err", row.seen.max_abs_err},
                  {"n", row.seen.n},
                  {"cos", row.seen.cos}};
  return json;
}

certificate parse_certificate(const std::string& path, const std::string& text) {
  const nlohmann::ordered_json json = parse_json(path, text);
  try {
    const auto& seen = json.at("seen");
    certificate row{.device = json.at("device"),
                    .format = json.at("format"),
                    .options = json.value("options", std::map<std::string, std::string>{}),
                    .digest = json.at("digest"),
                    .gappa = json.at("gappa"),
                    .bound = json.at("bound"),
                    .seen = {.max_abs_err = seen.at("max_abs_err"),
                             .n = seen.at("n"),
                             .cos = seen.at("cos"),
                             .inputs = seen.at("inputs"),
                             .is_exhaustive = seen.at("status") == "exhaustive"}};
    const auto is_known = [&](std::string_view name) { return name == row.format; };
    if (std::ranges::any_of(format_names, is_known) && row.seen.max_abs_err > 0 &&
        row.bound >= row.seen.max_abs_err)
      return row;
  } catch (const nlohmann::json::exception&) {  // told below
  }
  throw file_error(path, 0,
                   "is damaged: a key is missing, of another type or out of range, expected what "
                   "update_certificates writes");
}

std::string with_certificates(const std::string& tables, const std::string& path, const std::string& page) {
  std::vector<certificate> rows;
  for (const auto& entry : fs::recursive_directory_iterator(tables)) {
    if (entry.path().filename().string().starts_with("certificate_"))
      rows.push_back(parse_certificate(entry.path().string(), read_text(entry.path().string())));
  }
  std::ranges::sort(
      rows, {}, [](const certificate& row) { return std::tuple(row.device, row.options, fraction_of(row)); });
  std::string table =
      "| device | format | proved bound | in ulp | largest error seen | in ulp | inputs | bound / seen |\n"
      "|---|---|---:|---:|---:|---:|---|---:|\n";
  for (const certificate& row : rows) {
    const double ulps = std::ldexp(1.0, fraction_of(row));
    table +=
        fmt::format("| {} | {} | {} | {:.3f} | {} | {:.3f} | {}{} | {:.3f} |\n", name_of(row), row.format,
                    number_text(row.bound), row.bound * ulps, number_text(row.seen.max_abs_err),
                    row.seen.max_abs_err * ulps, row.seen.is_exhaustive ? "all " : "", row.seen.inputs,
                    row.bound / row.seen.max_abs_err);
  }
  for (const device* each : devices()) {
    for (const certificate& row : rows) {
      if (const std::optional<selection> other = each->computes_as(choose(each->name(), row.format));
          other && other->of().name() == row.device && row.options.empty())
        table += fmt::format("| {} | {} | {} | as {}, whose BRDF it computes | | | | |\n", each->name(),
                             row.format, number_text(row.bound), row.device);
    }
  }
  const std::string first = "<!-- generated: certificates -->\n";
  const std::size_t begin = page.find(first);
  const std::size_t end = begin == std::string::npos ? begin : page.find("<!-- end of generated -->", begin);
  if (end == std::string::npos) throw file_error(path, 0, "has no place for the table of certificates");
  return page.substr(0, begin + first.size()) + table + page.substr(end);
}

}  // namespace blysk::cost
