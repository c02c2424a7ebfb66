// SPDX-License-Identifier: Apache-2.0
// Delays of blocks: measured from a small netlist by hand, written, read again, and refused where they do not belong.
#include "tb/cost/delays.h"

#include <algorithm>
#include "tb/catch_text.h"
#include "tb/cost/cost_row.h"
#include "tb/scratch.h"

namespace {

using namespace blysk;

// A register of two bits, and a block y = {a[0] ^ a[1], !(a[0] a[1])}, whose second cell inverts the first.
constexpr const char* kLibrary =
    "cell (FF) {\n  pin(Q) {\n  related_pin : \"CLK\";\n  timing_sense : non_unate;\n"
    "cell (NAND) {\n  pin(Y) {\n  related_pin : \"A\";\n  timing_sense : negative_unate;\n"
    "  related_pin : \"B\";\n  timing_sense : negative_unate;\n"
    "cell (XOR) {\n  pin(Y) {\n  related_pin : \"A\";\n  timing_sense : non_unate;\n"
    "  related_pin : \"B\";\n  timing_sense : non_unate;\n";
constexpr const char* kNetlist = R"({"modules": {
  "top": {"ports": {"clk": {"direction": "input", "bits": [2]}},
          "cells": {"rg": {"type": "reg", "connections": {"clk": [2], "q_o[0]": [3], "q_o[1]": [4]}},
                    "gate": {"type": "gate", "connections": {"a_i[0]": [3], "a_i[1]": [4], "y_o[0]": [5], "y_o[1]": [6]}}}},
  "reg": {"ports": {"clk": {"direction": "input", "bits": [2]}, "q_o[0]": {"direction": "output", "bits": [3]},
                    "q_o[1]": {"direction": "output", "bits": [4]}},
          "cells": {"f0": {"type": "FF", "connections": {"CLK": [2], "Q": [3], "D": ["0"]}},
                    "f1": {"type": "FF", "connections": {"CLK": [2], "Q": [4], "D": ["1"]}}}},
  "gate": {"ports": {"a_i[0]": {"direction": "input", "bits": [2]}, "a_i[1]": {"direction": "input", "bits": [3]},
                     "y_o[0]": {"direction": "output", "bits": [4]}, "y_o[1]": {"direction": "output", "bits": [5]}},
           "cells": {"g0": {"type": "NAND", "connections": {"A": [2], "B": [3], "Y": [6]}},
                     "g1": {"type": "NAND", "connections": {"A": [6], "B": ["1"], "Y": [4]}},
                     "g2": {"type": "XOR", "connections": {"A": [2], "B": [3], "Y": [5]}}}}}})";

std::string cell(const std::string& type, const std::string& instance, const std::string& arcs) {
  return " (CELL\n  (CELLTYPE \"" + type + "\")\n  (INSTANCE " + instance + ")\n  (DELAY\n   (ABSOLUTE\n" +
         arcs + "   )\n  )\n )\n";
}

std::string sdf() {
  return "(DELAYFILE\n (TIMESCALE 1ns)\n" +
         cell("FF", "rg.f0", "    (IOPATH CLK Q (0.100::0.120) (0.200::0.210))\n") +
         cell("FF", "rg.f1", "    (IOPATH CLK Q (0.110::0.110) (0.190::0.190))\n") +
         cell("NAND", "gate.g0",
              "    (IOPATH A Y (0.010::0.010) (0.100::0.100))\n    (IOPATH B Y (0.020::0.020) "
              "(0.200::0.200))\n") +
         cell("NAND", "gate.g1",
              "    (IOPATH A Y (0.030::0.030) (0.400::0.400))\n    (IOPATH B Y (0.000::0.000))\n") +
         cell("XOR", "gate.g2",
              "    (IOPATH A Y (0.050::0.060) (0.070::0.070))\n    (IOPATH B Y (0.040::0.040) "
              "(0.045::0.045))\n") +
         ")\n";
}

constexpr const char* kPath =
    "   0.0000    0.0000 ^ rg/f0/CLK (FF)\n   0.2100    0.2100 v rg/f0/Q (FF)\n"
    "   0.2304    0.4404 ^ gate/g1/Y (NAND)\n   0.0000    0.4404 ^ y (out)\n   0.4404   data arrival time\n";

device_delays measured(const scratch& folder, const std::string& delays = sdf(),
                       const std::string& path = kPath) {
  device_delays of;
  cost::measure({.netlist = folder.write("n.json", kNetlist),
                 .sdf = folder.write("d.sdf", delays),
                 .library = folder.write("c.lib", kLibrary),
                 .path = folder.write("p.txt", path)},
                "top", "clk", of);
  return of;
}

}  // namespace

TEST_CASE("delays of blocks are the longest paths, edge by edge", "[delays]") {
  const scratch folder;
  const device_delays of = measured(folder);
  REQUIRE(of.blocks.size() == 2);
  CHECK(of.blocks[0].block == "rg");
  CHECK(of.blocks[0].ps == std::vector<std::vector<std::vector<int>>>{{{210}, {190}}});
  REQUIRE(of.blocks[1].inputs.size() == 1);
  CHECK(of.blocks[1].inputs[0].width == 2);
  // y[0]: a rise of a falls g0 after 100 (200) and rises g1 after 30; a fall rises g0 after 10 (20) and falls g1 after 400.
  // The worst arcs together, 100 + 400, are no path.
  CHECK(of.blocks[1].ps == std::vector<std::vector<std::vector<int>>>{{{410, 420}, {70, 45}}});
  CHECK(of.bound_ps == 210 + 410);  // by the first bit; 190 + 420 by the other
  CHECK(of.blocks_bound_ps == 210 + 420);
  REQUIRE(of.path.size() == 2);
  CHECK(of.path[0].ps == 210);
  CHECK(of.path[1].ps == 230);
  CHECK(of.path_ps() == 440);
}

TEST_CASE("what a tool left damaged is no measurement", "[delays]") {
  const scratch folder;
  CHECK_THROWS_WITH(measured(folder, sdf(), "Error: line 7, syntax error\n" + std::string(kPath)),
                    ContainsSubstring("reports an error of OpenSTA"));
  CHECK_THROWS_WITH(measured(folder, sdf(), "nothing\n"), ContainsSubstring("has no path"));
  CHECK_THROWS_WITH(measured(folder, "(DELAYFILE\n)\n"), ContainsSubstring("has no IOPATH"));
  CHECK_THROWS_WITH(measured(folder, " (TIMESCALE 1ps)\n" + sdf()), ContainsSubstring("TIMESCALE of 1ns"));
  std::string less = sdf();
  less.erase(less.find(" (CELL\n  (CELLTYPE \"XOR\")"));
  CHECK_THROWS_WITH(measured(folder, less), ContainsSubstring("cell gate.g2 has no delays"));
}

TEST_CASE("delays are read as they were written, and belong to one Verilog", "[delays]") {
  const scratch folder;
  const selection asked = choose(devices().front()->name(), "q8");
  device_delays of = measured(folder);
  of.device = asked.of().name();
  of.format = "q8";
  of.digest = "sha256:1";
  of.tools = {{"yosys", "1"}};
  of.script = "synth";
  const std::string text = cost::stored_text(cost::json_of(of));
  const std::string path = folder.write("delays.json", text);
  const device_delays again = cost::read_delays(path, asked, "sha256:1");
  CHECK(cost::stored_text(cost::json_of(again)) == text);
  CHECK(again.blocks[1].ps == of.blocks[1].ps);
  CHECK_THROWS_WITH(
      cost::read_delays(path, asked, "sha256:2"),
      ContainsSubstring("delays.json: belongs to another Verilog (sha256:1), expected the digest sha256:2"));
  CHECK_THROWS_WITH(cost::read_delays(path, choose(asked.of().name(), "q10"), "sha256:1"),
                    ContainsSubstring("has the delays of device") &&
                        ContainsSubstring("format q8, expected those of device"));
  const auto spoilt = [&](const std::string& from, const std::string& to) {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    REQUIRE(at != std::string::npos);
    return folder.write("spoilt.json", changed.replace(at, from.size(), to));
  };
  const auto read = [&](const std::string& file) { cost::read_delays(file, asked, "sha256:1"); };
  CHECK_THROWS_WITH(read(spoilt("410 420", "410")), ContainsSubstring("gate.y_o[0] has 1 delays, not 2"));
  CHECK_THROWS_WITH(read(spoilt("410 420", "410 -7")), ContainsSubstring("-7 is no number"));
  CHECK_THROWS_WITH(read(spoilt("a_i:2", "a_i:99")), ContainsSubstring("99 is no number from 1 to 64"));
  CHECK_THROWS_WITH(read(spoilt("\"bound_ps\": 620", "\"bound_ps\": 0")),
                    ContainsSubstring("bound_ps is no time from 1 to"));
  CHECK_THROWS_WITH(read(spoilt("\"script\"", "\"scrapt\"")), ContainsSubstring("a key is missing"));
  CHECK_THROWS_WITH(read(folder.write("half.json", text.substr(0, text.size() / 2))),
                    ContainsSubstring("is damaged"));
}

TEST_CASE("devices with start and ready are told to have no delays", "[delays]") {
  int refused = 0;
  for (const device* each : devices()) {
    const selection asked = choose(each->name(), "q8");
    const std::vector<port> ports = each->ports(asked);
    if (std::ranges::find(ports, port::role::start, &port::is) == ports.end()) continue;
    CHECK_THROWS_WITH(cost::read_delays("", asked, "sha256:1"),
                      ContainsSubstring(each->name() + " takes its inputs by start and ready"));
    ++refused;
  }
  CHECK(refused > 0);
}
