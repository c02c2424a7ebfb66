// SPDX-License-Identifier: Apache-2.0
// mutation FORMAT FOLDER [TABLE.md]: does the regression kill the single-fault mutants of the exported device?
// FOLDER has list.ys, which yosys `mutate -list` wrote, and control.txt, which names the cells of the registers' enables
// and resets. Exit 1 if one lives that is not shown to be equivalent.
#include <map>
#include <regex>
#include <set>
#include <utility>

#include "tb/bit/quadratic.h"
#include "tb/cosim/mutants.h"
#include "tb/cosim/program.h"
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
  std::string place;  // port of its cell and wire there
  std::string what;
  // The outputs remain a function of what was written last: the fault sits at a cell of the datapath, or at the input or
  // the output of a data register.
  bool is_datapath;
};

std::vector<std::string> lines_of(const std::string& path) {
  std::vector<std::string> result;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) result.push_back(line);
  if (result.empty()) throw std::runtime_error(path + ": is missing or empty, expected what yosys wrote");
  return result;
}

/// Names of the cells that decide when registers load: "MODULE/CELL" a line.
std::set<std::string> control_cells(const std::string& path) {
  std::set<std::string> result;
  for (const std::string& line : lines_of(path)) result.insert(line.substr(line.find('/') + 1));
  return result;
}

mutation parse(const std::string& line, const std::set<std::string>& control) {
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
  const bool is_data = (port == "D" && is_wide) || (port == "Q" && wire.ends_with(".q_o"));
  return {std::regex_search(name, block, instance) ? block[1].str() : "made by opt",
          wire.empty() ? port : port + ", wire " + wire, what, (is_logic && !is_control) || is_data};
}

/// The modules of all hundreds.
template <std::size_t... Index>
std::vector<std::unique_ptr<mutants>> make_all_mutants(std::index_sequence<Index...>) {
  std::vector<std::unique_ptr<mutants>> result;
  (result.push_back(make_mutants<static_cast<int>(Index) + 1>()), ...);
  return result;
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
    module_ = modules_.front().get();
    module_->select(0);
    prepare_reset_exponent();
    prepare_colours();
    strobes_ = play_strobes();
  }

  fate run(unsigned mutant, const mutation& what) {
    module_ = modules_.at((mutant - 1) / 100).get();
    module_->select(mutant);
    for (const vectors& each : random_) {
      if (differs(each)) return fate::killed_by_vectors;
    }
    if (play_strobes() != strobes_) return fate::killed_by_strobes;
    if (killed_by_all_inputs()) return fate::killed_by_all_inputs;
    return what.is_datapath ? fate::equivalent : fate::alive;
  }

 private:
  vectors with_results(const batch& in) {
    vectors result{in, {}};
    model_->run(in, result.expected);
    return result;
  }

  bool differs(const vectors& each) {
    module_->run(each.in, got_);
    return got_.red != each.expected.red || got_.green != each.expected.green ||
           got_.blue != each.expected.blue;
  }

  // Registers can hold n in 0..1000, 0 since their reset, and every legal cosine and colour. 25..27 at colours 255 tell
  // all BRDFs apart, so all (n, cos) there cover the path to the BRDF; then every colour at every BRDF that occurs covers
  // multipliers 12..14. No single fault of the datapath is outside both.
  bool killed_by_all_inputs() {
    bool killed = differs(reset_exponent_);
    for_all_inputs(fraction_, [&](batch in) {
      if (killed) return;
      in.red_ks.assign(in.size(), 255);
      in.green_ks = in.blue_ks = in.red_ks;
      killed = differs(with_results(in));
    });
    for (std::size_t i = 0; i < colours_.size() && !killed; ++i) killed = differs(colours_[i]);
    return killed;
  }

  // The model is for legal n, so the device without a fault tells what n = 0 gives; cosim.lockstep compares it with
  // SystemC there.
  void prepare_reset_exponent() {
    for (unsigned code = 0; code <= 1u << fraction_; ++code) {
      append(reset_exponent_.in, 0, code, 255, 255, 255);
    }
    module_->run(reset_exponent_.in, reset_exponent_.expected);
  }

  void prepare_colours() {
    std::map<std::int64_t, std::pair<unsigned, unsigned>> inputs;  // of every BRDF
    for_all_inputs(fraction_, [&](const batch& in) {
      results out;
      model_->run(in, out);
      for (std::size_t i = 0; i < in.size(); ++i) inputs.try_emplace(out.brdf[i], in.n[i], in.cos_delta[i]);
    });
    for (const std::int64_t red : reset_exponent_.expected.red) {
      if (!inputs.contains(red / 255)) throw std::runtime_error("n = 0 gives a BRDF that no other n gives");
    }
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

  std::vector<outputs> play_strobes() {
    std::vector<outputs> played;
    cosim::play_strobes(*module_, fraction_, [&](const outputs& each) { played.push_back(each); });
    return played;
  }

  int fraction_ = 0;
  std::unique_ptr<engine> model_;
  std::vector<std::unique_ptr<mutants>> modules_ =
      make_all_mutants(std::make_index_sequence<BLYSK_HUNDREDS>());
  mutants* module_ = nullptr;  // the one with the mutant that runs
  std::vector<vectors> random_, colours_;
  vectors reset_exponent_;  // n = 0 at all cosines, colours 255
  std::vector<outputs> strobes_;
  results got_;
};

int run(const std::string& format, const std::string& folder, const std::string& table) {
  const std::set<std::string> control = control_cells(folder + "/control.txt");
  std::vector<mutation> mutations;
  for (const std::string& line : lines_of(folder + "/list.ys")) mutations.push_back(parse(line, control));

  regression tests(format);
  std::map<fate, std::size_t> counts;
  std::string survivors;
  std::map<std::string, std::size_t> equivalent;  // by place
  progress bar("mutants", mutations.size());
  for (std::size_t i = 0; i < mutations.size(); ++i) {
    const fate end = tests.run(static_cast<unsigned>(i + 1), mutations[i]);
    ++counts[end];
    if (end == fate::equivalent) ++equivalent[mutations[i].block + " | " + mutations[i].place];
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
  if (!equivalent.empty()) text += "\n| equivalent, block | port | mutants |\n|---|---|---|\n";
  for (const auto& [place, count] : equivalent) text += fmt::format("| {} | {} |\n", place, count);
  if (!survivors.empty()) text += "\n| mutant | block | fault | |\n|---|---|---|---|\n" + survivors;
  fmt::print("{}", text);
  if (!table.empty()) write_file(table, text);
  return counts[fate::alive] == 0 ? 0 : 1;
}

}  // namespace
}  // namespace blysk::cosim

int main(int argc, char** argv) {
  return blysk::cosim::program([&] {
    if (argc < 3 || argc > 4) throw std::invalid_argument("usage: mutation FORMAT FOLDER [TABLE.md]");
    return blysk::cosim::run(argv[1], argv[2], argc == 4 ? argv[3] : "");
  });
}
