// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "tb/cli/engines.h"
#include "tb/cli/numbers.h"
#include "tb/cli/stream.h"
#include "tb/cli/verbs.h"
#include "tb/cost/delays.h"
#include "tb/cost/measured.h"
#include "tb/cost/table.h"
#include "tb/csv_reader.h"
#include "tb/device_arguments.h"
#include "tb/harness/systemc_engine.h"
#include "tb/output_file.h"
#include "tb/progress.h"
#include "tb/waves_file.h"

namespace blysk::cli {
namespace {

struct options {
  asked_device device;
  std::string engine = "bit";
  std::string stimulus, results, vcd, delays, settling;
  std::optional<double> period_ns;
  bool vcd_deltas = false;
  bool clamps = false;
  bool json = false;

  bool is_timed() const { return engine == kTimedEngine; }
};

/// A strobe that came before an output had its value.
struct early_strobe {
  std::uint64_t row;  ///< of the stimulus, from 1
  std::uint64_t at_ps;
  std::string signal;
  std::int64_t got, expected;
};

/// What the engine timed is asked for, and what it shows.
struct timed_run {
  harness::timed_engine* device = nullptr;
  std::unique_ptr<engine> expected;  ///< the same without delays
  columns right;
  double period_ns = 0;
  int bound_ps = 0;
  std::uint64_t settled_after = 0, busy_for = 0;  ///< the most, ps
  std::uint64_t rows = 0, early = 0;
  std::vector<early_strobe> first;  ///< of them
};

constexpr std::size_t kMostShown = 10;

/// What the summary tells of a run.
struct outcome {
  std::uint64_t rows = 0;
  std::uint64_t clamped = 0;
  double seconds = 0;
};

void check(const options& asked) {
  expect_different_files(
      {"--stimulus", "--results", "--vcd", "--delays", "--settling"},
      {input_path(asked.stimulus), asked.results, asked.vcd, asked.delays, asked.settling});
  if (!asked.vcd.empty() && !asked.is_timed() && !find_engine(asked.engine, {kTimedEngine}).is_recorded) {
    throw usage_error(
        fmt::format("--vcd records signals and engine {} has none, expected engine systemc, verilator or {}",
                    asked.engine, kTimedEngine));
  }
  if (asked.vcd_deltas && asked.vcd.empty())
    throw usage_error("--vcd-deltas is about the waves of --vcd, expected that too");
  if (asked.vcd_deltas && asked.engine != "systemc") {
    throw usage_error(
        fmt::format("--vcd-deltas shows SystemC's delta cycles and engine {} {}, expected engine systemc",
                    asked.engine, asked.is_timed() ? "has delays in their place" : "has none"));
  }
  const auto expect_timed = [&](const char* name, bool is_given) {
    if (is_given && !asked.is_timed()) {
      throw usage_error(fmt::format("{} is about delays and engine {} has none, expected engine {}", name,
                                    asked.engine, kTimedEngine));
    }
  };
  expect_timed("--period", asked.period_ns.has_value());
  expect_timed("--delays", !asked.delays.empty());
  expect_timed("--settling", !asked.settling.empty());
  if (asked.period_ns) {
    constexpr double kMostNs = 1e6;
    const double halves = *asked.period_ns * 500;  // ps
    if (!(halves >= 1 && *asked.period_ns <= kMostNs && std::abs(halves - std::round(halves)) < 1e-6)) {
      throw usage_error(
          fmt::format("--period is {}, expected a multiple of 0.002 up to {}: time is counted in ps, and a "
                      "strobe comes after half a period",
                      *asked.period_ns, kMostNs));
    }
  }
}

/// How long so many cycles take at the clocks that the device was seen to reach.
void report_clocks(const selection& device, std::uint64_t cycles, nlohmann::ordered_json& json,
                   std::string& text) {
  nlohmann::ordered_json& clocks = json["measured_clocks"] = nlohmann::ordered_json::array();
  const std::optional<cost::cost_row> row = cost::measured_cost(device);
  if (!row) return;
  const cost::configuration measured{.asked = device, .cost = *row};
  for (const cost::technology& in : cost::technologies()) {
    const double mhz = in.mhz(measured);
    if (mhz <= 0) continue;
    const double ns = 1e3 * static_cast<double>(cycles) / mhz;
    clocks.push_back({{"target", in.name}, {"mhz", mhz}, {"ns", ns}});
    text += fmt::format(", {:.0f} ns at the {:.1f} MHz of {}", ns, mhz, in.name);
  }
}

void report(const options& asked, const selection& device, const outcome& run, const clocked_engine* clocked,
            const timed_run& timed) {
  nlohmann::ordered_json json{{"device", device.of().name()},
                              {"format", device.format()},
                              {"engine", asked.engine},
                              {"rows", run.rows}};
  for (const option& each : device.of().options()) {
    std::string key = each.name;
    std::ranges::replace(key, '-', '_');
    if (each.is_flag()) {
      json[key] = device.flag(each.name);
    } else {
      json[key] = device.value(each.name);
    }
  }
  const std::string chosen = device.is_preset() ? "" : ", " + device.of().words(device);
  std::string text = fmt::format("{} {} through {} {}{}, engine {}", run.rows, run.rows == 1 ? "row" : "rows",
                                 device.of().name(), device.format(), chosen, asked.engine);
  if (asked.clamps) {
    json["clamped"] = run.clamped;
    text += fmt::format(", {} clamped", run.clamped);
  }
  const double rate = run.seconds > 0 ? static_cast<double>(run.rows) / run.seconds : 0;
  json["seconds"] = run.seconds;
  json["rows_per_second"] = rate;
  if (clocked != nullptr) {
    const auto cycles = clocked->cycles();
    const double simulated_ns =
        static_cast<double>(cycles) * (asked.is_timed() ? timed.period_ns : harness::kClockPeriodNs);
    json["cycles"] = cycles;
    json["writes"] = clocked->writes();
    json["simulated_ns"] = simulated_ns;
    text += fmt::format(", {} clock cycles", cycles);
    if (asked.is_timed()) {
      text += fmt::format(", {} ns simulated", simulated_ns);
    } else {
      report_clocks(device, cycles, json, text);
    }
  }
  if (asked.is_timed()) {
    const auto ns = [](std::uint64_t ps) { return static_cast<double>(ps) / 1000; };
    json["period_ns"] = timed.period_ns;
    json["bound_ns"] = timed.bound_ps / 1e3;
    const bool has_settled = timed.rows > timed.early;
    json["settled_ns"] = has_settled ? nlohmann::ordered_json(ns(timed.settled_after)) : nullptr;
    json["busy_ns"] = ns(timed.busy_for);
    json["early"] = timed.early;
    nlohmann::ordered_json& first = json["early_strobes"] = nlohmann::ordered_json::array();
    for (const early_strobe& each : timed.first) {
      first.push_back({{"row", each.row},
                       {"time_ns", ns(each.at_ps)},
                       {"signal", each.signal},
                       {"got", each.got},
                       {"expected", each.expected}});
      fmt::print(
          stderr,
          "blysk: row {}: the strobe at {:.3f} ns comes too early: {} carries the code {}, expected {}\n",
          each.row, ns(each.at_ps), each.signal, each.got, each.expected);
    }
    if (timed.early > timed.first.size())
      fmt::print(stderr, "blysk: {} rows more have such a strobe\n", timed.early - timed.first.size());
    text += fmt::format(", period {} ns", timed.period_ns);
    if (has_settled)
      text += fmt::format(", last change of an output {:.3f} ns after its clock edge{}",
                          ns(timed.settled_after), timed.early > 0 ? " in the rows that settle" : "");
    text += fmt::format(", {} early", timed.early);
  }
  text += fmt::format(": {:.2f} s, {:.0f} rows/s", run.seconds, rate);
  fmt::print(is_standard_output(asked.results) ? stderr : stdout, "{}\n", asked.json ? json.dump(2) : text);
}

/// \throws std::logic_error if the engine has delivered another number of pixels
void count_pixels(const device& of, row_block& block) {
  block.pixels.resize(block.writes.size());
  std::int64_t sum = 0;
  for (std::size_t row = 0; row < block.writes.size(); ++row)
    sum += block.pixels[row] = of.pixels(block.writes, row);
  if (static_cast<std::uint64_t>(sum) != block.computed.size()) {
    throw std::logic_error(fmt::format("{} pixels were delivered, expected {}", block.computed.size(), sum));
  }
}

/// The engine with delays. Without a period it has one in which every write settles.
std::unique_ptr<engine> make_timed(const options& asked, const selection& device, timed_run& to) {
  device_delays delays = cost::read_delays(asked.delays, device, cost::digest_of(device));
  to.bound_ps = delays.bound_ps;
  to.period_ns = asked.period_ns.value_or(2 * std::ceil(delays.bound_ps / 1e3));
  to.expected = device.of().make_bit(device);
  std::unique_ptr<harness::timed_engine> made = harness::make_timed(device, std::move(delays), to.period_ns);
  to.device = made.get();
  return made;
}

/// What the rows that were just read say of their strobes.
void look_at_strobes(timed_run& run, const std::vector<port>& results, const row_block& block,
                     output_file* settling) {
  run.expected->run(block.writes, run.right);
  for (std::size_t row = 0; row < block.writes.size(); ++row) {
    ++run.rows;
    const harness::write_timing& timing = run.device->timings()[row];
    run.busy_for = std::max(run.busy_for, timing.busy_for);
    const std::uint64_t early_before = run.early;
    for (std::size_t i = 0; i < results.size(); ++i) {
      const std::int64_t got = block.computed[i].get(row);
      const std::int64_t expected = run.right[i].get(row);
      if (got == expected || results[i].is_inner) continue;  // the strobe confirms what leaves the device
      if (run.first.size() < kMostShown)
        run.first.push_back({run.rows, timing.read_at, results[i].wave, got, expected});
      ++run.early;
      break;
    }
    // What the strobe of an early row cut short has not settled.
    const bool has_settled = run.early == early_before;
    if (has_settled) run.settled_after = std::max(run.settled_after, timing.settled_after);
    if (settling == nullptr) continue;
    const std::string settled =
        has_settled ? fmt::format("{:.3f}", static_cast<double>(timing.settled_after) / 1000) : "";
    settling->write(
        fmt::format("{},{},{:.3f}\n", run.rows, settled, static_cast<double>(timing.busy_for) / 1000));
  }
}

/// \return  the exit status: 1 if a strobe came too early
int run(const options& asked) {
  check(asked);
  const engine_choice* const choice = asked.is_timed() ? nullptr : &find_engine(asked.engine, {kTimedEngine});
  const selection device = asked.device.choose(choice == nullptr ? purpose::hardware : choice->serves);
  const std::vector<port> ports = device.of().ports(device);
  csv_reader rows(asked.stimulus, stimulus_header(ports));
  output_file results(asked.results);
  std::optional<waves_file> waves;
  std::optional<output_file> settling;
  if (!asked.settling.empty()) {
    settling.emplace(asked.settling);
    settling->write("row,settled_ns,busy_ns\n");
  }
  timed_run timed;
  const std::unique_ptr<engine> simulated =
      choice == nullptr ? make_timed(asked, device, timed)
                        : choice->make(device, asked.vcd.empty() ? cosim::waves::off : cosim::waves::on);
  const std::vector<port> result_ports = of_role(ports, port::role::result);
  auto* const recorded = dynamic_cast<recorded_engine*>(simulated.get());
  if (!asked.vcd.empty()) {
    waves.emplace(asked.vcd);
    if (asked.vcd_deltas) dynamic_cast<harness::systemc_engine&>(*simulated).record_deltas();
    recorded->trace(waves->recorded_path());
  }
  outcome done;
  {
    progress shown("simulate: bytes read", rows.file_size(), !is_shown_at(asked.results));
    const auto start = std::chrono::steady_clock::now();
    stimulus_reader stimulus(rows, ports, asked.clamps);
    done.rows = stream(
        stimulus,
        [&](row_block& block) {
          simulated->run(block.writes, block.computed);
          if (timed.device != nullptr)
            look_at_strobes(timed, result_ports, block, settling ? &*settling : nullptr);
          if (device.of().draws_lines()) count_pixels(device.of(), block);
          shown.reach(rows.bytes_read());
        },
        results, device.of().draws_lines() ? row_kind::pixels : row_kind::writes);
    done.clamped = stimulus.clamped();
    done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  results.close();
  if (settling) settling->close();
  if (waves) waves->commit(recorded->stop_trace());
  results.commit();
  if (settling) settling->commit();
  report(asked, device, done, dynamic_cast<const clocked_engine*>(simulated.get()), timed);
  return timed.early > 0 ? 1 : 0;
}

}  // namespace

void add_simulate(CLI::App& program, int& status) {
  auto* verb = program.add_subcommand("simulate", "Run a device on the writes of a CSV file");
  auto asked = std::make_shared<options>();
  add_device_arguments(*verb, asked->device, purpose::formula);
  std::string engines;
  for (const engine_choice& each : engine_choices())
    engines += fmt::format("{}{}: {}", engines.empty() ? "" : "; ", each.name, each.help);
  engines += fmt::format("; {}: as systemc, with the measured delays of its blocks", kTimedEngine);
  verb->add_option("--engine", asked->engine, engines)->capture_default_str();
  verb->add_option(
          "--stimulus", asked->stimulus,
          "CSV of the device's stimulus, see blysk list: n 1..1000, cos in [0, 1], colours 0..255 under the "
          "header n,cos,r,g,b; other columns are passed over; - for standard input")
      ->required();
  verb->add_option("--results", asked->results,
                   "CSV to write: the stimulus as the device takes it, or line and pixel, and the results; - "
                   "for standard "
                   "output")
      ->required();
  verb->add_option(
      "--vcd", asked->vcd,
      "record the waves (engine systemc, verilator or timed); FST if the name ends with .fst and "
      "vcd2fst is installed");
  verb->add_flag("--vcd-deltas", asked->vcd_deltas,
                 "write each delta cycle 1 ps after the one before it, which shows the order of settling");
  verb->add_option(
          "--period", asked->period_ns,
          "ns of the clock (engine timed); a strobe comes half of it after the registers are loaded, and "
          "one that comes too early is reported. Without it the period is long enough for all writes")
      ->transform(real_number());
  verb->add_option(
      "--delays", asked->delays,
      "delays of the blocks (engine timed), as scripts/synth --delays writes them; without it those "
      "that were measured when the program was built");
  verb->add_option(
      "--settling", asked->settling,
      "CSV to write (engine timed): for each row how long the outputs changed after its clock edge, "
      "and how long they might have");
  verb->add_flag(
      "--clamp", asked->clamps,
      "take real numbers not more than 2^-23 outside their range, as rounding leaves them, for its end; the "
      "summary counts them");
  verb->add_flag("--json", asked->json, "print the summary as JSON");
  verb->footer(
      "Examples:\n"
      "  blysk simulate --format q12 --stimulus in.csv --results -\n"
      "  blysk simulate --engine systemc --stimulus in.csv --results out.csv --vcd waves.vcd\n"
      "  blysk simulate --engine golden --coefficient exact --stimulus in.csv --results out.csv --json\n"
      "  blysk simulate --engine timed --format q8 --stimulus in.csv --results out.csv --vcd waves.vcd\n"
      "Exit status 1: a strobe of --engine timed came too early.");
  verb->callback([asked, &status] { status = run(*asked); });
}

}  // namespace blysk::cli
