// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/timing_diagram.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <utility>

#include "tb/wave_values.h"

namespace blysk::harness {
namespace {

using lane = timing_diagram::lane;
using arrow = timing_diagram::arrow;

/// Bits as an integer in two's complement or without a sign; four digits of a real number.
std::string number(const std::string& text, const port& of) {
  if (!value_name(of).empty()) return fmt::format("{:.4g}", std::strtod(text.c_str(), nullptr));
  const std::uint64_t raw = std::strtoull(text.c_str(), nullptr, 2);
  const int width = of.width();
  if (!of.carries->is_signed || raw >> (width - 1) == 0) return fmt::format("{}", raw);
  return fmt::format("{}", static_cast<std::int64_t>(raw << (64 - width)) >> (64 - width));
}

lane lane_of(const port& of, bool begins_group, const wave_changes& waves, std::uint64_t tick_ps,
             std::size_t first, std::size_t count) {
  lane made{of.wave, of.carries.has_value(), begins_group, {}};
  const std::string value = value_name(of);
  const std::string signal =
      value.empty() ? "SystemC." + of.wave : fmt::format("SystemC.{}.{}", kValueScope, value);
  for (std::size_t tick = first; tick < first + count; ++tick) {
    const std::string& carried = waves.at(signal, tick * tick_ps);
    made.values.push_back(made.is_bus ? number(carried, of) : carried);
  }
  return made;
}

bool changes_at(const lane& of, std::size_t tick) {
  return tick > 0 && of.values[tick] != of.values[tick - 1];
}
bool steps_at(const lane& of, std::size_t tick, const char* to) {
  return changes_at(of, tick) && of.values[tick] == to;
}

/// Text of XML.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char each : text) {
    result += each == '&' ? "&amp;" : each == '<' ? "&lt;" : each == '>' ? "&gt;" : std::string(1, each);
  }
  return result;
}

}  // namespace

timing_diagram diagram_of(const std::vector<port>& ports, const wave_changes& waves,
                          std::uint64_t half_period_ps, std::size_t first, std::size_t count) {
  if (protocol_of(ports) != protocol::strobes)
    throw std::invalid_argument("the device has no strobes, expected one with the protocol of fig. 3");
  timing_diagram made;
  const auto add = [&](const port& each, bool begins_group) {
    made.lanes.push_back(lane_of(each, begins_group, waves, half_period_ps, first, count));
    return made.lanes.size() - 1;
  };
  for (const port::role role : {port::role::clock, port::role::reset})
    add(ports[find_role(ports, role)], false);
  std::size_t writing = 0;
  for (const write_edge edge : {write_edge::level, write_edge::trailing}) {
    for (const port& strobe : of_role(ports, port::role::strobe)) {
      if (strobe.edge != edge) continue;
      const auto data = std::ranges::find(ports, strobe.writes, &port::name);
      const std::size_t lane_of_strobe = add(strobe, true);
      if (edge == write_edge::trailing) writing = lane_of_strobe;
      add(*data, false);
    }
  }
  const std::size_t valid = add(ports[find_role(ports, port::role::valid)], true);
  const std::size_t results = made.lanes.size();
  for (const port& each : of_role(ports, port::role::result)) add(each, false);

  bool is_written = false;
  for (std::size_t tick = 1; tick < count; ++tick) {
    if (steps_at(made.lanes[valid], tick, "1") && is_written)
      made.arrows.push_back({valid, tick, made.lanes.size() - 1, tick, "confirms"});
    if (!steps_at(made.lanes[writing], tick, "0")) continue;
    is_written = true;
    // The register loads at the next rising edge of the clock.
    for (std::size_t after = tick + 1; after < std::min(tick + 3, count); ++after) {
      if (!steps_at(made.lanes.front(), after, "1")) continue;
      if (changes_at(made.lanes[results], after))
        made.arrows.push_back({writing, tick, results, after, "loads"});
      break;
    }
  }
  return made;
}

std::string wave_json(const timing_diagram& shown) {
  std::map<std::pair<std::size_t, std::size_t>, char> nodes;
  std::vector<std::string> edges;
  const auto node_at = [&](std::size_t of_lane, std::size_t tick) {
    constexpr std::string_view kNames = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    const auto [found, is_new] = nodes.try_emplace({of_lane, tick}, kNames[nodes.size() % kNames.size()]);
    return found->second;
  };
  for (const arrow& each : shown.arrows) {
    const char from = node_at(each.from_lane, each.from_tick);
    const char to = node_at(each.to_lane, each.to_tick);
    edges.push_back(fmt::format("\"{}~>{} {}\"", from, to, each.text));
  }
  std::string signals;
  for (std::size_t i = 0; i < shown.lanes.size(); ++i) {
    const lane& each = shown.lanes[i];
    std::string wave, node;
    std::vector<std::string> data;
    for (std::size_t tick = 0; tick < each.values.size(); ++tick) {
      const bool is_new = tick == 0 || changes_at(each, tick);
      wave += !is_new ? "." : each.is_bus ? "=" : each.values[tick];
      if (is_new && each.is_bus) data.push_back('"' + each.values[tick] + '"');
      const auto named = nodes.find({i, tick});
      node += named == nodes.end() ? '.' : named->second;
    }
    if (each.begins_group) signals += "    {},\n";
    signals += fmt::format(
        "    {{\"name\": \"{}\", \"wave\": \"{}\"{}{}}}{}\n", each.name, wave,
        each.is_bus ? fmt::format(", \"data\": [{}]", fmt::join(data, ", ")) : "",
        node.find_first_not_of('.') == std::string::npos ? "" : fmt::format(", \"node\": \"{}\"", node),
        i + 1 < shown.lanes.size() ? "," : "");
  }
  return fmt::format(
      "{{\n"
      "  \"signal\": [\n{}  ],\n"
      "  \"edge\": [{}],\n"
      "  \"config\": {{\"hscale\": 1}},\n"
      "  \"head\": {{\"text\": \"{}\"}},\n"
      "  \"foot\": {{\"text\": \"{}\"}}\n"
      "}}\n",
      signals, fmt::join(edges, ", "), shown.title, shown.foot);
}

std::string svg_text(const timing_diagram& shown) {
  constexpr int kNames = 96, kTick = 40, kLane = 26, kHeight = 16, kGap = 10, kHead = 34, kSlope = 4;
  const std::size_t ticks = shown.lanes.empty() ? 0 : shown.lanes.front().values.size();
  const auto x_of = [](std::size_t tick) { return kNames + static_cast<int>(tick) * kTick; };
  std::vector<int> tops;
  int y = kHead;
  for (const lane& each : shown.lanes) {
    y += each.begins_group ? kGap : 0;
    tops.push_back(y);
    y += kLane;
  }
  const int width = x_of(ticks) + 12;
  std::string body;
  for (std::size_t tick = 0; tick <= ticks; ++tick)
    body += fmt::format("<path class=\"grid\" d=\"M{0},{1}V{2}\"/>\n", x_of(tick), kHead - 4, y - 6);
  for (std::size_t i = 0; i < shown.lanes.size(); ++i) {
    const lane& each = shown.lanes[i];
    const int top = tops[i];
    const int bottom = top + kHeight;
    const int middle = top + kHeight / 2;
    body += fmt::format("<text class=\"name\" x=\"{}\" y=\"{}\">{}</text>\n", kNames - 8, middle + 4,
                        escaped(each.name));
    for (std::size_t begin = 0; begin < ticks;) {
      std::size_t end = begin + 1;
      while (end < ticks && each.values[end] == each.values[begin]) ++end;
      const int left = x_of(begin);
      const int right = x_of(end);
      if (each.is_bus) {
        body += fmt::format("<path class=\"bus\" d=\"M{0},{3}L{1},{4}H{2}L{5},{3}L{2},{6}H{1}Z\"/>\n", left,
                            left + kSlope, right - kSlope, middle, top, right, bottom);
        body += fmt::format("<text class=\"value\" x=\"{}\" y=\"{}\">{}</text>\n", (left + right) / 2,
                            middle + 4, escaped(each.values[begin]));
      } else {
        const int level = each.values[begin] == "1" ? top : bottom;
        const int other = top + bottom - level;
        body += begin == 0
                    ? fmt::format("<path class=\"wire\" d=\"M{},{}H{}\"/>\n", left, level, right)
                    : fmt::format("<path class=\"wire\" d=\"M{},{}V{}H{}\"/>\n", left, other, level, right);
      }
      begin = end;
    }
  }
  for (const arrow& each : shown.arrows) {
    const int from_x = x_of(each.from_tick);
    const int to_x = x_of(each.to_tick);
    const int from_y = tops[each.from_lane] + kHeight / 2;
    const int to_y = tops[each.to_lane] + kHeight / 2;
    body += fmt::format(
        "<path class=\"arrow\" marker-end=\"url(#head)\" d=\"M{0},{1}C{2},{1} {2},{4} {3},{4}\"/>\n", from_x,
        from_y, (from_x + to_x) / 2 + (from_x == to_x ? -kTick / 2 : 0), to_x, to_y);
    // Beside the edge, right of the arrow.
    body += fmt::format("<text class=\"label\" x=\"{}\" y=\"{}\">{}</text>\n",
                        from_x + (from_x == to_x ? 6 : 22), from_y + 3, escaped(each.text));
  }
  return fmt::format(
      R"(<svg xmlns="http://www.w3.org/2000/svg" width="{0}" height="{1}" viewBox="0 0 {0} {1}" font-family="sans-serif" font-size="11">
<defs><marker id="head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto"><path d="M0,0L8,4L0,8Z" fill="#c02020"/></marker></defs>
<style>.grid{{stroke:#dddddd}} .wire{{stroke:black;fill:none;stroke-width:1.3}} .bus{{stroke:black;fill:#eef4fb;stroke-width:1.1}} .name{{text-anchor:end}} .value{{text-anchor:middle;font-size:10px}} .arrow{{stroke:#c02020;fill:none}} .label{{fill:#c02020;font-size:10px}} .note{{font-size:10px;fill:#444444}}</style>
<rect width="100%" height="100%" fill="white"/>
<text x="{2}" y="20" font-size="13">{3}</text>
{4}<text class="note" x="{2}" y="{5}">{6}</text>
</svg>
)",
      width, y + 22, kNames, escaped(shown.title), body, y + 12, escaped(shown.foot));
}

}  // namespace blysk::harness
