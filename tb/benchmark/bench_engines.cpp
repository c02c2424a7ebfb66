// SPDX-License-Identifier: Apache-2.0
// Results per second of the engines, and their ratios in one run: absolute times depend on the machine.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <optional>
#include <random>
#include <span>
#include <string>
#include <systemc>
#include <vector>

#include "tb/golden/lobe.h"
#include "tb/harness/systemc_engine.h"
#include "tb/run_program.h"
#include "tb/specular/specular.h"
#include "tb/waves_file.h"

namespace {

using namespace blysk;

constexpr std::size_t kColumn = 1024;  // elements whose columns stay in cache
constexpr const char* kPerBareCycle = "results_per_bare_cycle";
constexpr std::size_t kWrites = 100000;  // through SystemC, a time

/// The first device of the list, in a format.
selection choose_device(const std::string& format) {
  return choose(devices().front()->name(), format);
}

/// Random writes, seed 1. Only cos changes, as along a scan line, or every register.
columns random_writes(const selection& asked, std::size_t size, bool all_registers) {
  std::mt19937 random(1);
  columns writes(asked.of().ports(asked), port::role::data);
  writes.resize(size);
  const std::uint32_t codes = (1u << asked.fraction()) + 1;
  for (std::size_t i = 0; i < size; ++i) {
    writes[specular::kCos].set(i, random() % codes);
    writes[specular::kN].set(i, all_registers ? 1 + random() % 1000 : 50);
    writes[specular::kRed].set(i, all_registers ? random() % 256 : 200);
    writes[specular::kGreen].set(i, all_registers ? random() % 256 : 100);
    writes[specular::kBlue].set(i, all_registers ? random() % 256 : 50);
  }
  return writes;
}

/// A column as real numbers.
std::vector<double> reals(const column& from, double scale = 1) {
  std::vector<double> values(from.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = from.real(i) * scale;
  return values;
}

void set_items(benchmark::State& state, std::size_t items) {
  state.SetItemsProcessed(static_cast<std::int64_t>(items) * state.iterations());
}

/// Blinn's c^n by std::pow and its three colours, in double: what the device replaces.
void golden_blinn(benchmark::State& state) {
  const columns writes = random_writes(choose_device("q16"), kColumn, true);
  const std::vector<double> n = reals(writes[specular::kN]);
  const std::vector<double> c = reals(writes[specular::kCos], 1 / 65536.0);
  const std::vector<double> r = reals(writes[specular::kRed]);
  const std::vector<double> g = reals(writes[specular::kGreen]);
  const std::vector<double> b = reals(writes[specular::kBlue]);
  std::vector<double> red(kColumn), green(kColumn), blue(kColumn);
  for (auto _ : state) {
    for (std::size_t i = 0; i < kColumn; ++i) {
      const double brdf = std::pow(c[i], n[i]);
      red[i] = brdf * r[i];
      green[i] = brdf * g[i];
      blue[i] = brdf * b[i];
    }
    benchmark::ClobberMemory();
  }
  set_items(state, kColumn);
}

/// The device's own formula in double, a picture at a time: one exponent, one BRDF an element.
void golden_quadratic(benchmark::State& state) {
  const columns writes = random_writes(choose_device("q16"), kColumn, false);
  const std::vector<double> cosines = reals(writes[specular::kCos], 1 / 65536.0);
  std::vector<double> brdf(kColumn);
  for (auto _ : state) {
    golden::evaluate(golden::lobe::quadratic_derived, 50.0, std::span<const double>(cosines),
                     std::span<double>(brdf));
    benchmark::ClobberMemory();
  }
  set_items(state, kColumn);
}

/// The engine as `simulate` calls it: columns in, columns out.
void bit_engine(benchmark::State& state, const std::string& format) {
  const selection asked = choose_device(format);
  const columns writes = random_writes(asked, kColumn, true);
  const auto device = asked.of().make_bit(asked);
  columns out;
  for (auto _ : state) {
    device->run(writes, out);
    benchmark::ClobberMemory();
  }
  set_items(state, kColumn);
}

/// The same on the kernel whose word lengths are numbers of the moment.
void bit_free(benchmark::State& state, const std::string& format) {
  const selection asked = choose_device(format);
  const columns writes = random_writes(asked, kColumn, true);
  const auto device = asked.of().make_bit(asked, asked.of().widths(asked));
  columns out;
  for (auto _ : state) {
    device->run(writes, out);
    benchmark::ClobberMemory();
  }
  set_items(state, kColumn);
}

/// Seconds that `work` says it took, in a process of its own: SystemC elaborates once per process.
template <class Work>
double seconds_in_child(Work&& work) {
  int ends[2];
  if (pipe(ends) != 0) std::abort();
  const pid_t child = fork();
  if (child < 0) std::abort();
  if (child == 0) {
    close(ends[0]);
    bool written = false;
    try {
      const double seconds = work();
      written = write(ends[1], &seconds, sizeof seconds) == sizeof seconds;
    } catch (const std::exception&) {  // no answer then
    }
    _exit(written ? 0 : 1);
  }
  close(ends[1]);  // or a child that dies would leave the pipe open
  double seconds = 0;
  const bool answered = read(ends[0], &seconds, sizeof seconds) == sizeof seconds;
  close(ends[0]);
  int status = 0;
  if (waitpid(child, &status, 0) != child || status != 0 || !answered) std::abort();
  return seconds;
}

/// Processor time of `work`, which other load on the machine disturbs less than the clock on the wall.
template <class Work>
double seconds(Work&& work) {
  const std::clock_t started = std::clock();
  work();
  return static_cast<double>(std::clock() - started) / CLOCKS_PER_SEC;
}

/// The least that a clocked SystemC model can be: a clock and one register.
struct bare_clock : sc_core::sc_module {
  sc_core::sc_clock clk{"clk", sc_core::sc_time(harness::kClockPeriodNs, sc_core::SC_NS)};
  sc_core::sc_signal<sc_dt::sc_uint<16>> SC_NAMED(q);
  SC_CTOR(bare_clock) {
    SC_METHOD(count);
    sensitive << clk.posedge_event();
    dont_initialize();
  }
  void count() { q.write(q.read() + 1); }
};

/// Seconds a cycle of the bare clock.
double bare_clock_seconds() {
  constexpr std::size_t kCycles = 500000;
  return seconds_in_child([] {
           bare_clock bare("bare");
           sc_core::sc_start(harness::kClockPeriodNs, sc_core::SC_NS);
           return seconds([] { sc_core::sc_start(harness::kClockPeriodNs * kCycles, sc_core::SC_NS); });
         }) /
         kCycles;
}

/// Each time beside a bare clock of its own, so that what else the machine does falls on both.
void systemc_device(benchmark::State& state, bool all_registers, bool traced) {
  const std::size_t count = traced ? kWrites / 10 : kWrites;
  for (auto _ : state) {
    const double bare = bare_clock_seconds();
    const double taken = seconds_in_child([&] {
      const auto device = harness::make_systemc(choose_device("q16"));
      std::optional<waves_file> waves;  // never committed
      if (traced) {
        waves.emplace((std::filesystem::temp_directory_path() / "blysk-bench.vcd").string());
        device->trace(waves->recorded_path());
      }
      const columns writes = random_writes(choose_device("q16"), count, all_registers);
      columns out;
      device->run(random_writes(choose_device("q16"), 2, true), out);
      const double device_seconds = seconds([&] { device->run(writes, out); });
      return device_seconds;
    });
    state.SetIterationTime(taken);
    state.counters[kPerBareCycle] = bare / (taken / static_cast<double>(count));
  }
  set_items(state, count);
}

/// Remembers the median rates while the table is printed.
class rate_reporter : public benchmark::ConsoleReporter {
 public:
  using ConsoleReporter::ConsoleReporter;

  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.aggregate_name != "median") continue;
      const std::string name = run.run_name.function_name;
      rates[name] = run.counters.at("items_per_second");
      if (run.counters.count(kPerBareCycle) != 0) per_bare_cycle[name] = run.counters.at(kPerBareCycle);
    }
  }
  std::map<std::string, double> rates, per_bare_cycle;
};

/// Colours on a terminal alone, or as --benchmark_color says: the library asks only where the reporter is its own.
benchmark::ConsoleReporter::OutputOptions output_options(int argc, char** argv) {
  bool is_coloured = isatty(STDOUT_FILENO) == 1;
  for (const std::string_view word : std::span(argv, static_cast<std::size_t>(argc))) {
    constexpr std::string_view option = "--benchmark_color=";
    if (!word.starts_with(option) || word == "--benchmark_color=auto") continue;
    const std::string_view value = word.substr(option.size());
    is_coloured = value != "false" && value != "no" && value != "0";
  }
  using reporter = benchmark::ConsoleReporter;
  return is_coloured ? reporter::OO_ColorTabular : reporter::OO_Tabular;
}

int run(int argc, char** argv) {
  const auto options = output_options(argc, argv);
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  const auto add = [](const char* name, auto function) {
    return benchmark::RegisterBenchmark(name, function)->Repetitions(9)->ReportAggregatesOnly();
  };
  add("golden_blinn", golden_blinn);
  add("golden_quadratic", golden_quadratic);
  for (const std::string format : {"q8", "q16", "q22", "q24"}) {
    add(("bit_" + format).c_str(), [format](benchmark::State& state) { bit_engine(state, format); });
    add(("bit_free_" + format).c_str(), [format](benchmark::State& state) { bit_free(state, format); });
  }
  const auto add_device = [&](const char* name, bool all_registers, bool traced) {
    add(name, [=](benchmark::State& state) { systemc_device(state, all_registers, traced); })
        ->UseManualTime()
        ->Iterations(1);
  };
  add_device("systemc_cos_only", false, false);
  add_device("systemc_all_registers", true, false);
  add_device("systemc_cos_only_vcd", false, true);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  rate_reporter reporter(options);
  benchmark::RunSpecifiedBenchmarks(&reporter);
  const auto ratio = [&](const char* what, const char* a, const char* b) {
    if (reporter.rates.count(a) != 0 && reporter.rates.count(b) != 0) {
      fmt::print("{:<58} {:8.3f}\n", what, reporter.rates[a] / reporter.rates[b]);
    }
  };
  fmt::print("\nratios of the medians; those to the bare clock are medians of pairs\n");
  ratio("bit q8 / golden Blinn (std::pow)", "bit_q8", "golden_blinn");
  ratio("bit q16 / golden Blinn (std::pow)", "bit_q16", "golden_blinn");
  ratio("bit q22 / golden Blinn (std::pow)", "bit_q22", "golden_blinn");
  ratio("bit q24 / golden Blinn (std::pow)", "bit_q24", "golden_blinn");
  ratio("bit q16, word lengths at run time / golden Blinn (std::pow)", "bit_free_q16", "golden_blinn");
  ratio("bit q24, word lengths at run time / golden Blinn (std::pow)", "bit_free_q24", "golden_blinn");
  ratio("golden quadratic, BRDF alone / golden Blinn (std::pow)", "golden_quadratic", "golden_blinn");
  const auto bare_ratio = [&](const char* what, const char* name) {
    if (reporter.per_bare_cycle.count(name) != 0)
      fmt::print("{:<58} {:8.3f}\n", what, reporter.per_bare_cycle[name]);
  };
  bare_ratio("systemc results, cos alone written / cycle of bare clock", "systemc_cos_only");
  bare_ratio("systemc results, all registers written / cycle of bare clock", "systemc_all_registers");
  ratio("systemc without a VCD / with one (price of the waves)", "systemc_cos_only", "systemc_cos_only_vcd");
  return 0;
}

}  // namespace

int sc_main(int, char**) {
  return 0;
}

int main(int argc, char** argv) {
  return blysk::run_program("bench_engines", [&] { return run(argc, argv); });
}
