// SPDX-License-Identifier: Apache-2.0
// Where the time of `simulate` goes: reading CSV, the engine, writing CSV.
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <random>

#include "tb/bench/systemc_engine.h"
#include "tb/bit/quadratic.h"
#include "tb/cli/rows.h"
#include "tb/cosim/verilator_engine.h"

namespace {

using namespace blysk;
using namespace blysk::cli;
using clock_type = std::chrono::steady_clock;

/// Adds the time of `work` to `seconds`.
template <class Work>
void add_time(double& seconds, Work&& work) {
  const auto start = clock_type::now();
  work();
  seconds += std::chrono::duration<double>(clock_type::now() - start).count();
}

/// Random writes, seed 1: cosines of six decimals, every register rewritten.
void write_stimulus(const std::string& path, int rows) {
  std::mt19937 random(1);
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{}\n", kStimulusHeader);
  for (int i = 0; i < rows; ++i) {
    fmt::format_to(std::back_inserter(text), "{},{:.6f},{},{},{}\n", 1 + random() % 1000,
                   static_cast<double>(random()) * 0x1p-32, random() % 256, random() % 256, random() % 256);
  }
  output_file file(path);
  file.write({text.data(), text.size()});
  file.commit();
}

void show_split(std::string_view name, engine& device, int fraction, const std::filesystem::path& folder,
                int rows) {
  write_stimulus(folder / "stimulus.csv", rows);
  double reading = 0;
  double running = 0;
  double writing = 0;
  csv_reader stimulus(folder / "stimulus.csv", kStimulusHeader);
  output_file file(folder / "results.csv");
  batch block;
  results raw;
  fmt::memory_buffer text;
  for (;;) {
    add_time(reading, [&] { read_block(stimulus, fraction, block); });
    if (block.size() == 0) break;
    add_time(running, [&] { device.run(block, raw); });
    add_time(writing, [&] {
      for (std::size_t i = 0; i < block.size(); ++i) append_row(text, block, raw, i, fraction);
      file.write({text.data(), text.size()});
      text.clear();
    });
  }
  const double ns = 1e9 / rows;
  fmt::print("{:<10} {:>12.0f} {:>12.0f} {:>12.0f} {:>13.0f} %\n", name, reading * ns, running * ns,
             writing * ns, 100 * (reading + writing) / (reading + running + writing));
}

}  // namespace

int sc_main(int, char**) {
  return 0;
}

int main() {
  const auto folder = std::filesystem::temp_directory_path() / fmt::format("blysk-bench-csv-{}", getpid());
  std::filesystem::create_directory(folder);
  const device_options options;
  const int fraction = fraction_bits(options);
  fmt::print("{}, ns a row\n{:<10} {:>12} {:>12} {:>12} {:>15}\n", options.format, "engine", "reading CSV",
             "engine", "writing CSV", "CSV of all");
  show_split("bit", *bit::make_quadratic(options), fraction, folder, 1'000'000);
  show_split("verilator", *cosim::make_verilator(options), fraction, folder, 1'000'000);
  show_split("systemc", *bench::make_systemc(options), fraction, folder, 100'000);
  std::filesystem::remove_all(folder);
  return 0;
}
