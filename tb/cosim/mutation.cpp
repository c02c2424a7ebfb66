// SPDX-License-Identifier: Apache-2.0
// mutation FORMAT LIST [TABLE.md]: does the regression kill the single-fault mutants of the exported device?
// LIST is what yosys `mutate -list` wrote. Exit 1 if one lives that is not shown to be equivalent.
#include <fmt/format.h>

#include <fstream>
#include <map>
#include <regex>

#include "tb/bit/quadratic.h"
#include "tb/cosim/mutants.h"
#include "tb/cosim/strobes.h"
#include "tb/cosim/vectors.h"
#include "tb/progress.h"

namespace blysk::cosim {
namespace {

enum class fate { killed_by_vectors, killed_by_strobes, killed_by_all_inputs, equivalent, alive };
constexpr const char* kFates[] = {"killed by 20000 random writes", "killed by 20000 cycles of strobes",
                                  "killed by all inputs", "equivalent", "alive"};

struct mutation {
  std::string block;  // instance in the device
  std::string port;
  std::string what;
  bool is_behind_data;

  // A fault at a combinational cell, or behind a data register, leaves the outputs a function of what the data
  // registers hold.
  bool is_combinational() const {
    return std::string_view("ABSY").find(port) != std::string_view::npos || is_behind_data;
  }
};

mutation parse(const std::string& line) {
  static const std::regex cell(
      R"(-mode (\w+) .*-cell (\S+) -port (\w+) -portbit (\d+)(?:.* -wire (\S+) -wirebit (\d+))?)");
  static const std::regex instance(R"(\$flatten\\(\w+)\.)");
  std::smatch found;
  if (!std::regex_search(line, found, cell)) throw std::runtime_error("not a mutation: " + line);
  std::smatch block;
  const std::string name = found[2];
  return {std::regex_search(name, block, instance) ? block[1].str() : "made by opt", found[3],
          fmt::format("{} at {}[{}], wire {}[{}]", found[1].str(), found[3].str(), found[4].str(),
                      found[5].str(), found[6].str()),
          found[3] == "Q" && found[5].str().ends_with(".q_o")};
}

struct vectors {
  batch in;
  results expected;
};

class regression {
 public:
  explicit regression(const std::string& format) {
    device_options options;
    options.format = format;
    fraction_ = fraction_bits(options);
    model_ = bit::make_quadratic(options);
    for_random_inputs(fraction_, 20'000, 1, [&](const batch& in) { random_.push_back(with_results(in)); });
    prepare_colours();
    strobes_ = play_strobes(0);
  }

  fate run(unsigned mutant, const mutation& what) {
    mutants_->select(mutant);
    for (const vectors& each : random_) {
      if (differs(each)) return fate::killed_by_vectors;
    }
    if (play_strobes(mutant) != strobes_) return fate::killed_by_strobes;
    if (killed_by_all_inputs()) return fate::killed_by_all_inputs;
    return what.is_combinational() ? fate::equivalent : fate::alive;
  }

 private:
  vectors with_results(const batch& in) {
    vectors result{in, {}};
    model_->run(in, result.expected);
    return result;
  }

  bool differs(const vectors& each) {
    mutants_->run(each.in, got_);
    return got_.red != each.expected.red || got_.green != each.expected.green ||
           got_.blue != each.expected.blue;
  }

  // 25..27 at colours 255 tell all BRDFs apart, so all (n, cos) there cover the path to the BRDF; then every colour at
  // every BRDF that occurs covers multipliers 12..14. No single fault of a combinational cell is outside both.
  bool killed_by_all_inputs() {
    bool killed = false;
    for_all_inputs(fraction_, [&](batch in) {
      if (killed) return;
      in.red_ks.assign(in.size(), 255);
      in.green_ks = in.blue_ks = in.red_ks;
      killed = differs(with_results(in));
    });
    for (std::size_t i = 0; i < colours_.size() && !killed; ++i) killed = differs(colours_[i]);
    return killed;
  }

  void prepare_colours() {
    std::map<std::int64_t, std::pair<unsigned, unsigned>> inputs;  // of every BRDF
    for_all_inputs(fraction_, [&](const batch& in) {
      results out;
      model_->run(in, out);
      for (std::size_t i = 0; i < in.size(); ++i) inputs.try_emplace(out.brdf[i], in.n[i], in.cos_delta[i]);
    });
    batch in;
    for (const auto& [brdf, input] : inputs) {
      for (unsigned colour = 0; colour < 256; ++colour)
        append(in, input.first, input.second, colour, colour, colour);
      if (in.size() >= 4096) {
        colours_.push_back(with_results(in));
        in.resize(0);
      }
    }
    if (in.size() > 0) colours_.push_back(with_results(in));
  }

  std::vector<outputs> play_strobes(unsigned mutant) {
    mutants_->select(mutant);
    strobe_sequence strobes(fraction_);
    std::vector<outputs> played;
    pins values;
    for (int cycle = 0; cycle < 20'000; ++cycle) {
      values = strobes.next(values);
      for (const bool clk : {false, true}) {
        values.clk = clk;
        played.push_back(mutants_->apply(values));
      }
    }
    return played;
  }

  int fraction_ = 0;
  std::unique_ptr<engine> model_;
  std::unique_ptr<mutants> mutants_ = make_mutants();
  std::vector<vectors> random_, colours_;
  std::vector<outputs> strobes_;
  results got_;
};

int run(const std::string& format, const std::string& list, const std::string& table) {
  std::vector<mutation> mutations;
  std::ifstream lines(list);
  for (std::string line; std::getline(lines, line);) mutations.push_back(parse(line));

  regression tests(format);
  std::map<fate, std::size_t> counts;
  std::string survivors;
  progress bar("mutants", mutations.size());
  for (std::size_t i = 0; i < mutations.size(); ++i) {
    const fate end = tests.run(static_cast<unsigned>(i + 1), mutations[i]);
    ++counts[end];
    if (end == fate::equivalent || end == fate::alive) {
      survivors += fmt::format("| {} | {} | {} | {} |\n", i + 1, mutations[i].block, mutations[i].what,
                               kFates[static_cast<int>(end)]);
    }
    bar.advance(1);
  }

  std::string text = fmt::format("| {} mutants of {} | |\n|---|---|\n", mutations.size(), format);
  for (const fate each : {fate::killed_by_vectors, fate::killed_by_strobes, fate::killed_by_all_inputs,
                          fate::equivalent, fate::alive}) {
    text += fmt::format("| {} | {} |\n", kFates[static_cast<int>(each)], counts[each]);
  }
  if (!survivors.empty()) text += "\n| mutant | block | fault | |\n|---|---|---|---|\n" + survivors;
  fmt::print("{}", text);
  if (!table.empty()) std::ofstream(table) << text;
  return counts[fate::alive] == 0 && !mutations.empty() ? 0 : 1;
}

}  // namespace
}  // namespace blysk::cosim

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: mutation FORMAT LIST [TABLE.md]\n");
    return 2;
  }
  return blysk::cosim::run(argv[1], argv[2], argc > 3 ? argv[3] : "");
}
