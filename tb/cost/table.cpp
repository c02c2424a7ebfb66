// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>

namespace blysk::cost {
namespace {

using json = nlohmann::ordered_json;

constexpr std::array kMetrics{
    metric{"max_abs_err", "largest |BRDF - cos^n|", [](const errors& e) { return e.max_abs_err; }},
    metric{"mean_abs_err", "mean |BRDF - cos^n|", [](const errors& e) { return e.mean_abs_err; }},
    metric{"bias", "|mean of BRDF - cos^n|", [](const errors& e) { return std::fabs(e.bias); }},
    metric{"rms_err", "root of the mean square of BRDF - cos^n", [](const errors& e) { return e.rms_err; }},
    metric{"error_probability", "share of inputs that are not cos^n rounded to nearest",
           [](const errors& e) { return e.error_probability; }},
    metric{"max_rel_err", "largest |BRDF - cos^n| / cos^n where cos^n is half an ulp or more",
           [](const errors& e) { return e.max_rel_err; }},
    metric{"mean_rel_err", "mean of the same", [](const errors& e) { return e.mean_rel_err; }},
    metric{"nmse", "sum (BRDF - cos^n)^2 / sum cos^2n", [](const errors& e) { return e.nmse; }},
    metric{"max_step", "largest difference in steps of 1/255",
           [](const errors& e) { return static_cast<double>(e.max_step); }},
};

constexpr std::array kTechnologies{
    technology{"ice40", "LUT", "iCE40 HX8K, multipliers of LUTs",
               [](const configuration& c) {
                 return c.cost.ice40 ? std::optional(static_cast<double>(c.cost.ice40->lut)) : std::nullopt;
               },
               [](const configuration& c) { return c.ice40_mhz(); }},
    technology{"asic", "NAND2", "OSU018 standard cells",
               [](const configuration& c) {
                 return c.cost.osu018 ? std::optional(c.cost.osu018->area_nand2) : std::nullopt;
               },
               [](const configuration& c) { return c.asic_mhz(); }},
};

template <class List, class Key>
auto& find_in(const List& list, const std::string& name, Key key, const char* what) {
  const auto found = std::ranges::find(list, name, key);
  if (found != std::end(list)) return *found;
  std::string names;
  for (const auto& each : list) names += fmt::format("{}{}", names.empty() ? "" : ", ", each.*key);
  throw std::invalid_argument(fmt::format("{} {} does not exist, expected {}", what, name, names));
}

const named_domain& named(domain which) {
  return *std::ranges::find(kDomains, which, &named_domain::which);
}

void add_cells(json& row, const std::optional<ice40_cells>& cells) {
  for (const char* key : {"lut", "carry", "ff", "dsp", "ram_bits"}) row[key] = nullptr;
  if (!cells) return;
  row["lut"] = cells->lut;
  row["carry"] = cells->carry;
  row["ff"] = cells->ff;
  row["dsp"] = cells->dsp;
  row["ram_bits"] = cells->ram_bits;
}

json or_null(double value) {
  return value > 0 ? json(value) : json(nullptr);
}

double rounded(double value, double digits) {
  return std::round(value * digits) / digits;
}

void add_cost(json& row, const configuration& of) {
  add_cells(row, of.cost.ice40);
  json with_dsp;
  add_cells(with_dsp, of.cost.ice40_dsp);
  row["with_dsp"] = of.cost.ice40_dsp ? with_dsp : json(nullptr);
  row["fmax_mhz"] = of.cost.hx8k ? json(of.cost.hx8k->median()) : json(nullptr);
  row["fmax_mhz_least"] = of.cost.hx8k ? json(of.cost.hx8k->least()) : json(nullptr);
  row["fmax_mhz_most"] = of.cost.hx8k ? json(of.cost.hx8k->most()) : json(nullptr);
  row["area_nand2"] = of.cost.osu018 ? json(of.cost.osu018->area_nand2) : json(nullptr);
  row["path_ns"] = of.cost.osu018 ? json(of.cost.osu018->path_ns) : json(nullptr);
  const std::optional<int> latency = of.latency_cycles();
  row["latency_cycles"] = latency ? json(*latency) : json(nullptr);
  const int cycles = of.cycles_per_result();
  row["cycles_per_result"] = cycles > 0 ? json(cycles) : json(nullptr);
  row["results_per_s_ice40"] = or_null(rounded(1e6 * of.results_per_us(of.ice40_mhz()), 1));
  row["results_per_s_asic"] = or_null(rounded(1e6 * of.results_per_us(of.asic_mhz()), 1));
  row["energy_pj"] = or_null(of.energy_pj());
  json host = json::object();
  for (const auto& [engine, time] : of.host)
    host[engine] = {{"s_per_million", time.seconds}, {"ratio_to_pow", time.ratio}};
  row["host"] = host;
  row["is_stale"] = of.is_stale;
}

json tools_of(const cost_row& row) {
  json tools = json::object();
  const auto add = [&](const auto& part) {
    if (!part) return;
    for (const auto& [tool, version] : part->from.tools) tools[tool] = version;
  };
  add(row.ice40);
  add(row.ice40_dsp);
  add(row.hx8k);
  add(row.osu018);
  return tools;
}

/// A configuration as cells of a table.
std::vector<std::string> cells_of(const configuration& of, const metric& by, domain where) {
  constexpr const char* kNothing = "-";
  const cost_row& cost = of.cost;
  const auto million = [&](double mhz) {
    const double rate = of.results_per_us(mhz);
    return rate > 0 ? fmt::format("{:.2f}", rate) : kNothing;
  };
  std::vector<std::string> cells{of.label()};
  cells.push_back(of.has_errors_in(where) ? number_text(by.of(of.errors_in(where))) : kNothing);
  cells.push_back(cost.ice40 ? fmt::format("{}", cost.ice40->lut) : kNothing);
  cells.push_back(cost.ice40 ? fmt::format("{}", cost.ice40->ram_bits / 4096) : kNothing);
  cells.push_back(cost.ice40_dsp ? fmt::format("{} + {}", cost.ice40_dsp->lut, cost.ice40_dsp->dsp)
                                 : kNothing);
  cells.push_back(cost.hx8k ? fmt::format("{:.1f} [{:.1f}..{:.1f}]", cost.hx8k->median(), cost.hx8k->least(),
                                          cost.hx8k->most())
                            : kNothing);
  cells.push_back(million(of.ice40_mhz()));
  cells.push_back(cost.osu018 ? fmt::format("{:.0f}", cost.osu018->area_nand2) : kNothing);
  cells.push_back(cost.osu018 ? fmt::format("{:.2f}", cost.osu018->path_ns) : kNothing);
  cells.push_back(million(of.asic_mhz()));
  const std::optional<int> latency = of.latency_cycles();
  cells.push_back(latency ? fmt::format("{}", *latency) : kNothing);
  for (const char* engine : {"golden", "bit", "systemc", "verilator"}) {
    const auto found = of.host.find(engine);
    cells.push_back(found == of.host.end() ? kNothing : number_text(found->second.seconds));
  }
  cells.emplace_back(of.is_stale ? "stale" : "");
  return cells;
}

std::vector<std::string> heads(const metric& by, domain where) {
  return {"device",    fmt::format("{}, {}", by.key, named(where).name),
          "LUT",       "RAM",
          "LUT + DSP", "iCE40 MHz",
          "M/s",       "NAND2",
          "ns",        "M/s",
          "latency",   "golden",
          "bit",       "systemc",
          "verilator", ""};
}

}  // namespace

std::span<const metric> metrics() {
  return kMetrics;
}

const metric& find_metric(const std::string& key) {
  return find_in(kMetrics, key, &metric::key, "metric");
}

std::span<const technology> technologies() {
  return kTechnologies;
}

const technology& find_technology(const std::string& name) {
  return find_in(kTechnologies, name, &technology::name, "target");
}

void put_errors(nlohmann::ordered_json& row, const error_table* table, domain where) {
  row["domain"] = named(where).name;
  row["status"] = nullptr;
  if (table == nullptr || (*table)[static_cast<std::size_t>(where)].points == 0) {
    row["points"] = nullptr;
    for (const metric& each : metrics()) row[std::string(each.key)] = nullptr;
    for (const char* key : {"max_abs_n", "max_abs_cos", "ulps", "falls"}) row[key] = nullptr;
    return;
  }
  const errors& e = (*table)[static_cast<std::size_t>(where)];
  row["status"] = "exhaustive";
  row["points"] = e.points;
  for (const metric& each : metrics()) row[std::string(each.key)] = each.of(e);
  row["bias"] = e.bias;  // with its sign
  row["max_step"] = e.max_step;
  row["max_abs_n"] = e.max_abs_n;
  row["max_abs_cos"] = e.max_abs_cos;
  row["ulps"] = e.ulps;
  row["falls"] = e.falls;
}

nlohmann::ordered_json json_rows(const std::vector<configuration>& all, std::span<const domain> domains) {
  json rows = json::array();
  for (const configuration& each : all) {
    for (const domain where : domains) {
      json row{{"device", each.asked.of().name()},
               {"format", each.asked.format()},
               {"options", given_options(each.asked)},
               {"word_lengths", each.asked.of().widths(each.asked)}};
      put_errors(row, each.errors ? &*each.errors : nullptr, where);
      add_cost(row, each);
      row["tools"] = tools_of(each.cost);
      row["digest"] = each.cost.ice40 ? json(each.cost.ice40->from.digest) : json(nullptr);
      row["command"] = each.command();
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

namespace {

/// Numbers and words as they are, lists with semicolons.
std::string text_of(const json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value;
  if (value.is_object() || value.is_array()) {
    std::string text;
    for (const auto& [key, element] : value.items()) {
      text += text.empty() ? "" : ";";
      text += value.is_object() ? key + "=" + text_of(element) : text_of(element);
    }
    return text;
  }
  return value.dump();
}

/// One cell of CSV, in quotes if it has a comma: no text has quotes.
std::string csv_cell(const json& value) {
  const std::string text = text_of(value);
  return text.find(',') == std::string::npos ? text : '"' + text + '"';
}

}  // namespace

std::string csv_of(const nlohmann::ordered_json& rows) {
  std::vector<std::string> keys;
  for (const json& row : rows) {
    for (const auto& [key, value] : row.items()) {
      if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
    }
  }
  std::string text;
  for (const std::string& key : keys) text += (text.empty() ? "" : ",") + key;
  text += '\n';
  for (const json& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < keys.size(); ++i) {
      line += i == 0 ? "" : ",";
      if (row.contains(keys[i])) line += csv_cell(row[keys[i]]);
    }
    text += line + '\n';
  }
  return text;
}

std::string markdown_table(const std::vector<configuration>& all, const metric& by, domain where) {
  std::string text;
  const auto add = [&](const std::vector<std::string>& cells) {
    for (const std::string& cell : cells) text += "| " + cell + " ";
    text += "|\n";
  };
  add(heads(by, where));
  for (std::size_t i = 0; i < heads(by, where).size(); ++i) text += i == 0 ? "|---" : "|---:";
  text += "|\n";
  for (const configuration& each : all) add(cells_of(each, by, where));
  return text;
}

std::string plain_table(const std::vector<configuration>& all, const metric& by, domain where) {
  std::vector<std::vector<std::string>> lines{heads(by, where)};
  for (const configuration& each : all) lines.push_back(cells_of(each, by, where));
  std::vector<std::size_t> widths(lines.front().size());
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (const auto& line : lines) {
    std::string row = fmt::format("{:<{}}", line[0], widths[0]);
    for (std::size_t i = 1; i < line.size(); ++i) row += fmt::format("  {:>{}}", line[i], widths[i]);
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + '\n';
  }
  return text;
}

namespace {

/// A configuration whose error and cost are known, and that reaches the clock.
struct candidate {
  const configuration* of;
  double cost, error;
};

std::vector<candidate> candidates(const std::vector<configuration>& all, const metric& by, domain where,
                                  const technology& in, double mhz) {
  std::vector<candidate> found;
  for (const configuration& each : all) {
    const std::optional<double> cost = in.cost(each);
    if (cost && each.has_errors_in(where) && (mhz <= 0 || in.mhz(each) >= mhz))
      found.push_back({&each, *cost, by.of(each.errors_in(where))});
  }
  return found;
}

const configuration* least(const std::vector<candidate>& among,
                           const std::function<bool(const candidate&)>& fits,
                           const std::function<std::pair<double, double>(const candidate&)>& order) {
  const candidate* best = nullptr;
  for (const candidate& each : among) {
    if (fits(each) && (best == nullptr || order(each) < order(*best))) best = &each;
  }
  return best == nullptr ? nullptr : best->of;
}

}  // namespace

choice choose_cheapest(const std::vector<configuration>& all, double tolerance, const metric& by,
                       domain where, const technology& in, double mhz) {
  const std::vector<candidate> among = candidates(all, by, where, in, mhz);
  const auto by_cost = [](const candidate& c) { return std::pair(c.cost, c.error); };
  const auto by_error = [](const candidate& c) { return std::pair(c.error, c.cost); };
  choice found;
  found.has_candidate = !candidates(all, by, where, in, 0).empty();
  for (const configuration& each : all) {
    if (!in.cost(each) && each.has_errors_in(where) && by.of(each.errors_in(where)) <= tolerance)
      found.unpriced.push_back(&each);
  }
  found.cheapest = least(
      among, [&](const candidate& c) { return c.error <= tolerance; }, by_cost);
  if (found.cheapest == nullptr) {  // the nearest to the tolerance
    found.cheaper = least(
        among, [](const candidate&) { return true; }, by_error);
    return found;
  }
  const candidate& chosen = *std::ranges::find(among, found.cheapest, &candidate::of);
  found.cheaper = least(
      among, [&](const candidate& c) { return c.cost < chosen.cost; }, by_error);
  found.better = least(
      among, [&](const candidate& c) { return c.error < chosen.error; }, by_cost);
  return found;
}

std::vector<const configuration*> front_of(const std::vector<configuration>& all, const metric& by,
                                           domain where, const technology& in) {
  std::vector<candidate> among = candidates(all, by, where, in, 0);
  std::ranges::stable_sort(among, {}, [](const candidate& c) { return std::pair(c.cost, c.error); });
  std::vector<const configuration*> front;
  double best = 0;
  for (const candidate& each : among) {
    if (!front.empty() && each.error >= best) continue;
    best = each.error;
    front.push_back(each.of);
  }
  return front;
}

std::string html_page(const nlohmann::ordered_json& rows, const std::string& metric) {
  constexpr std::string_view kPlace = "/* rows */ []";
  constexpr std::string_view kMetric = "max_abs_err\");";  // what the page shows first
  std::string page(embedded_pages().front().text);
  std::string text = rows.dump();
  // Nothing in a string may end the script that it stands in.
  for (std::size_t at = text.find("</"); at != std::string::npos; at = text.find("</", at))
    text.replace(at, 2, "<\\/");
  page.replace(page.find(kMetric), kMetric.size(), metric + "\");");
  return page.replace(page.find(kPlace), kPlace.size(), text);
}

std::string number_text(double value) {
  if (value == 0) return "0";
  return std::fabs(value) >= 1e4 && std::fabs(value) < 1e9 ? fmt::format("{:.0f}", value)
                                                           : fmt::format("{:.4g}", value);
}

}  // namespace blysk::cost
