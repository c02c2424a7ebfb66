// SPDX-License-Identifier: Apache-2.0
// mutation DEVICE FORMAT FOLDER [--rows ROWS.csv] [--prove SCRIPT] [--states STATES] [--reasons REASONS] [--output TABLE.md]:
// does the regression kill the single-fault mutants of the exported device? FOLDER has what mutants.sh wrote: list.ys, the
// faults; control.txt, the cells of the registers' enables and resets; protocol.txt, those that valid_o and ready_o depend
// on. Exit 1 if one lives that is not shown to be equivalent. Built once for each device and format, with the modules of the
// mutants.
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <utility>

#include "tb/cosim/inner_results.h"
#include "tb/cosim/mutants.h"
#include "tb/cosim/regression.h"
#include "tb/cosim/rows_file.h"
#include "tb/cosim/strobes.h"
#include "tb/inputs.h"
#include "tb/output_file.h"
#include "tb/program.h"
#include "tb/progress.h"
#include "tb/run_tool.h"
#include "tb/usage_error.h"

namespace blysk::cosim {
namespace {

namespace fate {
enum : std::size_t { killed_by_vectors, killed_by_strobes, killed_by_all_inputs, equivalent, alive };
}
constexpr const char* kFates[] = {"killed by 20000 random writes", "killed by 20000 cycles of strobes",
                                  "killed by all inputs", "equivalent", "alive"};

std::vector<std::string> lines_of(const std::string& path) {
  std::vector<std::string> result;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) result.push_back(line);
  if (result.empty()) throw std::runtime_error(path + ": is missing or empty, expected what yosys wrote");
  return result;
}

/// Names of cells, "MODULE/CELL" a line.
std::set<std::string> cells_of(const std::string& path) {
  std::set<std::string> result;
  for (const std::string& line : lines_of(path)) result.insert(line.substr(line.find('/') + 1));
  return result;
}

mutation parse(const std::string& line, const std::set<std::string>& control,
               const std::set<std::string>& protocol) {
  static const std::regex cell(
      R"(-mode (\w+) .*-cell (\S+) -port (\w+) -portbit (\d+)(?: -ctrlbit (\d+))?(?:.* -wire (\S+) -wirebit (\d+))?)");
  static const std::regex instance(R"(\$flatten\\(\w+)\.)");
  std::smatch found;
  if (!std::regex_search(line, found, cell)) throw std::runtime_error("not a mutation: " + line);
  const std::string name = found[2];
  const std::string port = found[3];
  const std::string controlling_bit = found[5];
  const std::string wire = found[6];

  std::smatch block;
  std::string what = fmt::format("{} at {}[{}]", found[1].str(), port, found[4].str());
  if (!controlling_bit.empty()) what += fmt::format(" by bit {}", controlling_bit);
  if (!wire.empty()) what += fmt::format(", wire {}[{}]", wire, found[7].str());

  const bool is_logic = port == "A" || port == "B" || port == "S" || port == "Y";
  const bool is_control = control.contains(name);
  const bool is_wide =
      found[4] != "0" || (!controlling_bit.empty() && controlling_bit != "0");  // no strobe's register
  const bool is_in_pipe = wire.find(".held_") != std::string::npos;
  const bool is_data = (port == "D" && is_wide) || (port == "Q" && (wire.ends_with(".q_o") || is_in_pipe));
  return {std::regex_search(name, block, instance) ? block[1].str() : "made by opt",
          wire.empty() ? port : port + ", wire " + wire, what, (is_logic && !is_control) || is_data,
          protocol.contains(name)};
}

/// What the registers can hold, and what is tried of it. A mutant that passes is equivalent if its outputs are still a
/// function of what was written last, and if the device is of the kind of inner_results.
class strobe_regression final : public regression {
 public:
  explicit strobe_regression(const selection& asked)
      : asked_(asked), data_(of_role(asked.of().ports(asked), port::role::data)), reached_(asked) {
    for (const auto& make : mutants_table()) modules_.push_back(make());
    for_random_inputs(asked_, 20'000, 1,
                      [&](const columns& in) { random_.push_back(reached_.with_results(in)); });
    module_ = modules_.front().get();
    module_->select(0);
    prepare_reset_codes();
    reached_.for_others([&](const columns& in) { others_.push_back(reached_.with_results(in)); });
    play([&](std::span<const std::int64_t> levels) {
      strobes_.insert(strobes_.end(), levels.begin(), levels.end());
      return true;
    });
  }

  std::span<const char* const> fates() const override { return kFates; }

  std::size_t run(unsigned mutant, const mutation& what) override {
    module_ = modules_.at((mutant - 1) / 100).get();
    module_->select(mutant);
    for (const vectors& each : random_) {
      if (differs(each)) return fate::killed_by_vectors;
    }
    if (killed_by_strobes()) return fate::killed_by_strobes;
    if (killed_by_all_inputs()) return fate::killed_by_all_inputs;
    return what.is_datapath ? fate::equivalent : fate::alive;
  }

 private:
  bool differs(const vectors& each) {
    module_->run(each.in, got_);
    return std::ranges::any_of(reached_.outer(),
                               [&](std::size_t i) { return !(got_[i] == each.expected[i]); });
  }

  bool killed_by_strobes() {
    std::size_t next = 0;
    bool same = true;
    play([&](std::span<const std::int64_t> levels) {
      same = std::equal(levels.begin(), levels.end(), strobes_.begin() + static_cast<std::ptrdiff_t>(next));
      next += levels.size();
      return same;
    });
    return !same;
  }

  void play(const std::function<bool(std::span<const std::int64_t>)>& use) {
    play_strobes(*module_, asked_, use);
  }

  bool killed_by_all_inputs() {
    bool killed = std::ranges::any_of(reset_codes_, [&](const vectors& each) { return differs(each); });
    for_all_inputs(asked_, [&](const columns& in) {
      if (!killed) killed = differs(reached_.with_results(reached_.at_largest(in)));
    });
    return killed || std::ranges::any_of(others_, [&](const vectors& each) { return differs(each); });
  }

  // Registers hold 0 after a reset, which may be no legal code. The model is for legal ones, so the device without a fault
  // tells what they give; lockstep compares it with SystemC there.
  void prepare_reset_codes() {
    const std::size_t enumerated = asked_.of().enumerated();
    for (std::uint64_t which = 1; which < std::uint64_t{1} << enumerated; ++which) {
      std::vector<std::pair<std::int64_t, std::int64_t>> ranges;
      bool is_new = true;
      for (std::size_t i = 0; i < enumerated; ++i) {
        const wire_format& format = *data_[i].carries;
        const bool is_reset = (which >> i & 1) != 0;
        is_new = is_new && (!is_reset || format.min > 0 || format.max < 0);
        ranges.emplace_back(is_reset ? 0 : format.min, is_reset ? 0 : format.max);
      }
      if (is_new) try_codes(ranges);
    }
  }

  void try_codes(const std::vector<std::pair<std::int64_t, std::int64_t>>& ranges) {
    batcher writes(asked_, [&](const columns& in) {
      vectors tried{reached_.at_largest(in), {}};
      module_->run(tried.in, tried.expected);
      for (std::size_t row = 0; row < in.size(); ++row) {
        if (!reached_.occurs(reached_.outer_results(tried.expected, row)))
          throw std::runtime_error(
              "the reset value gives an inner result that no legal code gives, expected one of those");
      }
      reset_codes_.push_back(std::move(tried));
    });
    std::vector<std::int64_t> codes;
    codes.reserve(ranges.size());
    for (const auto& [first, last] : ranges) codes.push_back(first);
    for (;;) {
      writes.add(codes);
      std::size_t digit = codes.size();
      while (digit > 0 && codes[digit - 1] == ranges[digit - 1].second) {
        codes[digit - 1] = ranges[digit - 1].first;
        --digit;
      }
      if (digit == 0) break;
      ++codes[digit - 1];
    }
    writes.flush();
  }

  const selection& asked_;
  std::vector<port> data_;
  inner_results reached_;
  std::vector<std::unique_ptr<mutants>> modules_;
  mutants* module_ = nullptr;  // the one with the mutant that runs
  std::vector<vectors> random_, reset_codes_, others_;
  std::vector<std::int64_t> strobes_;  // levels after every edge
  columns got_;
};

/// What shows that survivors are equivalent, beside the regression itself.
struct arguments_for_equivalence {
  std::string script;   ///< mutants.sh; empty: no proofs
  std::string states;   ///< the device's states.v for them, or empty
  std::string reasons;  ///< the device's survivors.txt, or empty
};

/// Reasons of survivors.txt: "NUMBER | BLOCK | FAULT" as the table has them, a tab, the reason.
std::map<std::string, std::string> read_reasons(const std::string& path) {
  std::map<std::string, std::string> reasons;
  if (path.empty()) return reasons;
  for (const std::string& line : lines_of(path)) {
    if (line.starts_with('#')) continue;
    const std::size_t tab = line.find('\t');
    if (tab == std::string::npos || tab + 1 == line.size())
      throw std::runtime_error(
          fmt::format("{}: expected NUMBER | BLOCK | FAULT, a tab, the reason, not '{}'", path, line));
    reasons[line.substr(0, tab)] = line.substr(tab + 1);
  }
  return reasons;
}

std::unique_ptr<regression> make_regression(const selection& asked, const std::string& folder,
                                            const std::string& rows, const arguments_for_equivalence& with) {
  if (protocol_of(asked.of().ports(asked)) == protocol::strobes) {
    if (!rows.empty())
      throw usage_error("--rows is for a device with start and ready, " + asked.of().name() + " has strobes");
    return std::make_unique<strobe_regression>(asked);
  }
  columns own_rows = rows.empty() ? columns() : read_rows(asked, rows);
  return make_row_regression(asked, std::move(own_rows), [=, fraction = asked.fraction()](unsigned number) {
    std::vector<std::string> words{with.script, "prove", folder, fmt::format("{}", number)};
    if (!with.states.empty()) {
      words.push_back(with.states);
      words.push_back(fmt::format("{}", fraction));
    }
    return !with.script.empty() && runs_well(words);
  });
}

int run(const selection& asked, const std::string& folder, const std::string& rows,
        const arguments_for_equivalence& with, const std::string& table) {
  const std::set<std::string> control = cells_of(folder + "/control.txt");
  std::set<std::string> protocol;
  if (protocol_of(asked.of().ports(asked)) == blysk::protocol::handshake)
    protocol = cells_of(folder + "/protocol.txt");
  std::vector<mutation> mutations;
  for (const std::string& line : lines_of(folder + "/list.ys"))
    mutations.push_back(parse(line, control, protocol));

  if (mutations.size() != 100 * mutants_table().size())
    throw std::runtime_error(fmt::format("{}/list.ys has {} mutants, expected {}", folder, mutations.size(),
                                         100 * mutants_table().size()));
  const std::unique_ptr<regression> tests = make_regression(asked, folder, rows, with);
  const std::span<const char* const> fates = tests->fates();
  const std::size_t is_alive = fates.size() - 1;
  const std::size_t is_equivalent = fates.size() - 2;
  const std::map<std::string, std::string> reasons = read_reasons(with.reasons);
  std::size_t explained = 0;
  std::vector<std::size_t> counts(fates.size());
  std::string survivors;
  std::map<std::string, std::size_t> places;  // of equivalent mutants
  progress bar("mutants", mutations.size());
  for (std::size_t i = 0; i < mutations.size(); ++i) {
    std::size_t end = tests->run(static_cast<unsigned>(i + 1), mutations[i]);
    const auto reason =
        reasons.find(fmt::format("{} | {} | {}", i + 1, mutations[i].block, mutations[i].what));
    const bool is_explained = end == is_alive && reason != reasons.end();
    if (is_explained) {
      end = is_equivalent;
      ++explained;
    }
    ++counts[end];
    if (end == is_equivalent) ++places[mutations[i].block + " | " + mutations[i].place];
    if (end == is_equivalent || end == is_alive)
      survivors += fmt::format("| {} | {} | {} | {} |\n", i + 1, mutations[i].block, mutations[i].what,
                               is_explained ? "equivalent: " + reason->second : fates[end]);
    bar.advance(1);
  }

  std::string text =
      fmt::format("| {} mutants of {} | |\n|---|---|\n", mutations.size(), asked.folder_name());
  for (std::size_t end = 0; end < fates.size(); ++end)
    text += fmt::format("| {} | {} |\n", fates[end], counts[end]);
  if (explained > 0)
    text += fmt::format("| of the equivalent ones by a reason, not by proof | {} |\n", explained);
  if (!places.empty()) text += "\n| equivalent, block | port | mutants |\n|---|---|---|\n";
  for (const auto& [place, count] : places) text += fmt::format("| {} | {} |\n", place, count);
  if (!survivors.empty()) text += "\n| mutant | block | fault | |\n|---|---|---|---|\n" + survivors;
  fmt::print("{}", text);
  if (!table.empty()) {
    output_file file(table);
    file.write(text);
    file.close();
    file.commit();
  }
  return counts[is_alive] == 0 ? 0 : 1;
}

}  // namespace
}  // namespace blysk::cosim

int main(int argc, char** argv) {
  using namespace blysk;
  device_arguments arguments;
  cosim::arguments_for_equivalence with;
  std::string folder, rows, table;
  return run_program(
      argc, argv, "Tries the single-fault mutants of an exported device on the regression",
      [&](CLI::App& program) {
        arguments.add_to(program);
        program.add_option("FOLDER", folder, "of list.ys, control.txt and protocol.txt")->required();
        program.add_option("--rows", rows, "further rows of the regression, raw codes in CSV")
            ->check(CLI::ExistingFile);
        program.add_option("--prove", with.script, "mutants.sh, which proves that survivors are equivalent");
        program.add_option("--states", with.states, "states.v of the device, for the proofs")
            ->check(CLI::ExistingFile);
        program.add_option("--reasons", with.reasons, "survivors.txt of the device")
            ->check(CLI::ExistingFile);
        program.add_option("--output", table, "Markdown file for the result");
      },
      [&] { return cosim::run(arguments.chosen(), folder, rows, with, table); });
}
