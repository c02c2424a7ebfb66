// SPDX-License-Identifier: Apache-2.0
// status_page FACTS TABLES PAGE [--check]: what is known of each device in each format, a line each, as a page: how its Verilog is
// held to its model, what is proved, mutants, error and cost. FACTS is what the tests are, as CMake declares them; the rest is
// read below TABLES. Exit 1 if --check finds another text.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "tb/cost/measured.h"
#include "tb/cost/table.h"
#include "tb/inputs.h"
#include "tb/program.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;

/// What is tested of a device in a format.
struct facts {
  bool tries_all = false;           ///< every input, and not samples of them
  std::vector<std::string> proved;  ///< properties
  bool has_mutants = false;         ///< some are tried in a test
};

using facts_of_all = std::map<std::pair<std::string, std::string>, facts>;  // by device and format

/// Lines "DEVICE FORMAT [all] [mutants] [proved PROPERTY]...".
facts_of_all read_facts(const std::string& path) {
  facts_of_all all;
  std::istringstream lines(cost::read_text(path));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string device, format;
    words >> device >> format;
    facts& known = all[{device, format}];
    for (std::string word; words >> word;) {
      if (word == "all") known.tries_all = true;
      if (word == "mutants") known.has_mutants = true;
      if (word == "proved" && words >> word) known.proved.push_back(word);
    }
  }
  return all;
}

/// The number in the last cell of the row that begins with a text.
std::string cell(const std::string& table, const std::string& row) {
  const std::size_t begin = table.find("\n| " + row + " | ");
  if (begin == std::string::npos) throw usage_error("a table of mutants has no row " + row);
  const std::size_t number = begin + row.size() + 6;
  return table.substr(number, table.find(" |", number) - number);
}

std::string mutants_text(const std::string& tables, const selection& asked, const facts& known) {
  const std::string path =
      fmt::format("{}/{}/mutation_{}.md", tables, asked.of().identifier(), asked.format());
  if (std::filesystem::exists(path)) {
    const std::string table = cost::read_text(path);
    return fmt::format("{} of {} alive, {} equivalent", cell(table, "alive"),
                       table.substr(2, table.find(' ', 2) - 2), cell(table, "equivalent"));
  }
  return known.has_mutants ? "200 tried in a test" : "-";
}

std::string proofs_text(const facts& known) {
  constexpr std::pair<const char*, const char*> kTexts[] = {{"composition", "blocks and wiring"},
                                                            {"equal", "the formula"},
                                                            {"brdf", "the formula"},
                                                            {"range", "range and registers"},
                                                            {"wiring", "registers only delay"},
                                                            {"states", "ports and registers over time"}};
  std::vector<std::string> texts;
  for (const auto& [property, text] : kTexts) {
    if (std::ranges::find(known.proved, property) != known.proved.end()) texts.emplace_back(text);
  }
  return texts.empty() ? "-" : fmt::format("{}", fmt::join(texts, "; "));
}

/// The columns beside the format; numbers stand to the right.
constexpr struct {
  const char* head;
  bool is_number;
} kColumns[] = {{"equal by", false}, {"proved", false}, {"mutants", false}, {"error", true},
                {"LUT", true},       {"NAND2", true},   {"path, ns", true}};
using line = std::array<std::string, std::size(kColumns)>;

/// What docs/long-runs.md says of the hundred million inputs.
std::string sweep_text(const std::string& tables, const selection& asked) {
  const std::string row =
      fmt::format("| `cosim.{}.long_sweep.{}` | not run yet |", asked.of().name(), asked.format());
  const bool is_missing = cost::read_text(tables + "/../long-runs.md").find(row) != std::string::npos;
  return fmt::format("corners, 2 million random; 100 million{}", is_missing ? ": not run yet" : "");
}

line line_of(const std::string& tables, const selection& asked, const facts& known,
             const cost::configuration* measured) {
  const bool has_errors = measured != nullptr && measured->errors.has_value();
  const bool has_cells = measured != nullptr && measured->cost.ice40.has_value();
  const bool has_area = measured != nullptr && measured->cost.osu018.has_value();
  std::string error = "-";
  if (has_errors)
    error = cost::number_text((*measured->errors)[static_cast<std::size_t>(cost::domain::whole)].max_abs_err);
  return {known.tries_all ? fmt::format("all {} inputs", input_count(asked)) : sweep_text(tables, asked),
          proofs_text(known),
          mutants_text(tables, asked, known),
          error,
          has_cells ? fmt::format("{}", measured->cost.ice40->lut) : "-",
          has_area ? fmt::format("{:.0f}", measured->cost.osu018->area_nand2) : "-",
          has_area ? fmt::format("{:.2f}", measured->cost.osu018->path_ns) : "-"};
}

/// A device's table, by format; columns in which nothing is known are named below it instead.
std::string table_of(const std::string& device, const std::vector<std::pair<std::string, line>>& lines) {
  std::string head = fmt::format("| {} |", device);
  std::string rule = "|---|";
  std::vector<std::string> left_out;
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < std::size(kColumns); ++i) {
    if (std::ranges::all_of(lines, [&](const auto& each) { return each.second[i] == "-"; })) {
      left_out.emplace_back(kColumns[i].head);
      continue;
    }
    shown.push_back(i);
    head += fmt::format(" {} |", kColumns[i].head);
    rule += kColumns[i].is_number ? "---:|" : "---|";
  }
  std::string text = fmt::format("\n## {}\n\n{}\n{}\n", device, head, rule);
  for (const auto& [format, cells] : lines) {
    text += fmt::format("| {} |", format);
    for (const std::size_t i : shown) text += fmt::format(" {} |", cells[i]);
    text += "\n";
  }
  if (!left_out.empty())
    text += fmt::format("\nIn no file of measured rows: {}.\n", fmt::join(left_out, "; "));
  return text;
}

constexpr const char* kHead =
    "<!-- SPDX-License-Identifier: Apache-2.0 -->\n"
    "<!-- generated by ninja -C build update_device_table; do not edit -->\n"
    "# What is known of each format\n\n"
    "A line for each device and format, with the presets of its options. A dash: not done, or not "
    "measured, in this format; what is so in all formats of a device stands below its table. What no file of "
    "measured rows has may stand on the [device's page](README.md#devices), measured once.\n\n"
    "* *Equal by*: the inputs for which the exported Verilog, in Verilator, gives the results of the "
    "bit-accurate model, bit "
    "for bit. The ports that are not enumerated run through their codes alongside. *100 million* are random "
    "inputs of a "
    "test with the label `long`, and so are the two million of a format that is not checked in; "
    "[long-runs.md](long-runs.md) says whether they ran; its row of the label `formats` is of the two "
    "million, and of "
    "the mutants of all devices but the first.\n"
    "* *Proved*, for all inputs, see [verilog.md](verilog.md#proofs-yosys-sat). *Blocks and wiring*: each "
    "block "
    "computes its formula, and they are wired as the figure is; words of memories are left out. *The "
    "formula*: "
    "the results are those of a reference written by hand in one piece. *Range and registers*: the BRDF is "
    "at "
    "most 1, registers hold. *Registers only delay*: a pipeline computes what the device without its "
    "registers "
    "does. *Ports and registers over time*: ready, valid, holding and the ranges of registers.\n"
    "* *Mutants*: faults in the Verilog that no test notices are alive; equivalent ones change no output. "
    "*200 tried in a test*: `cosim.<device>.mutation.<format>` fails if one of them is alive; numbers are "
    "those of a "
    "longer run. See [mutation.md](mutation.md).\n"
    "* *Error*: the largest |BRDF - cos^n| over all n and all codes of the cosine; of devices that take n "
    "and a cosine.\n"
    "* *LUT*: cells of an iCE40 without DSP blocks. *NAND2*, *path*: area and longest path in OSU018. See "
    "[accuracy-and-time.md](accuracy-and-time.md).\n";

std::string page_text(const facts_of_all& all, const std::string& tables) {
  const std::vector<cost::configuration> measured = cost::read_measured(tables);
  std::string page = kHead;
  for (const device* each : devices()) {
    std::vector<std::pair<std::string, line>> lines;
    for (const std::string_view format : format_names) {
      const selection asked = choose(each->name(), std::string(format));
      const auto row = std::ranges::find_if(measured, [&](const cost::configuration& of) {
        return of.asked.folder_name() == asked.folder_name() && of.asked.is_preset();
      });
      const auto known = all.find({each->name(), std::string(format)});
      lines.emplace_back(format, line_of(tables, asked, known == all.end() ? facts{} : known->second,
                                         row == measured.end() ? nullptr : &*row));
    }
    page += table_of(each->name(), lines);
  }
  return page;
}

}  // namespace

int main(int argc, char** argv) {
  std::string facts_path, tables, page;
  bool is_check = false;
  return run_program(
      argc, argv, "Makes the page of what is known of each device and format",
      [&](CLI::App& program) {
        program.add_option("FACTS", facts_path, "what the tests are, from CMake")->required();
        program.add_option("TABLES", tables, "folder of the measured rows, such as docs/tables")->required();
        program.add_option("PAGE", page, "to write")->required();
        program.add_flag("--check", is_check, "compare instead");
      },
      [&] {
        const std::string made = page_text(read_facts(facts_path), tables);
        const bool is_same = std::filesystem::exists(page) && cost::read_text(page) == made;
        if (is_same) return 0;
        if (is_check) {
          fmt::print("{} is stale: the target update_device_table writes it\n", page);
          return 1;
        }
        cost::write_text(page, made);
        return 0;
      });
}
