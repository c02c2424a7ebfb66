// SPDX-License-Identifier: Apache-2.0
// referee DELAYS.json NETLIST.json WAVES.vcd: waves of the nets between the blocks of a mapped netlist, from a simulation of
// its cells with their delays, beside the delays of the blocks. In each clock cycle every bit that a block drives changes for
// the last time no later than an input bit's last change and the block's delay from that bit. Prints how near each block
// comes to its delays. Exit 1 if a bit changes later.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tb/cost/cost_row.h"
#include "tb/cost/delays.h"
#include "tb/program.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;
using json = nlohmann::ordered_json;

constexpr long long kNever = -1;

/// A bit of a block's port, and the net at it.
struct place {
  std::string name;
  int net;  ///< number of the net, or -1 for a constant
};

struct judged_block {
  const block_delays* of;
  std::vector<place> inputs;
  std::vector<std::vector<place>> outputs;
  bool is_register = false;
  long long checks = 0;
  double nearest = 0;  ///< the largest share of the allowed time that was taken
};

class referee {
 public:
  referee(const device_delays& delays, const json& top, std::map<std::string, int> nets)
      : nets_(std::move(nets)) {
    std::map<int, int> number;  // of the netlist's bits
    for (const auto& [name, what] : top.at("netnames").items()) {
      const json& bit = what.at("bits").at(0);
      const auto known = nets_.find(name);
      if (bit.is_number() && known != nets_.end()) number.try_emplace(bit.get<int>(), known->second);
    }
    const auto place_of = [&](const json& pins, const timed_pin& pin, int bit) {
      const std::string whole = fmt::format("{}[{}]", pin.name, bit);
      const json& wire = pins.at(pins.contains(whole) ? whole : pin.name).at(0);
      if (!wire.is_number()) return place{whole, -1};
      const auto found = number.find(wire.get<int>());
      if (found == number.end()) throw std::runtime_error(fmt::format("the waves lack the net at {}", whole));
      return place{whole, found->second};
    };
    clock_ = nets_.at("clk");
    for (const block_delays& each : delays.blocks) {
      const json& pins = top.at("cells").at(each.block).at("connections");
      judged_block judged{&each, {}, {}};
      for (const timed_pin& pin : each.inputs) {
        for (int bit = 0; bit < pin.width; ++bit) judged.inputs.push_back(place_of(pins, pin, bit));
      }
      judged.is_register =
          std::ranges::any_of(judged.inputs, [this](const place& input) { return input.net == clock_; });
      for (const timed_pin& pin : each.outputs) {
        auto& places = judged.outputs.emplace_back();
        for (int bit = 0; bit < pin.width; ++bit) places.push_back(place_of(pins, pin, bit));
      }
      blocks_.push_back(std::move(judged));
    }
    last_.assign(nets_.size(), kNever);
  }

  void change(int net, bool value, long long now) {
    if (net == clock_ && value) {
      judge();
      std::ranges::fill(last_, kNever);
      began_ = now;
      ++cycles_;
    }
    // Before the second cycle wires leave X.
    last_[static_cast<std::size_t>(net)] = now;
  }

  int report() const {
    for (const judged_block& each : blocks_) {
      fmt::print("{}: {} changes, {:.1f} % of the time that its delays allow\n", each.of->block, each.checks,
                 100 * each.nearest);
    }
    return is_broken_ ? 1 : 0;
  }

 private:
  void judge() {
    if (cycles_ < 4) return;  // reset
    for (judged_block& each : blocks_) {
      for (std::size_t i = 0; i < each.outputs.size(); ++i) {
        for (std::size_t bit = 0; bit < each.outputs[i].size(); ++bit)
          judge(each, each.outputs[i][bit], each.of->ps[i][bit]);
      }
    }
  }

  void judge(judged_block& block, const place& output, const std::vector<int>& delays) {
    if (output.net < 0) return;
    const long long changed = last_[static_cast<std::size_t>(output.net)];
    if (changed == kNever) return;
    long long allowed = kNever, from = kNever;
    for (std::size_t i = 0; i < block.inputs.size(); ++i) {
      if (block.inputs[i].net < 0 || delays[i] < 0) continue;
      const long long start = last_[static_cast<std::size_t>(block.inputs[i].net)];
      // The clock falls too; registers follow its rising edge, which began the cycle.
      const long long cause = block.inputs[i].net == clock_ ? began_ : start;
      if (cause == kNever || cause + delays[i] <= allowed) continue;
      allowed = cause + delays[i];
      from = cause;
    }
    ++block.checks;
    if (changed > allowed) {
      if (!is_broken_) {
        fmt::print("{}.{} changes at {} ps, its delays allow {} ps\n", block.of->block, output.name, changed,
                   allowed);
      }
      is_broken_ = true;
    } else if (allowed > from) {
      block.nearest =
          std::max(block.nearest, static_cast<double>(changed - from) / static_cast<double>(allowed - from));
    }
  }

  std::map<std::string, int> nets_;
  std::vector<judged_block> blocks_;
  std::vector<long long> last_;  // change of each net in this cycle, ps
  int clock_ = -1;
  long long began_ = 0;
  long long cycles_ = 0;
  bool is_broken_ = false;
};

int run(const std::string& delays_path, const std::string& netlist_path, const std::string& vcd_path) {
  const device_delays delays = cost::parse_delays(delays_path, cost::read_text(delays_path));
  const json netlist = cost::parse_json(netlist_path, cost::read_text(netlist_path));
  const json* top = nullptr;
  for (const auto& [name, module] : netlist.at("modules").items()) {
    if (module.at("cells").contains(delays.blocks.at(0).block)) top = &module;
  }
  if (top == nullptr) throw file_error(netlist_path, 0, "has no module with these blocks");
  std::istringstream lines(cost::read_text(vcd_path));
  std::map<std::string, int> nets;
  std::map<std::string, int> codes;
  std::string line;
  while (std::getline(lines, line) && !line.starts_with("$enddefinitions")) {
    std::istringstream words(line);
    std::string word, kind, width, code, name;
    words >> word >> kind >> width >> code >> name;
    if (word != "$var") continue;
    if (name.starts_with('\\')) name.erase(0, 1);
    const int number = codes.try_emplace(code, static_cast<int>(codes.size())).first->second;
    nets[name] = number;
  }
  if (nets.empty()) throw file_error(vcd_path, 0, "names no net, expected the waves of the mapped netlist");
  referee judge(delays, *top, nets);
  long long now = 0;
  long long changes = 0;
  while (std::getline(lines, line)) {
    if (line.starts_with('#')) {
      std::from_chars(line.data() + 1, line.data() + line.size(), now);
    } else if (!line.empty() && line.front() != '$' && line.front() != 'b') {
      const auto found = codes.find(line.substr(1));
      if (found == codes.end()) continue;
      judge.change(found->second, line.front() == '1', now);
      ++changes;
    }
  }
  if (changes < 1000) throw file_error(vcd_path, 0, "has next to no changes");
  return judge.report();
}

}  // namespace

int main(int argc, char** argv) {
  std::string delays, netlist, vcd;
  return run_program(
      argc, argv, "Compares waves of a mapped netlist with the delays of its blocks",
      [&](CLI::App& program) {
        program.add_option("DELAYS", delays, "of scripts/synth --delays")->required();
        program.add_option("NETLIST", netlist, "that Yosys wrote as JSON")->required();
        program.add_option("WAVES", vcd, "of the nets between its blocks")->required();
      },
      [&] { return run(delays, netlist, vcd); });
}
