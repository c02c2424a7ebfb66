// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>
#include <span>
#include <vector>

#include "tb/cli/numbers.h"
#include "tb/cli/verbs.h"
#include "tb/cost/delays.h"
#include "tb/device_arguments.h"
#include "tb/harness/settling_bench.h"
#include "tb/progress.h"
#include "tb/usage_error.h"

namespace blysk::cli {
namespace {

using harness::settled_write;
using harness::write_codes;

struct options {
  asked_device device;
  std::string delays;
  std::uint64_t pairs = 20000;
  std::uint64_t seed = 1;
  bool json = false;
};

/// Two writes one after the other; how the outputs settle after the second depends on both.
struct pair_of_writes {
  write_codes before, after;
  settled_write settled = {};
};

/// Inputs of a device: random ones, changed ones, corners.
class input_maker {
 public:
  input_maker(const selection& asked, std::uint64_t seed)
      : asked_(asked), data_(of_role(asked.of().ports(asked), port::role::data)), random_(seed) {}

  const std::vector<port>& data() const { return data_; }

  write_codes any() {
    write_codes codes;
    for (const port& each : data_) codes.push_back(any_of(each));
    return codes;
  }

  /// One bit, one step, an end or another code in the place of one of the codes.
  void change(write_codes& codes) {
    const std::size_t i = below(data_.size());
    const port& of = data_[i];
    switch (below(4)) {
      case 0:
        codes[i] ^= std::int64_t{1} << below(static_cast<std::uint64_t>(of.width()));
        break;
      case 1:
        codes[i] += below(2) == 0 ? 1 : -1;
        break;
      case 2:
        codes[i] = below(2) == 0 ? of.carries->min : of.carries->max;
        break;
      default:
        codes[i] = any_of(of);
    }
    codes[i] = std::clamp(codes[i], of.carries->min, of.carries->max);
  }

  /// Ends, middles and the device's own corners of the enumerated ports, the others at their largest codes.
  std::vector<write_codes> corners() const {
    std::vector<write_codes> rows{{}};
    const std::size_t enumerated = asked_.of().enumerated();
    for (std::size_t i = 0; i < data_.size(); ++i) {
      const auto [low, high] = std::pair(data_[i].carries->min, data_[i].carries->max);
      std::vector<write_codes> longer;
      for (const write_codes& row : rows) {
        std::vector<std::int64_t> codes{high};
        if (i < enumerated) {
          for (const std::int64_t code : {low, low + 1, (low + high) / 2, high - 1}) codes.push_back(code);
        }
        if (i + 1 == enumerated) {
          for (const std::int64_t code : asked_.of().corners(asked_, std::span(row))) codes.push_back(code);
        }
        std::ranges::sort(codes);
        codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
        for (const std::int64_t code : codes) {
          if (code < low || code > high) continue;
          longer.push_back(row);
          longer.back().push_back(code);
        }
      }
      rows = std::move(longer);
    }
    return rows;
  }

  std::uint64_t below(std::uint64_t end) { return random_() % end; }

 private:
  std::int64_t any_of(const port& of) {
    return of.carries->min + static_cast<std::int64_t>(
                                 below(static_cast<std::uint64_t>(of.carries->max - of.carries->min) + 1));
  }

  const selection& asked_;
  std::vector<port> data_;
  std::mt19937_64 random_;
};

/// What a search has found.
struct finding {
  pair_of_writes worst;
  std::uint64_t busy_for = 0;  ///< the most over all pairs
  std::array<std::uint64_t, 3> tried = {};
  std::uint64_t all() const { return tried[0] + tried[1] + tried[2]; }
};

/// The pairs that settle last, kept to be changed.
class pool {
 public:
  void offer(const pair_of_writes& candidate) {
    if (kept_.size() == kMost && candidate.settled.after <= kept_.back().settled.after) return;
    kept_.push_back(candidate);
    std::ranges::stable_sort(kept_, std::greater<>{},
                             [](const pair_of_writes& each) { return each.settled.after; });
    if (kept_.size() > kMost) kept_.pop_back();
  }
  const std::vector<pair_of_writes>& kept() const { return kept_; }

 private:
  static constexpr std::size_t kMost = 16;
  std::vector<pair_of_writes> kept_;
};

finding search(harness::settling_bench& bench, input_maker& make, std::uint64_t pairs) {
  finding found;
  pool best;
  progress shown("settle: pairs tried", pairs);
  write_codes last;
  const auto attempt = [&](const write_codes& codes, std::size_t kind) {
    const settled_write settled = bench.write(codes);
    found.busy_for = std::max(found.busy_for, settled.busy_for);
    if (!last.empty()) {
      const pair_of_writes now{last, codes, settled};
      best.offer(now);
      if (settled.after > found.worst.settled.after) found.worst = now;
      ++found.tried[kind];
      shown.reach(found.all());
    }
    last = codes;
  };
  // Corners: every two of them, or as many as a third of the pairs, at regular distances.
  const std::vector<write_codes> corners = make.corners();
  const std::uint64_t ordered = corners.size() * corners.size();
  const std::uint64_t stride = 1 + 2 * ordered / std::max<std::uint64_t>(1, pairs / 3);
  for (std::uint64_t i = 0; i < ordered && found.tried[0] < pairs / 3; i += stride) {
    attempt(corners[i / corners.size()], 0);
    attempt(corners[i % corners.size()], 0);
  }
  while (found.tried[0] + found.tried[1] < pairs / 3 * 2) attempt(make.any(), 1);
  // Guided: what settled late is changed a little and tried again.
  while (found.all() + 1 < pairs && !best.kept().empty()) {
    pair_of_writes next = best.kept()[make.below(best.kept().size())];
    for (std::uint64_t changes = 1 + make.below(3); changes > 0; --changes)
      make.change(make.below(2) == 0 ? next.before : next.after);
    attempt(next.before, 2);
    attempt(next.after, 2);
  }
  return found;
}

std::string row_text(const std::vector<port>& data, const write_codes& codes) {
  std::string text;
  for (std::size_t i = 0; i < data.size(); ++i) {
    const wire_format& format = *data[i].carries;
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", data[i].column,
                        format.frac == 0 ? fmt::format("{}", codes[i]) : format.value(codes[i]));
  }
  return text;
}

/// A gap, and what a read one step below it gives.
struct judged_gap {
  std::uint64_t ps = 0;
  std::string output;
  int bit = -1;  ///< the highest that is wrong
  std::int64_t got = 0, expected = 0;

  double ns() const { return static_cast<double>(ps) / 1e3; }
};

/// The worst pair with strobes: right with its gap, wrong one step below.
/// \throws std::logic_error where it is not
judged_gap judge(harness::settling_bench& bench, const pair_of_writes& worst, const selection& device) {
  judged_gap judged;
  judged.ps = worst.settled.after;
  const auto read_after = [&](std::uint64_t gap) {
    bench.write(worst.before);
    return bench.read_after(worst.after, gap);
  };
  bench.write(worst.before);
  bench.write(worst.after);
  const std::vector<std::int64_t> expected = bench.outputs();
  if (read_after(judged.ps) != expected)
    throw std::logic_error("the outputs are wrong at the gap that was found");
  const std::vector<std::int64_t> early = read_after(judged.ps - 1);
  std::vector<port> outputs = of_role(device.of().ports(device), port::role::result);
  std::erase_if(outputs, [](const port& each) { return each.is_inner; });
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (early[i] == expected[i]) continue;
    const auto differing =
        static_cast<std::uint64_t>(early[i] ^ expected[i]) & (~std::uint64_t{0} >> (64 - outputs[i].width()));
    judged.output = outputs[i].wave;
    judged.bit = static_cast<int>(std::bit_width(differing)) - 1;
    judged.got = early[i];
    judged.expected = expected[i];
    return judged;
  }
  throw std::logic_error("the outputs are right one step below the gap that was found");
}

/// All that is told of a device.
struct answer {
  selection device;
  device_delays delays;
  std::vector<port> data;
  std::uint64_t seed;
  finding found;
  judged_gap gap;
};

nlohmann::ordered_json json_of(const answer& told) {
  nlohmann::ordered_json json{{"device", told.device.of().name()},
                              {"format", told.device.format()},
                              {"options", told.device.values()},
                              {"smallest_gap_ns", told.gap.ns()},
                              {"seen_ns", told.gap.ns()},
                              {"bound_ns", told.delays.bound_ps / 1e3},
                              {"one_delay_a_block_ns", told.delays.blocks_bound_ps / 1e3},
                              {"path_ns", told.delays.path_ps() / 1e3},
                              {"busy_ns", static_cast<double>(told.found.busy_for) / 1e3},
                              {"smallest_period_ns", 2 * told.gap.ns()},
                              {"step_ns", 0.001},
                              {"pairs_tried", told.found.all()},
                              {"corners", told.found.tried[0]},
                              {"random", told.found.tried[1]},
                              {"guided", told.found.tried[2]},
                              {"seed", told.seed}};
  const auto codes = [&](const write_codes& of) {
    nlohmann::ordered_json row;
    for (std::size_t i = 0; i < of.size(); ++i) row[told.data[i].column] = of[i];
    return row;
  };
  json["worst"] = {{"before", codes(told.found.worst.before)}, {"after", codes(told.found.worst.after)}};
  json["one_step_below"] = {{"signal", told.gap.output},
                            {"bit", told.gap.bit},
                            {"got", told.gap.got},
                            {"expected", told.gap.expected}};
  json["digest"] = told.delays.digest;
  json["tools"] = told.delays.tools;
  return json;
}

std::string text_of(const answer& told) {
  const double gap = told.gap.ns();
  return fmt::format(
      "smallest gap {:.3f} ns from the clock edge that loads the registers to the strobe's leading edge\n"
      "seen    {:.3f} ns, the last change of an output in {} pairs: {} of corners, {} random, {} guided, "
      "seed {}\n"
      "bound   {:.3f} ns from bit to bit through the blocks; {:.3f} ns with one worst delay a block\n"
      "path    {:.3f} ns, the longest by static timing\n"
      "pair    {}\n"
      "        {}\n"
      "        at {:.3f} ns all outputs are right; at {:.3f} ns {} is {}, expected {}: bit {} is wrong",
      gap, gap, told.found.all(), told.found.tried[0], told.found.tried[1], told.found.tried[2], told.seed,
      told.delays.bound_ps / 1e3, told.delays.blocks_bound_ps / 1e3, told.delays.path_ps() / 1e3,
      row_text(told.data, told.found.worst.before), row_text(told.data, told.found.worst.after), gap,
      gap - 1e-3, told.gap.output, told.gap.got, told.gap.expected, told.gap.bit);
}

void run(const options& asked) {
  const selection device = asked.device.choose();
  const device_delays delays = cost::read_delays(asked.delays, device, cost::digest_of(device));
  harness::settling_bench bench(device, delays);
  input_maker make(device, asked.seed);
  const finding found = search(bench, make, asked.pairs);
  const std::uint64_t gap = found.worst.settled.after;
  if (gap == 0)
    throw std::runtime_error(
        fmt::format("no output changed in the {} pairs that were tried, expected more --pairs", found.all()));
  if (gap > static_cast<std::uint64_t>(delays.bound_ps))
    throw file_error(delays.file, 0,
                     fmt::format("bound_ps is {}, expected at least the {} ps after which an output changed",
                                 delays.bound_ps, gap));
  const answer told{device, delays, make.data(), asked.seed, found, judge(bench, found.worst, device)};
  fmt::print("{}\n", asked.json ? json_of(told).dump(2) : text_of(told));
}

}  // namespace

void add_settle(CLI::App& program) {
  auto* verb = program.add_subcommand(
      "settle", "Find the smallest gap between loading the registers and the next strobe");
  auto asked = std::make_shared<options>();
  add_device_arguments(*verb, asked->device, purpose::hardware);
  verb->add_option("--delays", asked->delays,
                   "delays of the blocks, as scripts/synth --delays writes them; without it those that were "
                   "measured when the program was built");
  verb->add_option("--pairs", asked->pairs, "pairs of writes to try")
      ->transform(whole_number(10, 1'000'000'000))
      ->capture_default_str();
  verb->add_option("--seed", asked->seed, "of the random writes")
      ->transform(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  verb->add_flag("--json", asked->json, "print a JSON object");
  verb->footer(
      "A gap that was seen is no bound: another pair may settle later, up to the bound.\n"
      "Examples:\n"
      "  blysk settle --format q8\n"
      "  blysk settle --format q12 --pairs 1000 --json");
  verb->callback([asked] { run(*asked); });
}

}  // namespace blysk::cli
