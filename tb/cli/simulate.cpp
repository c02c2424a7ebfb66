// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "tb/bench/systemc_engine.h"
#include "tb/bit/quadratic.h"
#include "tb/cli/device_arguments.h"
#include "tb/cli/engines.h"
#include "tb/cli/rows.h"
#include "tb/cli/verbs.h"
#include "tb/cosim/verilator_engine.h"
#include "tb/files.h"
#include "tb/golden/lobe_formulas.h"

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

/// Computes blocks of writes with the engine asked for and appends their rows to the text of the results.
class simulation {
 public:
  explicit simulation(const options& asked) : asked_(asked), fraction_(fraction_bits(asked.device)) {
    if (asked.engine == "bit") {
      engine_ = bit::make_quadratic(asked.device);
    } else if (asked.engine == "systemc") {
      auto made = bench::make_systemc(asked.device);
      systemc_ = made.get();
      clocked_ = systemc_;
      engine_ = std::move(made);
    } else if (asked.engine == "verilator") {
      auto made = cosim::make_verilator(asked.device);
      clocked_ = made.get();
      engine_ = std::move(made);
    } else if (!asked.device.constant.empty()) {
      throw usage_error("--constant is wired in hardware, expected engine bit or systemc");
    }
  }

  int fraction() const { return fraction_; }
  bench::systemc_engine* systemc() const { return systemc_; }
  const clocked_engine* clocked() const { return clocked_; }

  void run(const batch& block, fmt::memory_buffer& text) {
    if (engine_ != nullptr) {
      engine_->run(block, raw_);
      for (std::size_t i = 0; i < block.size(); ++i) append_row(text, block, raw_, i, fraction_);
    } else {
      for (std::size_t i = 0; i < block.size(); ++i) {
        append_row(text, block, golden_brdf(block.n[i], std::ldexp(block.cos_delta[i], -fraction_)), i,
                   fraction_);
      }
    }
  }

 private:
  double golden_brdf(double n, double c) const {
    const double brdf = golden::quadratic(line_of(asked_.device.coefficient), n, c);
    return asked_.device.as_published ? brdf : std::fmin(std::fmax(brdf, 0.0), 1.0);
  }

  const options& asked_;
  int fraction_;
  std::unique_ptr<engine> engine_;            // null: golden
  bench::systemc_engine* systemc_ = nullptr;  // engine_ if it is SystemC
  const clocked_engine* clocked_ = nullptr;   // engine_ if it has a clock
  results raw_;
};

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
  if (simulated.clocked() != nullptr) {
    const auto cycles = simulated.clocked()->cycles();
    const double simulated_ns = static_cast<double>(cycles) * bench::kClockPeriodNs;
    json["cycles"] = cycles;
    json["writes"] = simulated.clocked()->writes();
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
  simulation simulated(asked);
  if (!asked.vcd.empty()) {
    constexpr std::string_view ending = ".vcd";  // SystemC appends it
    waves.emplace(asked.vcd, ".part.vcd");
    const std::string& path = waves->temporary_path();
    if (path.empty()) throw file_error(asked.vcd, 0, "is no regular file, expected one to write");
    simulated.systemc()->trace(path.substr(0, path.size() - ending.size()));
  }
  batch block;
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{}\n", kResultsHeader);
  std::uint64_t count = 0;
  for (;;) {
    read_block(rows, simulated.fraction(), block);
    if (block.size() == 0) break;
    simulated.run(block, text);
    count += block.size();
    results.write({text.data(), text.size()});
    text.clear();
  }
  results.write({text.data(), text.size()});
  results.close();
  if (waves) {
    if (!simulated.systemc()->stop_trace()) {
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
