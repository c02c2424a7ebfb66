// SPDX-License-Identifier: Apache-2.0
// A pipelined device in SystemC, its ports driven one cycle at a time: latency, bubbles, stalls, and a reset with points under
// way. One process per case: SystemC elaborates once.
#include "tb/specular/pipelined.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <fstream>
#include <map>
#include <random>
#include <sstream>
#include <systemc>

#include <nlohmann/json.hpp>

#include "tb/catch.h"
#include "tb/devices/test/asked.h"
#include "tb/specular/test/handshake_bench.h"

namespace {

using namespace blysk;
using specular::handshake_bench;
using specular::outputs;

const specular::pipelined& pipelined_of(const selection& asked) {
  return dynamic_cast<const specular::pipelined&>(asked.of());
}

}  // namespace

TEST_CASE("a point takes as many cycles as there are stages", "[variants]") {
  handshake_bench bench;
  const int last = static_cast<int>(pipelined_of(bench.asked()).levels().size()) - 1;
  REQUIRE(bench.latency() == 1 + pipelined_of(bench.asked()).cuts(bench.asked()).between(0, last));
  const std::vector<std::int64_t> point = bench.random_point();
  bench.put(point);
  CHECK_FALSE(bench.cycle(true, false).valid);
  bench.put(bench.random_point());
  for (int i = 1; i < bench.latency(); ++i) CHECK_FALSE(bench.cycle(false, false).valid);
  const outputs seen = bench.cycle(false, false);
  CHECK(seen.valid);
  CHECK(seen.results == bench.expected(point));
  CHECK_FALSE(bench.cycle(false, false).valid);
}

TEST_CASE("without stalls a point leaves in each cycle", "[variants]") {
  handshake_bench bench;
  std::deque<std::vector<std::int64_t>> under_way;
  int delivered = 0;
  for (int i = 0; i < 200; ++i) {
    const std::vector<std::int64_t> point = bench.random_point();
    bench.put(point);
    const outputs seen = bench.cycle(true, false);
    CHECK(seen.ready);
    CHECK(seen.valid == (i >= bench.latency()));
    if (seen.valid) {
      REQUIRE(seen.results == bench.expected(under_way.front()));
      under_way.pop_front();
      ++delivered;
    }
    under_way.push_back(point);
  }
  CHECK(delivered == 200 - bench.latency());
}

TEST_CASE("with bubbles, stalls and resets each point that was taken leaves once, in order", "[variants]") {
  handshake_bench bench;
  std::deque<std::vector<std::int64_t>> under_way;
  std::optional<outputs> held;
  int delivered = 0, stalled = 0, lost = 0;
  for (int i = 0; i < 20000; ++i) {
    const std::vector<std::int64_t> point = bench.random_point();
    bench.put(point);
    const bool start = !bench.one_in(3);
    const bool stall = bench.one_in(3);
    const bool reset = bench.one_in(200);
    const outputs seen = bench.cycle(start, stall, reset);
    // A result that was not taken is still there, with all its bits.
    if (held) REQUIRE((seen.valid && seen.results == held->results));
    held.reset();
    REQUIRE(seen.ready == !(seen.valid && stall));
    if (seen.valid) {
      REQUIRE_FALSE(under_way.empty());
      REQUIRE(seen.results == bench.expected(under_way.front()));
    }
    if (reset) {
      lost += static_cast<int>(under_way.size());
      under_way.clear();
      continue;
    }
    if (seen.valid && stall) {
      held = seen;
      ++stalled;
      continue;
    }
    if (seen.valid) {
      under_way.pop_front();
      ++delivered;
    }
    if (start) under_way.push_back(point);
    REQUIRE(under_way.size() <= static_cast<std::size_t>(bench.latency()));
  }
  // A third of 20,000 cycles stalls, with a result or without.
  CHECK(delivered > 4000);
  CHECK(stalled > 1000);
  CHECK(lost > 50);
}

namespace {

/// The stage at which a net carries what belongs to one point: 0 at the ports, the number of registers before it elsewhere.
class stage_count {
 public:
  explicit stage_count(const netlist::elaborated& device) : device_(device) {
    std::vector<const sc_core::sc_module*> left = device.parts().modules();
    std::erase_if(left, [](const auto* each) { return std::string(each->basename()) == "control"; });
    while (!left.empty()) {
      const std::size_t before = left.size();
      std::erase_if(left, [&](const sc_core::sc_module* each) { return pass(*each); });
      REQUIRE(left.size() < before);
    }
  }

  int of(const sc_core::sc_interface* net) const { return stages_.at(net); }
  int blocks_with_inputs() const { return blocks_; }

 private:
  static constexpr int kAny = -1;  // constants

  /// \return  whether the stages of all inputs are known, so that those of the outputs are now
  bool pass(const sc_core::sc_module& module) {
    const netlist::block& part = *device_.parts().find(module);
    const std::string name = module.basename();
    const bool is_first = name.starts_with("rg") || name == "pipe_valid";
    int stage = is_first ? 0 : kAny;
    for (const sc_core::sc_port_base* each : netlist::ports_of_module(module)) {
      const std::string port = each->basename();
      const bool is_control = port == "clk" || port == "rst_n" || port == "go_i" || port == "we_i";
      if (part.described(port).where != netlist::declaration::role::input || is_control || is_first) continue;
      const auto known = stages_.find(each->get_interface());
      if (known == stages_.end()) return false;
      if (known->second == kAny) continue;
      CAPTURE(module.name(), port);
      REQUIRE((stage == kAny || stage == known->second));
      stage = known->second;
    }
    if (stage != kAny) {
      stage += static_cast<int>(part.registers().size());
      ++blocks_;
    }
    for (const sc_core::sc_port_base* each : netlist::ports_of_module(module)) {
      if (part.described(each->basename()).where == netlist::declaration::role::output)
        stages_[each->get_interface()] = stage;
    }
    return true;
  }

  const netlist::elaborated& device_;
  std::map<const sc_core::sc_interface*, int> stages_;
  int blocks_ = 0;
};

const sc_core::sc_interface* net_behind(const netlist::elaborated& device, const std::string& port) {
  for (const sc_core::sc_port_base* each : netlist::ports_of_module(device.device())) {
    if (port == each->basename()) return each->get_interface();
  }
  throw std::logic_error("no port " + port);
}

}  // namespace

TEST_CASE("whatever the cuts, all inputs of a block belong to one point") {
  const selection asked = test::asked_for();
  const int cuts = static_cast<int>(pipelined_of(asked).levels().size()) - 1;
  // All choices of up to five cuts; of more, those of each single cut, all of them, and 100 random ones.
  std::vector<std::uint64_t> choices;
  std::mt19937_64 random(1);
  if (cuts <= 5) {
    for (std::uint64_t each = 0; each >> cuts == 0; ++each) choices.push_back(each);
  } else {
    for (int cut = 0; cut < cuts; ++cut) choices.push_back(std::uint64_t{1} << cut);
    choices.push_back((std::uint64_t{1} << cuts) - 1);
    for (int i = 0; i < 100; ++i) choices.push_back(random() >> (64 - cuts));
  }
  struct made {
    std::string list;
    int stages;
    std::unique_ptr<netlist::elaborated> device;
  };
  std::vector<made> all;
  sc_core::sc_report_handler::set_actions(sc_core::SC_ID_INSTANCE_EXISTS_, sc_core::SC_DO_NOTHING);
  for (const std::uint64_t choice : choices) {
    std::string list;
    int stages = 1;
    for (int cut = 1; cut <= cuts; ++cut) {
      if (((choice >> (cut - 1)) & 1) == 0) continue;
      if (!list.empty()) list += ',';
      list += std::to_string(cut);
      ++stages;
    }
    const std::map<std::string, std::string> options{list.empty() ? std::pair("stages", "1")
                                                                  : std::pair("cuts", list.c_str())};
    all.push_back(
        {list, stages, asked.of().elaborate(choose(asked.of().name(), asked.format(), options), 0)});
  }
  sc_core::sc_start(sc_core::SC_ZERO_TIME);  // what ports are bound to is known from here on
  for (const made& each : all) {
    CAPTURE(each.list);
    const stage_count count(*each.device);
    for (const char* port : {"r_o", "g_o", "b_o", "valid_o"}) {
      CAPTURE(port);
      CHECK(count.of(net_behind(*each.device, port)) == each.stages);
    }
    CHECK(count.blocks_with_inputs() > 10);
  }
}

TEST_CASE("the levels take what was measured of their blocks") {
  const selection asked = test::asked_for();
  const selection other = *asked.of().computes_as(asked);
  std::ifstream file(std::string(BLYSK_TABLES) + "/" + other.of().identifier() + "/delays_q12.json");
  REQUIRE(file);
  const nlohmann::json measured = nlohmann::json::parse(file).at("blocks");
  const auto worst = [&](const std::string& block) {
    int most = 0;
    for (const auto& [bit, row] : measured.at(block).at("ps").items()) {
      std::istringstream words(row.get<std::string>());
      for (std::string word; words >> word;) {
        if (word != "-") most = std::max(most, std::stoi(word));
      }
    }
    return most;
  };
  std::size_t blocks = 0;
  for (const specular::pipeline_level& level : pipelined_of(asked).levels()) {
    int longest = 0;
    for (const auto& chain : level.chains) {
      int sum = 0;
      for (const std::string& block : chain) sum += worst(block);
      longest = std::max(longest, sum);
      blocks += chain.size();
    }
    CAPTURE(level.chains);
    CHECK(level.ps == longest);
  }
  CHECK(blocks > 5);
  // What no level names takes no time: wires, and what the pipelined form does without.
  for (const auto& [name, block] : measured.items()) {
    bool is_named = false;
    for (const specular::pipeline_level& level : pipelined_of(asked).levels()) {
      for (const auto& chain : level.chains) is_named |= std::ranges::count(chain, name) > 0;
    }
    CAPTURE(name);
    CHECK((is_named || name.starts_with("rg") || worst(name) == 0));
  }
}

TEST_CASE("cuts balance the stages") {
  const selection asked = test::asked_for();
  const std::vector<specular::pipeline_level> levels = pipelined_of(asked).levels();
  const std::vector<std::uint64_t> balanced = specular::balanced_cuts(levels);
  const int all = static_cast<int>(levels.size());
  REQUIRE(balanced.size() == levels.size());
  int longest_level = 0, sum = 0;
  for (const specular::pipeline_level& level : levels) {
    longest_level = std::max(longest_level, level.ps);
    sum += level.ps;
  }
  int before = sum;
  for (int stages = 1; stages <= all; ++stages) {
    const std::uint64_t cuts = balanced.at(static_cast<std::size_t>(stages) - 1);
    const int longest = specular::longest_stage(levels, cuts);
    CAPTURE(stages, cuts);
    CHECK(pipeline_cuts{cuts}.between(0, all - 1) == stages - 1);
    CHECK(longest <= before);
    CHECK(longest * stages >= sum);
    before = longest;
  }
  CHECK(before == longest_level);
  const int fewest = pipelined_of(asked).fewest_stages();
  CHECK(specular::longest_stage(levels, balanced.at(static_cast<std::size_t>(fewest) - 1)) == longest_level);
  CHECK(specular::longest_stage(levels, balanced.at(static_cast<std::size_t>(fewest) - 2)) > longest_level);
}

TEST_CASE("wrong stages and cuts are refused") {
  const selection asked = test::asked_for();
  const auto message = [&](const std::map<std::string, std::string>& options) -> std::string {
    try {
      choose(asked.of().name(), asked.format(), options);
    } catch (const std::invalid_argument& refusal) {
      return refusal.what();
    }
    return "";
  };
  const std::string levels = std::to_string(pipelined_of(asked).levels().size());
  CHECK(message({{"stages", levels}}).empty());
  CHECK(message({{"cuts", "1,3"}}).empty());
  for (const char* const wrong : {"0", "-1", "2.5", "x", "99"}) {
    CAPTURE(wrong);
    CHECK(test::is_line_with(message({{"stages", wrong}}),
                             fmt::format("--stages is {}, expected 1 to {}", wrong, levels)));
  }
  for (const std::string& wrong :
       std::vector<std::string>{"0", "3,1", "2,2", "1,", ",1", "1;2", levels, "x"}) {
    CAPTURE(wrong);
    CHECK(test::is_line_with(message({{"cuts", wrong}}), fmt::format("--cuts is {}, expected", wrong)));
  }
  CHECK(test::is_line_with(message({{"stages", "2"}, {"cuts", "1"}}), "exclude each other"));
}
