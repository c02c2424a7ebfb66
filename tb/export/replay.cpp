// SPDX-License-Identifier: Apache-2.0
#include "tb/export/replay.h"

#include <fmt/format.h>

#include <fstream>
#include <random>
#include <utility>

#include "tb/export/lexis.h"

namespace blysk::verilog {
namespace {

using netlist::bound_port;
using ports = std::vector<std::unique_ptr<bound_port>>;

/// The ports that a bench connects, the clock apart.
std::vector<bound_port*> connected(const ports& all, bool is_input) {
  std::vector<bound_port*> found;
  for (const auto& each : all) {
    if (each->what.is != port::role::clock && !each->what.is_inner && each->what.is_input() == is_input)
      found.push_back(each.get());
  }
  return found;
}

std::string binary(std::int64_t value, int width) {
  std::string digits;
  for (int bit = width - 1; bit >= 0; --bit) digits += ((value >> bit) & 1) != 0 ? '1' : '0';
  return digits;
}

std::int64_t random_code(const bound_port& to, std::mt19937_64& random) {
  if (to.what.is == port::role::reset) return random() % 64 != 0 ? 1 : 0;
  const wire_format one_bit{1, 0, false, 0, 1};
  const wire_format format = to.what.carries.value_or(one_bit);
  const auto which = random() % 8;
  if (which == 0) return format.min;
  if (which == 1) return format.max;
  const std::uint64_t codes = static_cast<std::uint64_t>(format.max - format.min) + 1;
  return format.min + static_cast<std::int64_t>(codes == 0 ? random() : random() % codes);
}

std::string vectors_text(const netlist::elaborated& device, int cycles) {
  std::mt19937_64 random(1);
  std::string text;
  bound_port* clk = nullptr;
  for (const auto& each : device.ports()) {
    if (each->what.is == port::role::clock) clk = each.get();
  }
  const auto settle = [clk](int level) {
    if (clk != nullptr) clk->write(level);
    sc_core::sc_start(1, sc_core::SC_NS);
  };
  const auto inputs = connected(device.ports(), true);
  const auto outputs = connected(device.ports(), false);
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (bound_port* each : inputs) {
      const std::int64_t code =
          cycle == 0 && each->what.is == port::role::reset ? 0 : random_code(*each, random);
      each->write(code);
      text += binary(code, each->bits.width);
    }
    settle(0);
    text += ' ';
    for (const bound_port* each : outputs) text += binary(each->read(), each->bits.width);
    text += '\n';
    settle(1);
  }
  return text;
}

std::string replay_text(const netlist::elaborated& device, const std::string& module_name) {
  std::string connections, declarations;
  for (const auto& each : device.ports()) {
    if (!each->what.is_inner)
      connections +=
          fmt::format("{}.{}({})", connections.empty() ? "" : ", ", each->what.name, each->what.name);
  }
  const auto declare = [&](bool is_input) {
    std::string names;
    int bits = 0;
    for (const bound_port* each : connected(device.ports(), is_input)) {
      declarations += fmt::format("  wire {}{};\n", range_text(each->bits.width), each->what.name);
      names += (names.empty() ? "" : ", ") + each->what.name;
      bits += each->bits.width;
    }
    return std::pair(names, bits);
  };
  const auto [inputs, in] = declare(true);
  const auto [outputs, out] = declare(false);
  return fmt::format(
      "`timescale 1ns / 1ps\n"
      "module replay;\n"
      "  reg clk;\n"
      "{}"
      "  reg {}inputs;\n"
      "  reg {}expected;\n"
      "  integer file, cycles, failures;\n"
      "  assign {{{}}} = inputs;\n"
      "  {} device ({});\n"
      "  initial begin\n"
      "    file = $fopen(\"vectors.txt\", \"r\");\n"
      "    cycles = 0;\n"
      "    failures = 0;\n"
      "    while ($fscanf(file, \"%b %b\", inputs, expected) == 2) begin\n"
      "      clk = 0;\n"
      "      #1 if (cycles > 0 && {{{}}} !== expected) failures = failures + 1;\n"
      "      clk = 1;\n"
      "      #1 cycles = cycles + 1;\n"
      "    end\n"
      "    $display(\"%0d cycles replayed, %0d differ\", cycles, failures);\n"
      "    $finish(0);\n"
      "  end\n"
      "endmodule\n",
      declarations, range_text(in), range_text(out), inputs, module_name, connections, outputs);
}

}  // namespace

void write_replay(const netlist::elaborated& device, const std::string& module_name, int cycles,
                  const std::filesystem::path& directory) {
  write_files({{"vectors.txt", vectors_text(device, cycles)}, {"replay.v", replay_text(device, module_name)}},
              directory);
}

void write_files(const files& texts, const std::filesystem::path& directory) {
  for (const auto& [name, text] : texts) {
    std::ofstream file;
    file.exceptions(std::ios::failbit | std::ios::badbit);
    file.open(directory / name, std::ios::binary);
    file << text;
    file.close();
  }
}

}  // namespace blysk::verilog
