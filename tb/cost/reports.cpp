// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/reports.h"

#include <fmt/format.h>

#include <cmath>
#include <regex>

#include "tb/usage_error.h"

namespace blysk::cost {
namespace {

/// The port's wires as a range of a bundle that has grown to `width` bits; the bundle grows by them.
std::string next_range(const port& of, int& width) {
  const int first = width;
  width += of.width();
  return of.width() == 1 ? fmt::format("[{}]", first) : fmt::format("[{}:{}]", width - 1, first);
}

/// The first group of the pattern in the text, a number.
double find_number(const std::string& path, const std::string& text, const std::string& pattern,
                   const char* expected) {
  std::smatch found;
  if (!std::regex_search(text, found, std::regex(pattern)))
    throw file_error(path, 0, fmt::format("cannot be read, expected {}", expected));
  return std::stod(found[1]);
}

}  // namespace

std::string serial_wrapper(const selection& asked, const std::string& name) {
  int in = 0;
  int out = 0;
  std::string pins;
  for (const port& each : asked.of().ports(asked)) {
    if (each.is_inner) continue;
    pins += pins.empty() ? "\n" : ",\n";
    if (each.is == port::role::clock) {
      pins += fmt::format("      .{}(clk)", each.name);
    } else if (each.is_input()) {
      pins += fmt::format("      .{}(in{})", each.name, next_range(each, in));
    } else {
      pins += fmt::format("      .{}(out{})", each.name, next_range(each, out));
    }
  }
  return fmt::format(
      "// {0} between shift registers.\n"
      "module {1} (\n"
      "    input wire clk,\n"
      "    input wire serial_i,\n"
      "    input wire load_i,\n"
      "    output wire serial_o\n"
      ");\n"
      "  reg [{2}:0] in;\n"
      "  wire [{3}:0] out;\n"
      "  reg [{3}:0] captured;\n"
      "  reg [{3}:0] shifted;\n"
      "  reg load;\n"
      "  assign serial_o = shifted[{3}];\n"
      "  always @(posedge clk) begin\n"
      "    in <= {{in[{4}:0], serial_i}};\n"
      "    load <= load_i;\n"
      "    captured <= out;\n"
      "    shifted <= load ? captured : {{shifted[{5}:0], 1'b0}};\n"
      "  end\n"
      "  {0} device ({6}\n"
      "  );\n"
      "endmodule\n",
      asked.top_name(), name, in - 1, out - 1, in - 2, out - 2, pins);
}

std::string split_wrapper(const selection& asked, const std::string& name) {
  std::string ports, pins;
  for (const port& each : asked.of().ports(asked)) {
    if (each.is_inner) continue;
    const int width = each.width();
    ports +=
        fmt::format("{}\n    {} wire {}{}", ports.empty() ? "" : ",", each.is_input() ? "input" : "output",
                    width == 1 ? "" : fmt::format("[{}:0] ", width - 1), each.name);
    for (int bit = 0; bit < width; ++bit) {
      pins += pins.empty() ? "\n" : ",\n";
      pins += width == 1 ? fmt::format("      .{0}({0})", each.name)
                         : fmt::format("      .\\{0}[{1}] ({0}[{1}])", each.name, bit);
    }
  }
  return fmt::format(
      "// {0} with its ports whole.\nmodule {1} ({2}\n);\n  {0} device ({3}\n  );\nendmodule\n",
      asked.top_name(), name, ports, pins);
}

ice40_cells read_ice40_cells(const std::string& path, const std::string& text) {
  constexpr std::int64_t kRamBits = 4096;
  const nlohmann::ordered_json report = parse_json(path, text);
  const auto design = report.find("design");
  if (design == report.end() || !design->contains("num_cells_by_type"))
    throw file_error(path, 0, "has no number of cells, expected what stat -json of Yosys prints");
  ice40_cells cells;
  for (const auto& [type, number] : design->at("num_cells_by_type").items()) {
    const std::int64_t count = number;
    if (type == "SB_LUT4") {
      cells.lut += count;
    } else if (type == "SB_CARRY") {
      cells.carry += count;
    } else if (type.starts_with("SB_DFF")) {
      cells.ff += count;
    } else if (type == "SB_MAC16") {
      cells.dsp += count;
    } else if (type.starts_with("SB_RAM40_4K")) {
      cells.ram_bits += kRamBits * count;
    } else {
      throw file_error(path, 0,
                       fmt::format("has cells {}, expected those of an iCE40 that are counted", type));
    }
  }
  return cells;
}

double read_fmax(const std::string& path, const std::string& text) {
  const nlohmann::ordered_json report = parse_json(path, text);
  const auto clocks = report.find("fmax");
  if (clocks == report.end() || clocks->size() != 1 || !clocks->begin()->contains("achieved"))
    throw file_error(path, 0, "has no single clock, expected the --report of nextpnr");
  return clocks->begin()->at("achieved");
}

standard_cells read_standard_cells(const std::string& path, const std::string& text,
                                   const std::string& liberty) {
  const double nand2 =
      find_number("the library", liberty, R"(cell\s*\(\s*"?NAND2X1"?\s*\)\s*\{\s*area\s*:\s*([0-9.]+))",
                  "the area of a NAND2X1");
  standard_cells cells;
  cells.cells = static_cast<std::int64_t>(
      find_number(path, text, "Number of cells: +([0-9]+)", "what stat -liberty of Yosys prints"));
  const double area = find_number(path, text, R"(Chip area for (?:top )?module [^:]*: +([0-9.]+))",
                                  "what stat -liberty of Yosys prints");
  cells.area_nand2 = std::round(10 * area / nand2) / 10;
  return cells;
}

double read_path_ns(const std::string& path, const std::string& text, double period_ns) {
  // OpenSTA goes on after an error, without what it could not read.
  if (text.find("Error") != std::string::npos)
    throw file_error(path, 0, "reports an error of OpenSTA, expected none");
  const double slack =
      find_number(path, text, R"((-?[0-9.]+) +slack \()", "what report_checks of OpenSTA prints");
  return std::round(1000 * (period_ns - slack)) / 1000;
}

}  // namespace blysk::cost
