// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "tb/cli/engines.h"
#include "tb/cli/stream.h"
#include "tb/cli/verbs.h"
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
  std::string stimulus, results, vcd;
  bool clamps = false;
  bool json = false;
};

/// What the summary tells of a run.
struct outcome {
  std::uint64_t rows = 0;
  std::uint64_t clamped = 0;
  double seconds = 0;
};

void check(const options& asked) {
  expect_different_files({"--stimulus", "--results", "--vcd"}, {asked.stimulus, asked.results, asked.vcd});
  if (!asked.vcd.empty() && !find_engine(asked.engine).is_recorded) {
    throw usage_error(fmt::format(
        "--vcd records signals and engine {} has none, expected engine systemc or verilator", asked.engine));
  }
}

void report(const options& asked, const selection& device, const outcome& run,
            const clocked_engine* clocked) {
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
  std::string text = fmt::format("{} rows through {} {}, engine {}", run.rows, device.of().name(),
                                 device.format(), asked.engine);
  if (asked.clamps) {
    json["clamped"] = run.clamped;
    text += fmt::format(", {} clamped", run.clamped);
  }
  const double rate = run.seconds > 0 ? static_cast<double>(run.rows) / run.seconds : 0;
  json["seconds"] = run.seconds;
  json["rows_per_second"] = rate;
  if (clocked != nullptr) {
    const auto cycles = clocked->cycles();
    const double simulated_ns = static_cast<double>(cycles) * harness::kClockPeriodNs;
    json["cycles"] = cycles;
    json["writes"] = clocked->writes();
    json["simulated_ns"] = simulated_ns;
    text += fmt::format(", {} clock cycles, {} ns simulated", cycles, simulated_ns);
  }
  text += fmt::format(": {:.2f} s, {:.0f} rows/s", run.seconds, rate);
  fmt::print(asked.results == "-" ? stderr : stdout, "{}\n", asked.json ? json.dump(2) : text);
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

void run(const options& asked) {
  check(asked);
  const engine_choice& choice = find_engine(asked.engine);
  const selection device = asked.device.choose(choice.serves);
  const std::vector<port> ports = device.of().ports(device);
  csv_reader rows(asked.stimulus, stimulus_header(ports));
  output_file results(asked.results);
  const std::unique_ptr<engine> simulated =
      choice.make(device, asked.vcd.empty() ? cosim::waves::off : cosim::waves::on);
  auto* const recorded = dynamic_cast<recorded_engine*>(simulated.get());
  std::optional<waves_file> waves;
  if (!asked.vcd.empty()) {
    waves.emplace(asked.vcd);
    recorded->trace(waves->recorded_path());
  }
  outcome done;
  {
    const bool mixes_with_results = asked.results == "-" && isatty(STDOUT_FILENO) == 1;
    progress shown("simulate: bytes read", rows.file_size(), !mixes_with_results);
    const auto start = std::chrono::steady_clock::now();
    stimulus_reader stimulus(rows, ports, asked.clamps);
    done.rows = stream(
        stimulus,
        [&](row_block& block) {
          simulated->run(block.writes, block.computed);
          if (device.of().draws_lines()) count_pixels(device.of(), block);
          shown.reach(rows.bytes_read());
        },
        results, device.of().draws_lines() ? row_kind::pixels : row_kind::writes);
    done.clamped = stimulus.clamped();
    done.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  results.close();
  if (waves) waves->commit(recorded->stop_trace());
  results.commit();
  report(asked, device, done, dynamic_cast<const clocked_engine*>(simulated.get()));
}

}  // namespace

void add_simulate(CLI::App& program) {
  auto* verb = program.add_subcommand("simulate", "Run a device on the writes of a CSV file");
  auto asked = std::make_shared<options>();
  add_device_arguments(*verb, asked->device, purpose::formula);
  std::string engines;
  for (const engine_choice& each : engine_choices())
    engines += fmt::format("{}{}: {}", engines.empty() ? "" : "; ", each.name, each.help);
  verb->add_option("--engine", asked->engine, engines)->capture_default_str();
  verb->add_option(
          "--stimulus", asked->stimulus,
          "CSV of the device's stimulus, see blysk list: n 1..1000, cos in [0, 1], colours 0..255 under the "
          "header n,cos,r,g,b; other columns are passed over; - for standard input")
      ->required();
  verb->add_option(
          "--results", asked->results,
          "CSV to write: the stimulus as the device takes it, and the results; - for standard output")
      ->required();
  verb->add_option("--vcd", asked->vcd,
                   "record the waves (engine systemc or verilator); FST if the name ends with .fst and "
                   "vcd2fst is installed");
  verb->add_flag(
      "--clamp", asked->clamps,
      "take real numbers not more than 2^-23 outside their range, as rounding leaves them, for its end; the "
      "summary counts them");
  verb->add_flag("--json", asked->json, "print the summary as JSON");
  verb->footer(
      "Examples:\n"
      "  blysk simulate --format q12 --stimulus in.csv --results -\n"
      "  blysk simulate --engine systemc --stimulus in.csv --results out.csv --vcd waves.vcd\n"
      "  blysk simulate --engine golden --coefficient exact --stimulus in.csv --results out.csv --json");
  verb->callback([asked] { run(*asked); });
}

}  // namespace blysk::cli
