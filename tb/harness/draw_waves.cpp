// SPDX-License-Identifier: Apache-2.0
// draw_waves FILE.vcd --json FILE.json --svg FILE.svg [--first TICK] [--count TICKS] [--check]: a timing diagram of waves that
// `blysk simulate --engine systemc --vcd` recorded, as WaveJSON and as a picture; --check compares, exit 1 if one is another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <iterator>
#include <sstream>

#include "tb/device_arguments.h"
#include "tb/harness/arguments.h"
#include "tb/harness/systemc_engine.h"
#include "tb/harness/timing_diagram.h"
#include "tb/output_file.h"
#include "tb/run_program.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;

/// The device that a comment of the waves names.
selection device_of(const harness::wave_changes& waves, const std::string& file) {
  for (const std::string& line : waves.comment()) {
    if (!line.starts_with(harness::kWaveComment)) continue;
    CLI::App program;
    asked_device asked;
    add_device_arguments(program, asked, purpose::hardware);
    program.parse(line.substr(std::string_view(harness::kWaveComment).size()));
    return asked.choose();
  }
  throw file_error(file, 0, "names no device, expected waves of blysk simulate");
}

bool is_same(const std::string& file, const std::string& text) {
  std::ifstream old(file, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(old), {}) == text;
}

int run(int argc, char** argv) {
  CLI::App program{"A timing diagram of recorded waves", "draw_waves"};
  std::string vcd, json, svg;
  std::size_t first = 0;
  std::size_t count = 22;
  bool checks = false;
  program.add_option("waveform", vcd, "a VCD file of blysk simulate --engine systemc")->required();
  program.add_option("--json", json, "WaveJSON to write")->required();
  program.add_option("--svg", svg, "picture to write")->required();
  program.add_option("--first", first, "half period of the clock to begin with")->capture_default_str();
  program.add_option("--count", count, "half periods to show")->capture_default_str();
  program.add_flag("--check", checks, "compare instead of writing");
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return program.exit(success);
  } catch (const CLI::Error& error) {
    throw usage_error(fmt::format("{}, see draw_waves --help", error.what()));
  }
  const harness::wave_changes waves(vcd);
  const selection device = device_of(waves, vcd);
  constexpr auto kHalfPeriodPs = static_cast<std::uint64_t>(harness::kClockPeriodNs * 1e3 / 2);
  harness::timing_diagram shown =
      harness::diagram_of(device.of().ports(device), waves, kHalfPeriodPs, first, count);
  shown.title = device.text();
  shown.foot =
      fmt::format("recorded from SystemC, {} to {} ns; a line each {} ns", first * kHalfPeriodPs / 1000,
                  (first + count) * kHalfPeriodPs / 1000, kHalfPeriodPs / 1000);
  const std::pair<std::string, std::string> made[] = {{json, harness::wave_json(shown)},
                                                      {svg, harness::svg_text(shown)}};
  for (const auto& [file, text] : made) {
    if (checks && !is_same(file, text)) {
      fmt::print("{} is stale: the target update_drawings writes it\n", file);
      return 1;
    }
  }
  if (checks) return 0;
  for (const auto& [path, text] : made) {
    output_file file(path);
    file.write(text);
    file.commit();
  }
  return 0;
}

}  // namespace

int sc_main(int, char**) {
  return 0;
}  // SystemC's library asks for one

int main(int argc, char** argv) {
  return blysk::run_program("draw_waves", [&] { return run(argc, argv); });
}
