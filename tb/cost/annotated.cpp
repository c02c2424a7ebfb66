// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/annotated.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "tb/cost/certificate_row.h"
#include "tb/cost/delays.h"
#include "tb/cost/digest.h"
#include "tb/cost/errors.h"
#include "tb/cost/measured.h"
#include "tb/specular/specular.h"

namespace blysk::cost {
namespace {

// Lines of the comment: the first, the others, and what begins the text after it.
constexpr std::string_view kFirst =
    "// What blysk knows of it, and the digest of its modules without this comment:\n";
constexpr std::string_view kAfter = "`default_nettype none\n";

/// The device whose results, and so errors and formula, these are.
selection computed_as(const selection& asked) {
  const std::optional<selection> other = asked.of().computes_as(asked);
  return other ? *other : asked;
}

std::string tools_text(const std::map<std::string, std::string>& tools) {
  std::vector<std::string> texts;
  for (const auto& [tool, version] : tools) {
    if (tool.find('.') != std::string::npos) continue;  // a library
    texts.push_back(tool == "sta" ? "OpenSTA " + version : version);
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string function_of(const selection& asked) {
  const selection other = computed_as(asked);
  const auto* const of = dynamic_cast<const specular::device_of_points*>(&other.of());
  if (of == nullptr) return asked.of().title();
  return of->equation(other) + ", c = cos(delta); red, green, blue = BRDF (R, G, B) k_s";
}

/// The smallest gap that blysk settle saw, from docs/tables/settling.csv.
struct seen_gap {
  double ns = 0;
  std::uint64_t pairs = 0;
};

std::optional<seen_gap> seen_gap_of(const selection& asked) {
  const std::optional<std::string> table = embedded_text("settling.csv");
  if (!table || !asked.is_preset()) return std::nullopt;
  std::istringstream lines(*table);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    std::istringstream text(line);
    for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
    if (cells.size() > 6 && cells[0] == asked.of().name() && cells[1] == asked.format())
      return seen_gap{std::stod(cells[2]), std::stoull(cells[6])};
  }
  return std::nullopt;
}

/// What was measured of the Verilog with a digest.
class figures {
 public:
  figures(const selection& asked, std::string digest) : asked_(asked), digest_(std::move(digest)) {
    if (const std::optional<cost_row> row = measured_cost(asked)) cost_ = *row;
    drop_other(cost_.ice40);
    drop_other(cost_.ice40_dsp);
    drop_other(cost_.hx8k);
    drop_other(cost_.osu018);
    const std::string place = row_path("delays", asked);
    if (const std::optional<std::string> text = embedded_text(place)) {
      delays_ = parse_delays(place, *text);
      if (delays_->digest != digest_) delays_.reset();
    }
  }

  verilog::measured_times times() const {
    verilog::measured_times found;
    if (cost_.osu018) {
      const double path = cost_.osu018->path_ns;
      found.clock = {path, fmt::format("OSU018, {:.2f} (docs/tables/{})", path, row_path("cost", asked_))};
    }
    if (delays_) {
      found.settling = {1e-3 * delays_->bound_ps,
                        fmt::format("OSU018, each block mapped for itself, without wires (docs/tables/{})",
                                    row_path("delays", asked_))};
    }
    // Mapped as a whole it may be slower than block by block: what is asked of a netlist holds for both.
    if (found.settling && cost_.osu018 && cost_.osu018->path_ns > found.settling->bound_ns) {
      found.settling = {
          std::ceil(100 * cost_.osu018->path_ns) / 100,
          fmt::format("OSU018, the longest path of the whole device, without wires (docs/tables/{})",
                      row_path("cost", asked_))};
    }
    return found;
  }

  /// \param whose_digest  what is said behind the digest
  std::string comment(const std::string& whose_digest = "") {
    text_ = kFirst;
    add("computes", function_of(asked_));
    add("digest", digest_ + whose_digest);
    add_errors();
    add_certificate();
    add_cost();
    add_settling();
    if (!missing_.empty()) add("not known with these options", fmt::format("{}", fmt::join(missing_, ", ")));
    return text_;
  }

 private:
  template <class Part>
  void drop_other(std::optional<Part>& part) const {
    if (part && part->from.digest != digest_) part.reset();
  }

  void add(std::string_view what, const std::string& value) {
    text_ += fmt::format("//   {}: {}\n", what, value);
  }

  void add_errors() {
    const std::string place = row_path("errors", computed_as(asked_));
    const std::optional<std::string> text = embedded_text(place);
    if (!text) {
      missing_.emplace_back("errors");
      return;
    }
    const error_table table = parse_errors(place, parse_json(place, *text).at("domains"));
    for (const domain which : {domain::whole, domain::sphere}) {
      const errors& e = table[static_cast<std::size_t>(which)];
      const auto named = std::ranges::find(kDomains, which, &named_domain::which);
      add(fmt::format("error against c^n, {}", named->what),
          fmt::format("at most {} (n = {}, c = {}), bias {}; {} inputs, n in 1..1000, exhaustive",
                      e.max_abs_err, e.max_abs_n, e.max_abs_cos, e.bias, e.points));
    }
  }

  /// Of the Verilog itself; or, where the results are those of another device, that device's.
  void add_certificate() {
    const selection other = computed_as(asked_);
    const bool is_own = &other.of() == &asked_.of();
    const std::string place = row_path("certificate", other);
    const std::optional<std::string> text = embedded_text(place);
    if (!text) return missing_.emplace_back("certificate"), void();
    const certificate row = parse_certificate(place, *text);
    if (is_own && row.digest != digest_) return missing_.emplace_back("certificate"), void();
    const std::string whose =
        is_own ? "" : fmt::format("that of {}, whose BRDF it computes: ", other.of().name());
    add("certificate",
        fmt::format("{}BRDF within {} of what it computes in real numbers, proved by Gappa {}; "
                    "at most {} seen, {} inputs, {}",
                    whose, row.bound, row.gappa, row.seen.max_abs_err, row.seen.inputs,
                    row.seen.is_exhaustive ? "exhaustive" : "sampled"));
  }

  void add_cost() {
    const auto add_ice40 = [this](const char* what, const std::optional<ice40_cells>& cells) {
      if (!cells) return missing_.emplace_back(what), void();
      add(what, fmt::format("{} LUT, {} carry, {} FF, {} DSP, {} RAM bits; {}", cells->lut, cells->carry,
                            cells->ff, cells->dsp, cells->ram_bits, tools_text(cells->from.tools)));
    };
    add_ice40("iCE40", cost_.ice40);
    add_ice40("iCE40 with DSP", cost_.ice40_dsp);
    if (cost_.hx8k) {
      add("iCE40 HX8K", fmt::format("{} MHz, the least of {} seeds; {}", cost_.hx8k->least(),
                                    cost_.hx8k->seeds.size(), tools_text(cost_.hx8k->from.tools)));
    } else {
      missing_.emplace_back("iCE40 HX8K");
    }
    if (cost_.osu018) {
      add("OSU018",
          fmt::format("{} NAND2, {} cells, longest path {} ns; {}", cost_.osu018->area_nand2,
                      cost_.osu018->cells, cost_.osu018->path_ns, tools_text(cost_.osu018->from.tools)));
    } else {
      missing_.emplace_back("OSU018");
    }
  }

  void add_settling() {
    if (!delays_) return missing_.emplace_back("settling"), void();
    std::string value =
        fmt::format("within {:.3f} ns in OSU018 with its blocks apart", 1e-3 * delays_->bound_ps);
    if (const std::optional<seen_gap> gap = seen_gap_of(asked_))
      value += fmt::format(", {} ns seen in {} pairs of writes", gap->ns, gap->pairs);
    add("settles", fmt::format("{}; {}", value, tools_text(delays_->tools)));
  }

  const selection asked_;
  const std::string digest_;
  cost_row cost_;
  std::optional<device_delays> delays_;
  std::string text_;
  std::vector<std::string> missing_;
};

}  // namespace

std::string head_of(const selection& asked, const std::string& digest) {
  return figures(asked, digest).comment();
}

verilog::files annotated_export(const netlist::elaborated& device, const selection& asked,
                                const std::string& name) {
  verilog::files files = verilog::export_files(device, name, asked.text());
  const std::string measured_name = asked.top_name();
  const bool is_renamed = name != measured_name;
  figures found(
      asked, verilog_digest(is_renamed ? verilog::export_files(device, measured_name, asked.text()) : files));
  files[name + ".sdc"] = verilog::constraints_text(device, found.times());
  std::string& top = files.at(name + ".v");
  top.insert(
      top.find(kAfter),
      found.comment(is_renamed ? fmt::format(", with {} in their names", measured_name) : std::string()));
  return files;
}

}  // namespace blysk::cost
