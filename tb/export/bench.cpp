// SPDX-License-Identifier: Apache-2.0
#include "tb/export/bench.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace blysk::verilog {

namespace {

using ports_list = std::vector<port>;
using texts = std::vector<std::string>;

texts texts_of(const ports_list& ports, const std::function<std::string(const port&)>& text) {
  texts made;
  std::ranges::transform(ports, std::back_inserter(made), text);
  return made;
}

std::string range_of(const port& of) {
  return of.carries ? fmt::format("[{}:0] ", of.width() - 1) : "";
}

const port& first_of(const ports_list& ports, port::role role) {
  return ports[find_role(ports, role)];
}

/// Data that a strobe of the edge writes.
ports_list written_by(const ports_list& ports, write_edge edge) {
  ports_list found;
  for (const port& strobe : of_role(ports, port::role::strobe)) {
    for (const port& data : of_role(ports, port::role::data)) {
      if (strobe.edge == edge && strobe.writes == data.name) found.push_back(data);
    }
  }
  return found;
}

std::string assignments(const ports_list& to, const char* what) {
  std::string text;
  for (const port& each : to) text += fmt::format("      {0} = {1}{0};\n", each.name, what);
  return text;
}

std::string strobes_to(const ports_list& ports, write_edge edge, int level) {
  std::string text;
  for (const port& each : of_role(ports, port::role::strobe)) {
    if (each.edge == edge) text += fmt::format("      {} = {};\n", each.name, level);
  }
  return text;
}

/// A row of a device with strobes: data is there while its register should take it, and its complement before and after.
std::string put_by_strobes(const ports_list& ports) {
  const ports_list level = written_by(ports, write_edge::level);
  const ports_list trailing = written_by(ports, write_edge::trailing);
  const std::string fall = fmt::format("      @(negedge {});\n", first_of(ports, port::role::clock).name);
  std::string text = assignments(level, "given_") + assignments(trailing, "~given_") +
                     strobes_to(ports, write_edge::level, 1) + strobes_to(ports, write_edge::trailing, 1) +
                     fall + strobes_to(ports, write_edge::level, 0) +
                     strobes_to(ports, write_edge::trailing, 0) + assignments(level, "~given_") +
                     assignments(trailing, "given_") + fall + assignments(trailing, "~given_");
  for (int cycle = 0; cycle < first_of(ports, port::role::valid).settling_cycles; ++cycle) text += fall;
  return text + "      answer;\n";
}

/// A row of a device with start, ready and valid. The next one comes when all results of this one are there.
std::string put_by_handshake(const ports_list& ports) {
  const ports_list data = of_role(ports, port::role::data);
  const std::string& clk = first_of(ports, port::role::clock).name;
  const std::string& start = first_of(ports, port::role::start).name;
  const std::string wait =
      fmt::format("      while (!{}) @(negedge {});\n", first_of(ports, port::role::ready).name, clk);
  return wait + assignments(data, "given_") +
         fmt::format("      {0} = 1;\n      @(negedge {1});\n      {0} = 0;\n", start, clk) +
         assignments(data, "~given_") + wait +
         fmt::format("      repeat ({}) @(negedge {});\n",
                     first_of(ports, port::role::valid).settling_cycles + 1, clk);
}

}  // namespace

std::string bench_text(const netlist::elaborated& device, const std::string& name) {
  ports_list ports;
  for (const auto& each : device.ports()) {
    if (!each->what.is_inner) ports.push_back(each->what);
  }
  const protocol talks = protocol_of(ports);
  if (talks == protocol::none) return {};
  const ports_list data = of_role(ports, port::role::data);
  const ports_list results = of_role(ports, port::role::result);
  const std::string clk = first_of(ports, port::role::clock).name;
  const std::string reset = first_of(ports, port::role::reset).name;

  std::string declarations, idle;
  for (const port& each : ports) {
    declarations += fmt::format("  {} {}{};\n", each.is_input() ? "reg" : "wire", range_of(each), each.name);
    if (each.is_input() && each.name != clk && each.name != reset)
      idle += fmt::format("      {} = 0;\n", each.name);
  }
  for (const port& each : data) declarations += fmt::format("  reg {}given_{};\n", range_of(each), each.name);
  const texts connections =
      texts_of(ports, [](const port& each) { return fmt::format(".{0}({0})", each.name); });
  texts answered = texts_of(data, [](const port& each) { return "given_" + each.name; });
  std::ranges::transform(results, std::back_inserter(answered), &port::name);
  const auto words = [](std::size_t count) { return fmt::format("{}", fmt::join(texts(count, "%h"), " ")); };
  const texts read = texts_of(data, [](const port& each) { return "read_" + each.name; });
  std::string beyond, taken;
  for (const port& each : data) {
    if (each.width() < 64) beyond += fmt::format(" || read_{} >> {} != 0", each.name, each.width());
    taken += fmt::format("          given_{0} = read_{0};\n", each.name);
  }
  const bool has_strobes = talks == protocol::strobes;
  return fmt::format(
      R"(// SPDX-License-Identifier: Apache-2.0
// Bench of {0}: puts vectors into it and writes them back with the outputs appended.
//   blysk vectors ... --output vectors.txt
//   iverilog -g2001 -o bench -s {0}_bench {0}_bench.vt -c {0}.f && vvp -n bench +vectors=vectors.txt +answers=answers.txt
//   blysk check ... --answers answers.txt
`timescale 1ns / 1ps
module {0}_bench;
{1}
  {0} device ({2});

  always #5 {3} = !{3};

  reg [8*1024-1:0] vectors_path, answers_path;
  reg [8*256-1:0] line, text;  // more characters than a line has, and all that Verilator takes
  reg [8*64-1:0] behind;
  reg [63:0] {9};
  reg [7:0] character;
  reg is_wrong, is_open, is_comment, is_blank;
  integer vectors, answers, number, size, taken, digits, at;

  task answer;
    $fdisplay(answers, "{4}", {5});
  endtask
{6}
  task put;  // begins and ends at a falling edge
    begin
{7}    end
  endtask

  // What $fgets took: a line, or a part of one that is longer. A comment goes to the answers as it is. Words are judged by
  // their characters, since a simulator of two states reads x as a number.
  task take;
    begin
      if (!is_open) begin
        number = number + 1;
        is_comment = line[8*size-1-:8] == "#";
      end else if (!is_comment) is_wrong = 1;
      is_open = line[7:0] != "\n";
      if (is_comment) $fwrite(answers, "%0s", line);
      else begin
        digits = 0;
        is_blank = 1;
        for (at = size; at > 0 && !is_wrong; at = at - 1) begin
          character = line[8*at-1-:8];
          if (character > " ") begin
            is_blank = 0;
            digits = digits + 1;
            is_wrong = digits > 16 || !(character >= "0" && character <= "9" || character >= "a" && character <= "f" ||
                                        character >= "A" && character <= "F");
          end else digits = 0;
        end
        text = line << 8 * (256 - size);  // its first character where Verilator begins
        taken = $sscanf(text, "{10} %s", {9}, behind);
        if (!is_blank && (taken != {11}{12})) is_wrong = 1;
        if (!is_blank && !is_wrong) begin
{13}          put;
        end
      end
    end
  endtask

  initial begin
    if (!$value$plusargs("answers=%s", answers_path)) answers_path = "answers.txt";
    if (!$value$plusargs("vectors=%s", vectors_path)) vectors_path = "vectors.txt";
    if (answers_path == vectors_path) begin
      $display("%0s is the file of vectors and of answers, expected two; +vectors=FILE and +answers=FILE name them",
               answers_path);
      $finish(1);
    end else begin
      // First of all the answers of an earlier run go: nobody takes them for those of this one.
      answers = $fopen(answers_path, "w");
      if (answers == 0) begin
        $display("%0s cannot be written, expected a file for the answers; +answers=FILE names it", answers_path);
        $finish(1);
      end
      vectors = $fopen(vectors_path, "r");
      if (vectors == 0) begin
        $display("%0s cannot be read, expected what blysk vectors writes; +vectors=FILE names it", vectors_path);
        $finish(1);
      end
      {3} = 0;
      {8} = 0;
{14}      @(negedge {3});
      @(negedge {3}) {8} = 1;
      is_wrong = 0;
      is_open = 0;
      number = 0;
      size = $fgets(line, vectors);
      while (size > 0 && !is_wrong) begin
        take;
        size = $fgets(line, vectors);
      end
      if (is_wrong) begin
        $display("%0s:%0d: expected {11} hexadecimal numbers, as blysk vectors writes them", vectors_path, number);
        $fdisplay(answers, "line %0d of the vectors cannot be read", number);
      end
      $fclose(answers);
      $finish(0);
    end
  end
endmodule
)",
      name, declarations, fmt::join(connections, ", "), clk, words(answered.size()),
      fmt::join(answered, ", "),
      has_strobes ? ""
                  : fmt::format("\n  always @(posedge {}) if ({}) answer;\n", clk,
                                first_of(ports, port::role::valid).name),
      has_strobes ? put_by_strobes(ports) : put_by_handshake(ports), reset, fmt::join(read, ", "),
      words(data.size()), data.size(), beyond, taken, idle);
}

}  // namespace blysk::verilog
