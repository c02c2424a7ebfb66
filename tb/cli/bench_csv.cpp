// SPDX-License-Identifier: Apache-2.0
// Where the time of `simulate` goes: reading CSV, the engine, writing CSV, one after the other and then side by side.
#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <random>

#include "tb/cli/engines.h"
#include "tb/cli/stream.h"
#include "tb/output_file.h"
#include "tb/run_program.h"

namespace {

using namespace blysk;
using namespace blysk::cli;
using clock_type = std::chrono::steady_clock;

template <class Work>
double seconds(Work&& work) {
  const auto start = clock_type::now();
  work();
  return std::chrono::duration<double>(clock_type::now() - start).count();
}

/// Random writes, seed 1: cosines of six decimals, every register rewritten.
void write_stimulus(const std::string& path, int rows) {
  std::mt19937 random(1);
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "n,cos,r,g,b\n");
  for (int i = 0; i < rows; ++i) {
    fmt::format_to(std::back_inserter(text), "{},{:.6f},{},{},{}\n", 1 + random() % 1000,
                   static_cast<double>(random()) * 0x1p-32, random() % 256, random() % 256, random() % 256);
  }
  output_file file(path);
  file.write({text.data(), text.size()});
  file.commit();
}

/// Seconds for all rows.
struct split {
  double reading = 0, running = 0, writing = 0;  // one after the other
  double streaming = 0;                          // side by side
};

split measure(engine& device, const std::vector<port>& ports, const std::filesystem::path& folder) {
  const auto compute = [&](row_block& block) { device.run(block.writes, block.computed); };
  split spent;
  {
    csv_reader rows(folder / "stimulus.csv", stimulus_header(ports));
    stimulus_reader stimulus(rows, ports);
    output_file file(folder / "results.csv");
    row_block block;
    fmt::memory_buffer text;
    for (;;) {
      spent.reading += seconds([&] { stimulus.read(block.writes); });
      if (block.writes.size() == 0) break;
      spent.running += seconds([&] { compute(block); });
      spent.writing += seconds([&] {
        append_rows(text, ports, block);
        file.write({text.data(), text.size()});
        text.clear();
      });
    }
  }
  csv_reader rows(folder / "stimulus.csv", stimulus_header(ports));
  stimulus_reader stimulus(rows, ports);
  output_file file(folder / "results.csv");
  spent.streaming = seconds([&] { stream(stimulus, compute, file); });
  return spent;
}

/// The least of several runs: other work on the machine only adds.
void show_split(const std::string& name, const selection& asked, const std::filesystem::path& folder,
                int rows) {
  const auto device = find_engine(name).make(asked, cosim::waves::off);
  const std::vector<port> ports = asked.of().ports(asked);
  write_stimulus(folder / "stimulus.csv", rows);
  split least = measure(*device, ports, folder);
  for (int run = 1; run < 7; ++run) {
    const split spent = measure(*device, ports, folder);
    for (double split::*part : {&split::reading, &split::running, &split::writing, &split::streaming})
      least.*part = std::min(least.*part, spent.*part);
  }
  const double ns = 1e9 / rows;
  fmt::print("{:<10} {:>12.0f} {:>12.0f} {:>12.0f} {:>12.0f} {:>12.0f} %\n", name, least.reading * ns,
             least.running * ns, least.writing * ns, least.streaming * ns,
             100 * least.running / least.streaming);
}

int run() {
  std::string pattern = (std::filesystem::temp_directory_path() / "blysk-bench-csv-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw file_error(pattern, 0, "cannot be made");
  const std::filesystem::path folder = pattern;
  const selection asked = choose(devices().front()->name(), "q16");
  fmt::print("{} {}, ns a row\n{:<10} {:>12} {:>12} {:>12} {:>12} {:>14}\n", asked.of().name(),
             asked.format(), "engine", "reading CSV", "engine", "writing CSV", "streamed", "engine's part");
  show_split("bit", asked, folder, 1'000'000);
  show_split("verilator", asked, folder, 1'000'000);
  show_split("systemc", asked, folder, 100'000);
  std::filesystem::remove_all(folder);
  return 0;
}

}  // namespace

int sc_main(int, char**) {
  return 0;
}

int main() {
  return blysk::run_program("bench_csv", run);
}
