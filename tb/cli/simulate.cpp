// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "tb/bench/systemc_engine.h"
#include "tb/bit/quadratic.h"
#include "tb/cli/device_arguments.h"
#include "tb/cli/engines.h"
#include "tb/cli/stream.h"
#include "tb/cli/verbs.h"
#include "tb/cosim/verilator_engine.h"
#include "tb/csv_reader.h"
#include "tb/golden/lobe_formulas.h"
#include "tb/output_file.h"

namespace blysk::cli {
namespace {

struct options {
  device_options device;
  std::string engine = "bit";
  std::string stimulus, results, vcd;
  bool json = false;
};

golden::coefficient_line line_of(const std::string& coefficient) {
  if (coefficient == "published") return golden::coefficient_line::published;
  if (coefficient == "derived") return golden::coefficient_line::derived;
  return golden::coefficient_line::exact;
}

/// The engine asked for.
struct simulation {
  std::function<void(row_block&)> compute;
  bench::systemc_engine* systemc = nullptr;  // if it is SystemC
  const clocked_engine* clocked = nullptr;   // if it has a clock
};

simulation simulation_on(const std::shared_ptr<engine>& integers) {
  return {[integers](row_block& block) { integers->run(block.writes, block.compute_as<results>()); },
          dynamic_cast<bench::systemc_engine*>(integers.get()),
          dynamic_cast<const clocked_engine*>(integers.get())};
}

simulation make_simulation(const options& asked) {
  if (asked.engine == "bit") return simulation_on(bit::make_quadratic(asked.device));
  if (asked.engine == "systemc") return simulation_on(bench::make_systemc(asked.device));
  if (asked.engine == "verilator") return simulation_on(cosim::make_verilator(asked.device));
  if (!asked.device.constant.empty())
    throw usage_error("--constant is wired in hardware, expected engine bit or systemc");
  return {[line = line_of(asked.device.coefficient), as_published = asked.device.as_published,
           fraction = fraction_bits(asked.device)](row_block& block) {
    const batch& writes = block.writes;
    auto& brdf = block.compute_as<std::vector<double>>();
    brdf.resize(writes.size());
    for (std::size_t i = 0; i < writes.size(); ++i) {
      const double raw =
          golden::quadratic<double>(line, writes.n[i], std::ldexp(writes.cos_delta[i], -fraction));
      brdf[i] = as_published ? raw : std::clamp(raw, 0.0, 1.0);
    }
  }};
}

void check(const options& asked) {
  expect_different_files({"--stimulus", "--results", "--vcd"}, {asked.stimulus, asked.results, asked.vcd});
  const bool hardware = asked.engine != "golden";
  if (hardware && asked.device.coefficient == "exact") {
    throw usage_error("--coefficient exact has no wires, expected published or derived, or engine golden");
  }
  if (!asked.vcd.empty() && asked.engine != "systemc") {
    throw usage_error(
        fmt::format("--vcd records signals and engine {} has none, expected engine systemc", asked.engine));
  }
}

void report(const options& asked, std::uint64_t rows, const simulation& simulated) {
  nlohmann::ordered_json json{{"device", asked.device.device},
                              {"format", asked.device.format},
                              {"engine", asked.engine},
                              {"coefficient", asked.device.coefficient},
                              {"as_published", asked.device.as_published},
                              {"rows", rows}};
  std::string text = fmt::format("{} rows through {} {}, engine {}", rows, asked.device.device,
                                 asked.device.format, asked.engine);
  if (simulated.clocked != nullptr) {
    const auto cycles = simulated.clocked->cycles();
    const double simulated_ns = static_cast<double>(cycles) * bench::kClockPeriodNs;
    json["cycles"] = cycles;
    json["writes"] = simulated.clocked->writes();
    json["simulated_ns"] = simulated_ns;
    text += fmt::format(": {} clock cycles, {} ns simulated", cycles, simulated_ns);
  }
  fmt::print(asked.results == "-" ? stderr : stdout, "{}\n", asked.json ? json.dump(2) : text);
}

void run(const options& asked) {
  check(asked);
  csv_reader rows(asked.stimulus, kStimulusHeader);
  output_file results(asked.results);
  std::optional<output_file> waves;
  const simulation simulated = make_simulation(asked);
  if (!asked.vcd.empty()) {
    constexpr std::string_view ending = ".vcd";  // SystemC appends it
    waves.emplace(asked.vcd, ending);
    const std::string& path = waves->temporary_path();
    if (path.empty()) throw file_error(asked.vcd, 0, "is no regular file, expected one to write");
    simulated.systemc->trace(path.substr(0, path.size() - ending.size()));
  }
  const std::uint64_t count = stream(rows, fraction_bits(asked.device), simulated.compute, results);
  results.close();
  if (waves) {
    if (count == 0) sc_core::sc_start(1, sc_core::SC_PS);  // SystemC writes the state at 0 as time goes on
    if (!simulated.systemc->stop_trace()) {
      throw file_error(asked.vcd, 0, "cannot be written to its end, expected room for the waves");
    }
    waves->commit();
  }
  results.commit();
  report(asked, count, simulated);
}

}  // namespace

void add_simulate(CLI::App& program) {
  auto* verb = program.add_subcommand("simulate", "Run a device on the writes of a CSV file");
  auto asked = std::make_shared<options>();
  add_device_arguments(*verb, asked->device, {"published", "derived", "exact"});
  verb->add_option("--engine", asked->engine,
                   "golden: the formula in double; bit: integers; systemc: the blocks; "
                   "verilator: their exported Verilog")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(engine_names), std::end(engine_names))))
      ->capture_default_str();
  verb->add_option(
          "--stimulus", asked->stimulus,
          "CSV with the header n,cos,r,g,b: n 1..1000, cos in [0, 1], colours 0..255; - for standard input")
      ->required();
  verb->add_option(
          "--results", asked->results,
          "CSV to write: the stimulus (cos as quantised) and brdf,red,green,blue; - for standard output")
      ->required();
  verb->add_option("--vcd", asked->vcd, "record the waves (engine systemc)");
  verb->add_flag("--json", asked->json, "print the summary as JSON");
  verb->callback([asked] { run(*asked); });
}

}  // namespace blysk::cli
