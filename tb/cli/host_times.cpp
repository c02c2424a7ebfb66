// SPDX-License-Identifier: Apache-2.0
// host_times FILE [--device D]... [--format F]...: how long one core takes for a million results of each device, format and
// engine, beside as many powers by std::pow. Not a test, as times depend on the machine; the target update_host_times writes
// docs/tables/host_times.json. With devices or formats the other rows of FILE stay; it has to be of the same processor.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <systemc>

#include "tb/cli/engines.h"
#include "tb/inputs.h"
#include "tb/output_file.h"
#include "tb/program.h"
#include "tb/progress.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;

constexpr std::size_t kRuns = 5;
constexpr double kShortest = 0.04;  // seconds of a run, many ticks of the clock

/// Processor time of `work`, which other load on the machine disturbs less than the clock on the wall.
template <class Work>
double seconds(Work&& work) {
  const std::clock_t started = std::clock();
  work();
  return static_cast<double>(std::clock() - started) / CLOCKS_PER_SEC;
}

/// Seconds for a million results of `batch`, which gives `size` of them; one run.
template <class Batch>
double per_million(std::size_t size, Batch&& batch) {
  for (std::size_t repeats = 1;; repeats *= 4) {
    const double taken = seconds([&] {
      for (std::size_t i = 0; i < repeats; ++i) batch();
    });
    if (taken >= kShortest) return 1e6 * taken / static_cast<double>(size * repeats);
  }
}

/// cos^n of n 1..1000 and cos in [0, 1], as a host would compute it.
class powers {
 public:
  powers() {
    std::mt19937 random(1);
    for (std::size_t i = 0; i < n_.size(); ++i) {
      n_[i] = 1 + static_cast<double>(random() % 1000);
      c_[i] = static_cast<double>(random() % 65537) / 65536;
    }
  }
  double per_million() {
    return ::per_million(n_.size(), [&] {
      for (std::size_t i = 0; i < n_.size(); ++i) out_[i] = std::pow(c_[i], n_[i]);
      // The compiler must not leave out what nobody reads.
      asm volatile("" : : "r"(out_.data()) : "memory");
    });
  }

 private:
  std::array<double, 4096> n_{}, c_{}, out_{};
};

/// Median seconds for a million results, and the median of the ratios to powers run just before.
std::array<double, 2> measure(const selection& asked, const cli::engine_choice& choice) {
  const auto engine = choice.make(asked, cosim::waves::off);
  columns writes;
  for_random_inputs(asked, 4096, 1, [&](const columns& batch) { writes = batch; });
  columns results;
  engine->run(writes, results);
  powers reference;
  std::array<double, kRuns> times{}, ratios{};
  for (std::size_t i = 0; i < kRuns; ++i) {
    const double power = reference.per_million();
    times[i] = per_million(writes.size(), [&] { engine->run(writes, results); });
    ratios[i] = times[i] / power;
  }
  std::ranges::sort(times);
  std::ranges::sort(ratios);
  return {times[kRuns / 2], ratios[kRuns / 2]};
}

/// The same in a process of its own: SystemC elaborates once in a process.
std::array<double, 2> measure_in_child(const selection& asked, const cli::engine_choice& choice) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe can be made");
  const pid_t child = fork();
  if (child == 0) {
    bool written = false;
    try {
      const auto measured = measure(asked, choice);
      written = write(ends[1], measured.data(), sizeof measured) == sizeof measured;
    } catch (const std::exception& error) {
      fmt::print(stderr, "{}\n", error.what());
    }
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  std::array<double, 2> measured{};
  const bool answered = read(ends[0], measured.data(), sizeof measured) == sizeof measured;
  close(ends[0]);
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child || status != 0 || !answered)
    throw std::runtime_error(fmt::format("engine {} of {} gave no time", choice.name, asked.text()));
  return measured;
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

double four_digits(double value) {
  return std::stod(fmt::format("{:.4g}", value));
}

using json = nlohmann::ordered_json;

struct options {
  std::string path;
  std::vector<std::string> devices, formats;  ///< none: all

  bool is_part() const { return !devices.empty() || !formats.empty(); }
  bool takes(const device& of, std::string_view format) const {
    const auto is_in = [](const std::vector<std::string>& names, std::string_view name) {
      return names.empty() || std::ranges::find(names, name) != names.end();
    };
    return is_in(devices, of.name()) && is_in(formats, format);
  }
};

/// The rows that are there, which a part of them is added to.
json stored_rows(const std::string& path) {
  std::ifstream file(path);
  if (!file) return json::array();
  try {
    json all = json::parse(file);
    if (all.at("processor") != processor())
      throw file_error(path, 0,
                       fmt::format("was measured on another processor than {}, expected all rows anew: no "
                                   "--device and no --format",
                                   processor()));
    return all.at("rows");
  } catch (const json::exception&) {
    throw file_error(path, 0, "is damaged, expected what host_times wrote");
  }
}

/// A row's place in the table.
json key_of(const device& of, std::string_view format, const cli::engine_choice& choice) {
  return {{"device", of.name()}, {"format", format}, {"engine", choice.name}};
}

json measured_row(const device& of, std::string_view format, const cli::engine_choice& choice) {
  const auto [taken, ratio] =
      measure_in_child(choose(of.name(), std::string(format), {}, choice.serves), choice);
  json row = key_of(of, format, choice);
  row["seconds"] = four_digits(taken);
  row["ratio"] = four_digits(ratio);
  return row;
}

int run(const options& asked) {
  for (const std::string& name : asked.devices) choose(name, std::string(format_names[0]));
  for (const std::string& name : asked.formats) choose(devices().front()->name(), name);
  const json stored = asked.is_part() ? stored_rows(asked.path) : json::array();
  output_file file(asked.path);
  json rows = json::array();
  progress shown("measuring times",
                 devices().size() * std::size(format_names) * cli::engine_choices().size());
  for (const device* each : devices()) {
    for (const std::string_view format : format_names) {
      for (const cli::engine_choice& choice : cli::engine_choices()) {
        shown.advance(1);
        if (asked.takes(*each, format)) {
          rows.push_back(measured_row(*each, format, choice));
          continue;
        }
        const auto kept = std::find_if(
            stored.begin(), stored.end(), [key = key_of(*each, format, choice)](const json& row) {
              return row.contains("device") && row["device"] == key["device"] &&
                     row["format"] == key["format"] && row["engine"] == key["engine"];
            });
        if (kept != stored.end()) rows.push_back(*kept);
      }
    }
  }
  const json all{{"processor", processor()},
                 {"seconds", "processor time of one core for 10^6 results, median of 5 runs"},
                 {"ratio", "to as many cos^n by std::pow in double, measured beside each run"},
                 {"rows", rows}};
  file.write(all.dump(1) + "\n");
  file.close();
  file.commit();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  options asked;
  return run_program(
      argc, argv, "Measures the host's time for a million results of each engine",
      [&](CLI::App& program) {
        program.add_option("FILE", asked.path, "to write, JSON")->required();
        program.add_option("--device", asked.devices, "measure this one alone, and keep the other rows");
        program.add_option("--format", asked.formats, "measure this one alone, and keep the other rows");
      },
      [&] { return run(asked); });
}
