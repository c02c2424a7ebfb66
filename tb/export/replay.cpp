// SPDX-License-Identifier: Apache-2.0
#include "tb/export/replay.h"

#include <fmt/format.h>

#include <fstream>
#include <random>

namespace blysk::verilog {
namespace {

bool is_clock(const pin& each) {
  return each.name == "clk";
}

std::string binary(std::int64_t value, int width) {
  std::string digits;
  for (int bit = width - 1; bit >= 0; --bit) digits += ((value >> bit) & 1) != 0 ? '1' : '0';
  return digits;
}

std::int64_t random_code(const pin& each, std::mt19937_64& random) {
  if (each.name == "rst_n") return random() % 64 != 0 ? 1 : 0;
  const wire_format whole{each.bits.width, 0, false, 0, (std::int64_t{1} << each.bits.width) - 1};
  const wire_format format = each.carries.value_or(whole);
  const auto which = random() % 8;
  if (which == 0) return format.min;
  if (which == 1) return format.max;
  const std::uint64_t codes = static_cast<std::uint64_t>(format.max - format.min) + 1;
  return format.min + static_cast<std::int64_t>(codes == 0 ? random() : random() % codes);
}

std::string vectors_text(const model& device, int cycles) {
  std::mt19937_64 random(1);
  std::string text;
  const pin* clk = nullptr;
  for (const pin& each : device.pins()) {
    if (is_clock(each)) clk = &each;
  }
  const auto settle = [](const pin* clock, int level) {
    if (clock != nullptr) clock->write(level);
    sc_core::sc_start(1, sc_core::SC_NS);
  };
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (const pin& each : device.pins()) {
      if (!each.is_input || is_clock(each)) continue;
      const std::int64_t code = cycle == 0 && each.name == "rst_n" ? 0 : random_code(each, random);
      each.write(code);
      text += binary(code, each.bits.width);
    }
    settle(clk, 0);
    text += ' ';
    for (const pin& each : device.pins()) {
      if (!each.is_input) text += binary(each.read(), each.bits.width);
    }
    text += '\n';
    settle(clk, 1);
  }
  return text;
}

std::string bench_text(const model& device, const std::string& module_name) {
  std::string connections, inputs, outputs;
  int in = 0, out = 0;
  for (const pin& each : device.pins()) {
    connections += fmt::format("{}.{}({})", connections.empty() ? "" : ", ", each.name, each.name);
    if (is_clock(each)) continue;
    std::string& names = each.is_input ? inputs : outputs;
    names += (names.empty() ? "" : ", ") + each.name;
    (each.is_input ? in : out) += each.bits.width;
  }
  std::string declarations;
  for (const pin& each : device.pins()) {
    if (!is_clock(each))
      declarations += fmt::format("  wire {}{};\n", range_text(each.bits.width), each.name);
  }
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

void write_replay(const model& device, const std::string& module_name, int cycles,
                  const std::filesystem::path& directory) {
  write_files({{"vectors.txt", vectors_text(device, cycles)}, {"replay.v", bench_text(device, module_name)}},
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
