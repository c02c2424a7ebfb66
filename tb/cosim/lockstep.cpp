// SPDX-License-Identifier: Apache-2.0
// lockstep DEVICE FORMAT legal|all|engines|ends [--OPTION [VALUE]]...: the SystemC device and its exported Verilog side by side.
//   legal    under the same strobes, compared after every clock edge, legal codes
//   all      the same with whatever the wires can carry
//   engines  as engines: the same results, cycles and writes
//   ends     as engines, at the ends of every port's legal codes and of its wires, one code either side, and at the device's
//            corners: illegal codes too
// A process elaborates one device. Exit 1 if they differ.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <systemc>
#include <utility>

#include "tb/cosim/strobes.h"
#include "tb/harness/systemc_engine.h"
#include "tb/inputs.h"
#include "tb/netlist/elaborated.h"
#include "tb/program.h"

namespace blysk::cosim {
namespace {

int compare_strobes(const selection& asked, codes which) {
  const auto systemc = asked.of().elaborate(asked, 0);
  const auto verilog = make_verilator(asked);
  strobe_sequence strobes(asked, which);
  const std::vector<port>& ports = strobes.ports();
  const std::size_t clock = find_role(ports, port::role::clock);
  std::vector<std::int64_t> levels(ports.size(), 0);
  std::uint64_t compared = 0;
  std::uint64_t differences = 0;
  std::uint64_t changes = 0;  // of results

  for (int cycle = 0; cycle < kStrobeCycles; ++cycle) {
    strobes.next(levels);
    for (const bool clk : {false, true}) {
      levels[clock] = clk ? 1 : 0;
      const std::vector<std::int64_t> before = levels;
      for (std::size_t i = 0; i < ports.size(); ++i) {
        if (ports[i].is_input()) systemc->ports()[i]->write(levels[i]);
      }
      sc_core::sc_start(1, sc_core::SC_NS);
      verilog->apply(levels);
      if (cycle == 0 && !clk) continue;  // no register has been reset
      for (std::size_t i = 0; i < ports.size(); ++i) {
        if (ports[i].is_input()) continue;
        const std::int64_t expected = systemc->ports()[i]->read();
        changes += ports[i].is == port::role::result && levels[i] != before[i] ? 1U : 0U;
        ++compared;
        if (levels[i] == expected || ++differences > 10) continue;
        fmt::print("cycle {}, clk {}: {} is {} in Verilog, {} in SystemC\n", cycle, clk ? 1 : 0,
                   ports[i].name, levels[i], expected);
      }
    }
  }
  fmt::print("{}: {} levels compared, {} differ, results changed {} times\n", asked.folder_name(), compared,
             differences, changes);
  // Most inputs lie beyond the lobe, and some writes do not.
  return differences == 0 && changes > kStrobeCycles / 100 ? 0 : 1;
}

/// The ends of a port's legal codes and of its wires, with one code either side.
std::vector<std::int64_t> ends_of(const port& each) {
  const wire_format& format = *each.carries;
  const auto wires =
      static_cast<std::int64_t>((std::uint64_t{1} << (each.width() - (format.is_signed ? 1 : 0))) - 1);
  const std::int64_t low = format.is_signed ? -wires - 1 : 0;
  std::vector<std::int64_t> codes;
  for (const std::int64_t end : {low, format.min, format.max, wires}) {
    for (std::int64_t code = end - 1; code <= end + 1; ++code) {
      if (low <= code && code <= wires) codes.push_back(code);
    }
  }
  for (std::int64_t code = format.min; code <= format.min + 2; ++code) codes.push_back(code);
  std::ranges::sort(codes);
  codes.erase(std::unique(codes.begin(), codes.end()), codes.end());
  return codes;
}

bool are_legal(const std::vector<port>& data, const std::vector<std::int64_t>& codes) {
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (codes[i] < data[i].carries->min || codes[i] > data[i].carries->max) return false;
  }
  return true;
}

/// Every combination of the ends of the enumerated ports, the last one's corners besides; the others at their largest codes.
columns ends(const selection& asked) {
  const std::vector<port> data = of_role(asked.of().ports(asked), port::role::data);
  const std::size_t enumerated = std::min(asked.of().enumerated(), data.size());
  std::vector<std::vector<std::int64_t>> rows{{}};
  for (std::size_t i = 0; i < enumerated; ++i) {
    std::vector<std::vector<std::int64_t>> longer;
    for (const std::vector<std::int64_t>& before : rows) {
      std::vector<std::int64_t> codes = ends_of(data[i]);
      if (i + 1 == enumerated && are_legal(data, before)) {
        for (const std::int64_t corner : asked.of().corners(asked, before)) {
          for (std::int64_t code = corner - 1; code <= corner + 1; ++code) codes.push_back(code);
        }
      }
      for (const std::int64_t code : codes) {
        longer.push_back(before);
        longer.back().push_back(code);
      }
    }
    rows = std::move(longer);
  }
  columns in(data, port::role::data);
  in.resize(rows.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t i = 0; i < data.size(); ++i)
      in[i].set(row, i < enumerated ? rows[row][i] : data[i].carries->max);
  }
  return in;
}

int compare_ends(const selection& asked) {
  const columns in = ends(asked);
  columns got, expected;
  harness::make_systemc(asked)->run(in, expected);
  make_verilator(asked)->run(in, got);
  fmt::print("{}: {} writes at the ends, results {}\n", asked.folder_name(), in.size(),
             got == expected ? "equal" : "DIFFER");
  return got == expected && in.size() > 0 ? 0 : 1;
}

int compare_engines(const selection& asked) {
  const auto systemc = harness::make_systemc(asked);
  const auto verilog = make_verilator(asked);
  columns got, expected;
  bool same = true;
  for (const unsigned rows : {3u, 1u, 1000u}) {
    for_random_inputs(asked, rows, rows, [&](const columns& in) {
      systemc->run(in, expected);
      verilog->run(in, got);
    });
    fmt::print("{}: {} writes, results {}, cycles {} and {}, writes counted {} and {}\n", asked.folder_name(),
               rows, got == expected ? "equal" : "DIFFER", verilog->cycles(), systemc->cycles(),
               verilog->writes(), systemc->writes());
    same = same && got == expected && got.size() >= rows && verilog->cycles() == systemc->cycles() &&
           verilog->writes() == systemc->writes();
  }
  return same ? 0 : 1;
}

}  // namespace
}  // namespace blysk::cosim

int main(int argc, char** argv) {
  using namespace blysk;
  device_arguments arguments;
  std::string what;
  return run_program(
      argc, argv, "Compares the SystemC device and its exported Verilog",
      [&](CLI::App& program) {
        arguments.add_to(program);
        program.add_option("WHAT", what, "legal or all codes under strobes, engines, or ends")
            ->required()
            ->check(CLI::IsMember({"legal", "all", "engines", "ends"}));
        arguments.add_options_to(program);
      },
      [&] {
        const selection asked = arguments.chosen();
        if (what == "engines") return cosim::compare_engines(asked);
        if (what == "ends") return cosim::compare_ends(asked);
        return cosim::compare_strobes(asked, what == "all" ? cosim::codes::all : cosim::codes::legal);
      });
}
