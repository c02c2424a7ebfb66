// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "tb/cost/figures.h"
#include "tb/cost/table.h"
#include "tb/usage_error.h"

namespace blysk::cost {
namespace {

using words = std::vector<std::string>;
using rows = std::vector<configuration>;

constexpr const char* kNothing = "-";
constexpr const char* kBlocks =
    "rows, errors, roundings, front, compare, reference, host, energy, energy-of-blocks or tools";

std::string line_of(const words& cells) {
  std::string text;
  for (const std::string& cell : cells) text += "| " + cell + " ";
  return text + "|\n";
}

std::string head_of(const words& cells) {
  std::string text = line_of(cells);
  for (std::size_t i = 0; i < cells.size(); ++i) text += i == 0 ? "|---" : "|---:";
  return text + "|\n";
}

rows in_formats(const rows& all, const words& formats) {
  rows chosen;
  std::ranges::copy_if(all, std::back_inserter(chosen), [&](const configuration& each) {
    return std::ranges::find(formats, each.asked.format()) != formats.end();
  });
  return chosen;
}

std::string rows_block(const rows& all, const words& formats) {
  std::string text = head_of({"device", "LUT", "carry", "FF", "RAM blocks", "LUT + DSP", "HX8K, MHz",
                              "10^6 results/s", "NAND2", "longest path, ns", "10^6 results/s", ""});
  for (const configuration& each : in_formats(all, formats)) {
    const cost_row& cost = each.cost;
    if (!cost.ice40 && !cost.ice40_dsp && !cost.hx8k && !cost.osu018) continue;
    const auto rate = [&](double mhz) {
      const double million = each.results_per_us(mhz);
      return million > 0 ? fmt::format("{:.1f}", million) : kNothing;
    };
    const auto cell = [&](bool is_there, auto value) {
      return is_there ? fmt::format("{}", value()) : kNothing;
    };
    text += line_of(
        {each.label(), cell(cost.ice40.has_value(), [&] { return cost.ice40->lut; }),
         cell(cost.ice40.has_value(), [&] { return cost.ice40->carry; }),
         cell(cost.ice40.has_value(), [&] { return cost.ice40->ff; }),
         cell(cost.ice40.has_value(), [&] { return cost.ice40->ram_bits / 4096; }),
         cell(cost.ice40_dsp.has_value(),
              [&] { return fmt::format("{} + {}", cost.ice40_dsp->lut, cost.ice40_dsp->dsp); }),
         cell(cost.hx8k.has_value(),
              [&] {
                return fmt::format("{:.1f} [{:.1f}..{:.1f}]", cost.hx8k->median(), cost.hx8k->least(),
                                   cost.hx8k->most());
              }),
         rate(each.ice40_mhz()),
         cell(cost.osu018.has_value(), [&] { return fmt::format("{:.0f}", cost.osu018->area_nand2); }),
         cell(cost.osu018.has_value(), [&] { return fmt::format("{:.2f}", cost.osu018->path_ns); }),
         rate(each.asic_mhz()), each.is_stale ? "stale" : ""});
  }
  return text;
}

std::string errors_block(const rows& all, const words& formats) {
  std::string text =
      head_of({"device", "domain", "largest", "at n", "at cos", "rms", "bias", "not rounded correctly",
               "0 / 1 / 2 / more ulp", "largest relative", "NMSE", "8-bit steps", "falls"});
  for (const configuration& each : in_formats(all, formats)) {
    // Those of another device, bit for bit, stand there.
    if (!each.errors || each.asked.of().computes_as(each.asked)) continue;
    for (const named_domain& where : kDomains) {
      if (!each.has_errors_in(where.which)) continue;
      const errors& e = each.errors_in(where.which);
      const auto share = [&](std::uint64_t count) {
        return number_text(100 * static_cast<double>(count) / static_cast<double>(e.points));
      };
      text += line_of({each.label(), std::string(where.name), number_text(e.max_abs_err),
                       fmt::format("{}", e.max_abs_n), fmt::format("{:.6g}", e.max_abs_cos),
                       number_text(e.rms_err), number_text(e.bias), share(e.points - e.ulps[0]) + " %",
                       fmt::format("{} / {} / {} / {} %", share(e.ulps[0]), share(e.ulps[1]),
                                   share(e.ulps[2]), share(e.ulps[3])),
                       number_text(e.max_rel_err), number_text(e.nmse), fmt::format("{}", e.max_step),
                       fmt::format("{}", e.falls)});
    }
  }
  return text;
}

/// The model's roundings beside each other, in a domain.
std::string roundings_block(const rows& all, const words& asked) {
  const std::string& where = asked.at(0);
  find_domain(where);
  std::string text = head_of({"device", "rounding", "largest", "rms", "bias", "not rounded correctly", "NMSE",
                              "8-bit steps", "falls"});
  for (const configuration& each : in_formats(all, words(asked.begin() + 1, asked.end()))) {
    for (const nlohmann::ordered_json& row : each.roundings) {
      if (row.at("domain") != where) continue;
      const auto number = [&](const char* key) { return number_text(row.at(key)); };
      text += line_of({each.label(), row.at("rounding").get<std::string>(), number("max_abs_err"),
                       number("rms_err"), number("bias"),
                       number_text(100 * row.at("error_probability").get<double>()) + " %", number("nmse"),
                       number("max_step"), number("falls")});
    }
  }
  return text;
}

std::string front_block(const rows& all, const words& asked) {
  const technology& in = find_technology(asked.at(0));
  const metric& by = find_metric(asked.at(1));
  const domain where = find_domain(asked.at(2));
  std::string text =
      head_of({"device", fmt::format("{}, {}", by.key, asked.at(2)), std::string(in.unit), "MHz", ""});
  for (const configuration* each : front_of(all, by, where, in)) {
    text += line_of(
        {each->label(), number_text(by.of(each->errors_in(where))), fmt::format("{:.0f}", *in.cost(*each)),
         in.mhz(*each) > 0 ? fmt::format("{:.1f}", in.mhz(*each)) : kNothing, each->is_stale ? "stale" : ""});
  }
  return text;
}

/// A figure that two devices are compared by.
struct compared {
  const char* name;
  bool is_smaller_better;
  std::function<std::optional<double>(const cost_row&)> of;
};

/// What two devices are compared by; the first of them says who is simpler.
const std::vector<compared>& compared_figures() {
  using figure = std::optional<double>;
  using row = const cost_row&;
  static const std::vector<compared> all{
      {"NAND2", true, [](row c) { return c.osu018 ? figure(c.osu018->area_nand2) : figure(); }},
      {"path, ns", true, [](row c) { return c.osu018 ? figure(c.osu018->path_ns) : figure(); }},
      {"LUT", true, [](row c) { return c.ice40 ? figure(c.ice40->lut) : figure(); }},
      {"RAM blocks", true, [](row c) { return c.ice40 ? figure(c.ice40->ram_bits / 4096) : figure(); }},
      {"LUT with DSP", true, [](row c) { return c.ice40_dsp ? figure(c.ice40_dsp->lut) : figure(); }},
      {"DSP blocks", true, [](row c) { return c.ice40_dsp ? figure(c.ice40_dsp->dsp) : figure(); }},
      {"HX8K, MHz", false, [](row c) { return c.hx8k ? figure(c.hx8k->median()) : figure(); }},
  };
  return all;
}

/// -1 if the first device is better, 1 if the second is, 0 if they are equal or one was not measured.
int better_of(const compared& by, const cost_row& first, const cost_row& second) {
  const std::optional<double> a = by.of(first);
  const std::optional<double> b = by.of(second);
  if (!a || !b || *a == *b) return 0;
  return (*a < *b) == by.is_smaller_better ? -1 : 1;
}

std::string compare_block(const rows& all, const words& names) {
  const std::vector<compared>& figures = compared_figures();
  words head{fmt::format("{} / {}", names.at(0), names.at(1))};
  for (const compared& each : figures) head.emplace_back(each.name);
  std::string text = head_of(head);
  std::vector<std::array<int, 2>> wins(figures.size());
  for (const configuration& first : all) {
    for (const configuration& second : all) {
      if (first.asked.of().name() != names[0] || second.asked.of().name() != names[1] ||
          !first.asked.is_preset() || first.asked.format() != second.asked.format())
        continue;
      if (std::ranges::none_of(figures,
                               [&](const compared& by) { return by.of(first.cost) && by.of(second.cost); }))
        continue;
      const int simpler = better_of(figures.front(), first.cost, second.cost);
      words cells{second.label().substr(names[1].size() + 1)};
      for (std::size_t i = 0; i < figures.size(); ++i) {
        const std::optional<double> a = figures[i].of(first.cost);
        const std::optional<double> b = figures[i].of(second.cost);
        const int better = better_of(figures[i], first.cost, second.cost);
        if (better != 0) ++wins[i][better < 0 ? 0 : 1];
        const std::string cell = a && b ? number_text(*a) + " / " + number_text(*b) : kNothing;
        cells.push_back(better * simpler < 0 ? "**" + cell + "**" : cell);
      }
      text += line_of(cells);
    }
  }
  words better{fmt::format("rows where {} / {} is better", names[0], names[1])};
  for (const auto& [first, second] : wins) better.push_back(fmt::format("{} / {}", first, second));
  return text + line_of(better);
}

/// Each cell: the export's figure, that of the device written by hand, and the ratio.
std::string reference_block(const rows& all, const words& names) {
  const std::vector<compared>& figures = compared_figures();
  words head{fmt::format("{}, export / by hand", names.at(0))};
  for (const compared& each : figures) head.emplace_back(each.name);
  std::string text = head_of(head);
  for (const configuration& each : all) {
    const bool is_measured = std::ranges::any_of(
        figures, [&](const compared& by) { return by.of(each.cost) && by.of(each.reference); });
    if (each.asked.of().name() != names[0] || !is_measured) continue;
    words cells{each.label().substr(names[0].size() + 1)};
    for (const compared& by : figures) {
      const std::optional<double> a = by.of(each.cost);
      const std::optional<double> b = by.of(each.reference);
      if (!a || !b) {
        cells.emplace_back(kNothing);
      } else if (*b == 0) {
        cells.push_back(fmt::format("{} / 0", number_text(*a)));
      } else {
        cells.push_back(fmt::format("{} / {} = {:.3f}", number_text(*a), number_text(*b), *a / *b));
      }
    }
    text += line_of(cells);
  }
  return text;
}

std::string host_block(const rows& all, const words& formats) {
  std::string text = head_of({"device", "golden", "bit", "systemc", "verilator"});
  for (const configuration& each : in_formats(all, formats)) {
    if (each.host.empty()) continue;
    words cells{each.label()};
    for (const char* engine : {"golden", "bit", "systemc", "verilator"}) {
      const auto found = each.host.find(engine);
      cells.push_back(found == each.host.end() ? kNothing : number_text(found->second.ratio));
    }
    text += line_of(cells);
  }
  return text;
}

std::string tools_block(const rows& all) {
  std::set<std::pair<std::string, std::string>> tools;
  const auto add = [&](const auto& part) {
    if (!part) return;
    tools.insert(part->from.tools.begin(), part->from.tools.end());
  };
  for (const configuration& each : all) {
    add(each.cost.ice40);
    add(each.cost.ice40_dsp);
    add(each.cost.hx8k);
    add(each.cost.osu018);
  }
  std::string text = "| tool | version |\n|---|---|\n";
  for (const auto& [tool, version] : tools) text += line_of({tool, version});
  return text;
}

const energy_use* use_of(const configuration& of, const std::string& kind) {
  if (!of.energy) return nullptr;
  const auto found = of.energy->stimuli.find(kind);
  return found == of.energy->stimuli.end() ? nullptr : &found->second;
}

std::string energy_block(const rows& all, const words& asked) {
  const std::string& kind = asked.at(0);
  std::string text = head_of({"device", "changes, no delays", "changes, with delays", "ratio",
                              "pJ, no delays", "pJ, with delays", ""});
  for (const configuration& each : in_formats(all, words(asked.begin() + 1, asked.end()))) {
    const energy_use* const use = use_of(each, kind);
    if (use == nullptr) continue;
    const auto& [with, without] = use->whole;
    text +=
        line_of({each.label(), fmt::format("{:.0f}", without.toggles), fmt::format("{:.0f}", with.toggles),
                 fmt::format("{:.2f}", with.toggles / without.toggles), fmt::format("{:.1f}", without.pj),
                 fmt::format("{:.1f}", with.pj), each.is_stale ? "stale" : ""});
  }
  return text;
}

std::string blocks_energy_block(const rows& all, const words& asked) {
  const std::string& kind = asked.at(0);
  const auto found = std::ranges::find_if(all, [&](const configuration& each) {
    return each.asked.of().name() == asked.at(1) && each.asked.format() == asked.at(2) &&
           each.asked.is_preset();
  });
  if (found == all.end() || use_of(*found, kind) == nullptr)
    throw std::invalid_argument(
        fmt::format("the energy of {} {} was not measured with {}", asked[1], asked[2], kind));
  std::string text =
      head_of({"block", "changes, no delays", "changes, with delays", "ratio", "pJ, with delays"});
  for (const auto& [block, use] : use_of(*found, kind)->blocks) {
    text += line_of(
        {block, fmt::format("{:.2f}", use.without.toggles), fmt::format("{:.2f}", use.with_delays.toggles),
         use.without.toggles > 0 ? fmt::format("{:.2f}", use.with_delays.toggles / use.without.toggles)
                                 : kNothing,
         fmt::format("{:.2f}", use.with_delays.pj)});
  }
  return text;
}

std::string block_of(const std::string& path, std::size_t line, const words& asked, const rows& all) {
  if (asked.empty()) throw file_error(path, line, fmt::format("names no block, expected {}", kBlocks));
  const words rest(asked.begin() + 1, asked.end());
  try {
    if (asked[0] == "rows") return rows_block(all, rest);
    if (asked[0] == "errors") return errors_block(all, rest);
    if (asked[0] == "roundings") return roundings_block(all, rest);
    if (asked[0] == "front") return front_block(all, rest);
    if (asked[0] == "compare") return compare_block(all, rest);
    if (asked[0] == "reference") return reference_block(all, rest);
    if (asked[0] == "host") return host_block(all, rest);
    if (asked[0] == "energy") return energy_block(all, rest);
    if (asked[0] == "energy-of-blocks") return blocks_energy_block(all, rest);
    if (asked[0] == "tools") return tools_block(all);
  } catch (const std::out_of_range&) {
    throw file_error(path, line, fmt::format("block {} has too few words", asked[0]));
  } catch (const std::invalid_argument& error) {
    throw file_error(path, line, error.what());
  } catch (const nlohmann::json::exception&) {
    throw file_error(path, line,
                     fmt::format("block {} has damaged rows, expected those that blysk wrote", asked[0]));
  }
  throw file_error(path, line, fmt::format("block {} is unknown, expected {}", asked[0], kBlocks));
}

/// Lines of figures, and the paragraph below them.
class quotations {
 public:
  quotations(const std::string& path, const rows& all) : path_(path), all_(all) {}

  /// The next line of the page; an empty one ends a paragraph.
  void take(std::size_t number, const std::string& line) {
    constexpr std::string_view kFigures = "<!-- figures: ";
    constexpr std::string_view kClosed = " -->";
    if (line.starts_with(kFigures) && line.ends_with(kClosed)) {
      pending_[number] = line.substr(kFigures.size(), line.size() - kFigures.size() - kClosed.size());
    } else if (!line.empty()) {
      paragraph_ += line + ' ';
    } else {
      for (const auto& [at, quoted] : pending_) check_figures(path_, at, quoted, paragraph_, all_);
      pending_.clear();
      paragraph_.clear();
    }
  }

 private:
  const std::string& path_;
  const rows& all_;
  std::map<std::size_t, std::string> pending_;
  std::string paragraph_;
};

}  // namespace

std::string with_generated_blocks(const std::string& path, const std::string& page,
                                  const std::vector<configuration>& all) {
  constexpr std::string_view kBegin = "<!-- generated: ";
  constexpr std::string_view kEnd = "<!-- end of generated -->";
  std::string result;
  quotations quoted(path, all);
  std::istringstream lines(page);
  std::size_t number = 0;
  std::size_t begun = 0;  // line of the block that is skipped, 0 outside
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line == kEnd) {
      if (begun == 0)
        throw file_error(path, number, "ends a generated block, expected one that begins before");
      begun = 0;
    }
    if (begun != 0) continue;
    result += line + '\n';
    quoted.take(number, line);
    if (!line.starts_with(kBegin) || !line.ends_with(" -->")) continue;
    begun = number;
    std::istringstream asked(
        line.substr(kBegin.size(), line.size() - kBegin.size() - std::string_view(" -->").size()));
    words parts;
    for (std::string word; asked >> word;) parts.push_back(word);
    result += block_of(path, number, parts, all);
  }
  quoted.take(number + 1, "");
  if (begun != 0)
    throw file_error(path, begun, fmt::format("begins a generated block, expected {} below", kEnd));
  return result;
}

}  // namespace blysk::cost
