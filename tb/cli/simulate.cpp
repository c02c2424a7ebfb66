// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "tb/cli/engines.h"
#include "tb/cli/stream.h"
#include "tb/cli/verbs.h"
#include "tb/csv_reader.h"
#include "tb/device_arguments.h"
#include "tb/harness/systemc_engine.h"
#include "tb/output_file.h"

namespace blysk::cli {
namespace {

struct options {
  asked_device device;
  std::string engine = "bit";
  std::string stimulus, results, vcd;
  bool json = false;
};

void check(const options& asked) {
  expect_different_files({"--stimulus", "--results", "--vcd"}, {asked.stimulus, asked.results, asked.vcd});
  if (!asked.vcd.empty() && asked.engine != "systemc") {
    throw usage_error(
        fmt::format("--vcd records signals and engine {} has none, expected engine systemc", asked.engine));
  }
}

void report(const options& asked, const selection& device, std::uint64_t rows,
            const clocked_engine* clocked) {
  nlohmann::ordered_json json{
      {"device", device.of().name()}, {"format", device.format()}, {"engine", asked.engine}, {"rows", rows}};
  for (const option& each : device.of().options()) {
    std::string key = each.name;
    std::ranges::replace(key, '-', '_');
    if (each.is_flag()) {
      json[key] = device.flag(each.name);
    } else {
      json[key] = device.value(each.name);
    }
  }
  std::string text = fmt::format("{} rows through {} {}, engine {}", rows, device.of().name(),
                                 device.format(), asked.engine);
  if (clocked != nullptr) {
    const auto cycles = clocked->cycles();
    const double simulated_ns = static_cast<double>(cycles) * harness::kClockPeriodNs;
    json["cycles"] = cycles;
    json["writes"] = clocked->writes();
    json["simulated_ns"] = simulated_ns;
    text += fmt::format(": {} clock cycles, {} ns simulated", cycles, simulated_ns);
  }
  fmt::print(asked.results == "-" ? stderr : stdout, "{}\n", asked.json ? json.dump(2) : text);
}

void run(const options& asked) {
  check(asked);
  const engine_choice& choice = find_engine(asked.engine);
  const selection device = asked.device.choose(choice.serves);
  const std::vector<port> ports = device.of().ports(device);
  csv_reader rows(asked.stimulus, stimulus_header(ports));
  output_file results(asked.results);
  std::optional<output_file> waves;
  const std::unique_ptr<engine> simulated = choice.make(device);
  auto* const systemc = dynamic_cast<harness::systemc_engine*>(simulated.get());
  if (!asked.vcd.empty()) {
    constexpr std::string_view ending = ".vcd";  // SystemC appends it
    waves.emplace(asked.vcd, ending);
    const std::string& path = waves->temporary_path();
    if (path.empty()) throw file_error(asked.vcd, 0, "is no regular file, expected one to write");
    systemc->trace(path.substr(0, path.size() - ending.size()));
  }
  const std::uint64_t count = stream(
      rows, ports, [&](row_block& block) { simulated->run(block.writes, block.computed); }, results);
  results.close();
  if (waves) {
    if (!systemc->stop_trace()) {
      throw file_error(asked.vcd, 0, "cannot be written to its end, expected room for the waves");
    }
    waves->commit();
  }
  results.commit();
  report(asked, device, count, dynamic_cast<const clocked_engine*>(simulated.get()));
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
          "header n,cos,r,g,b; - for standard input")
      ->required();
  verb->add_option(
          "--results", asked->results,
          "CSV to write: the stimulus as the device takes it, and the results; - for standard output")
      ->required();
  verb->add_option("--vcd", asked->vcd, "record the waves (engine systemc)");
  verb->add_flag("--json", asked->json, "print the summary as JSON");
  verb->footer(
      "Examples:\n"
      "  blysk simulate --format q12 --stimulus in.csv --results -\n"
      "  blysk simulate --engine systemc --stimulus in.csv --results out.csv --vcd waves.vcd\n"
      "  blysk simulate --engine golden --coefficient exact --stimulus in.csv --results out.csv --json");
  verb->callback([asked] { run(*asked); });
}

}  // namespace blysk::cli
