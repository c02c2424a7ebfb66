// SPDX-License-Identifier: Apache-2.0
// lockstep DEVICE FORMAT legal|all|engines: the SystemC device and its exported Verilog side by side.
//   legal    under the same strobes, compared after every clock edge, legal codes
//   all      the same with whatever the wires can carry
//   engines  as engines: the same results, cycles and writes
// A process elaborates one device. Exit 1 if they differ.
#include <fmt/format.h>

#include <stdexcept>
#include <systemc>

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
    same = same && got == expected && got.size() == rows && verilog->cycles() == systemc->cycles() &&
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
        program.add_option("WHAT", what, "legal or all codes under strobes, or engines")
            ->required()
            ->check(CLI::IsMember({"legal", "all", "engines"}));
      },
      [&] {
        const selection asked = arguments.chosen();
        if (what == "engines") return cosim::compare_engines(asked);
        return cosim::compare_strobes(asked, what == "all" ? cosim::codes::all : cosim::codes::legal);
      });
}
