// SPDX-License-Identifier: Apache-2.0
// `simulate --engine timed`, `settle` and `--vcd-deltas`, as a user calls them.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tb/catch_text.h"
#include "tb/cli/test/program.h"

namespace {

using json = nlohmann::ordered_json;

/// The times at which wires of a VCD file change, ps, by their names with scope.
std::map<std::string, std::vector<long long>> changes_of(const std::string& vcd) {
  std::map<std::string, std::string> names;
  std::map<std::string, std::vector<long long>> changes;
  std::istringstream lines(vcd);
  std::string line, scope;
  long long now = 0;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string first, second;
    words >> first >> second;
    if (first == "$scope") {
      std::string name;
      words >> name;
      scope = name == "SystemC" ? "" : name + ".";
    } else if (first == "$upscope") {
      scope.clear();
    } else if (first == "$var") {
      std::string width, code, name;
      words >> width >> code >> name;
      names[code] = scope + name;
    } else if (first.starts_with('#')) {
      now = std::stoll(first.substr(1));
    } else if (first.starts_with('b')) {
      changes[names[second]].push_back(now);
    } else if (first.starts_with('0') || first.starts_with('1')) {
      changes[names[first.substr(1)]].push_back(now);
    }
  }
  return changes;
}

/// The last change from `start` on and before `end`; 0 if there is none.
long long last_in(const std::vector<long long>& changes, long long start, long long end) {
  long long last = 0;
  for (const long long at : changes) {
    if (at >= start && at < end) last = at;
  }
  return last;
}

const std::string kStimulus = "n,cos,r,g,b\n10,0.5,1,2,3\n500,0.999,255,254,253\n";

}  // namespace

TEST_CASE("with time enough the delays change no result", "[timed]") {
  const std::string format = GENERATE(std::string("q8"), std::string("q12"));
  const scratch folder;
  const std::string of = "simulate --format " + format + " --stimulus " +
                         quoted(BLYSK_ROOT "/docs/examples/fig3.csv") + " --results ";
  REQUIRE(run_blysk(folder, of + quoted(folder.path("bit.csv"))).status == 0);
  const outcome timed =
      run_blysk(folder, of + quoted(folder.path("timed.csv")) + " --engine timed --json --settling " +
                            quoted(folder.path("settling.csv")));
  CAPTURE(timed.err);
  REQUIRE(timed.status == 0);
  CHECK(slurp(folder.path("timed.csv")) == slurp(folder.path("bit.csv")));
  const json told = json::parse(timed.out);
  CHECK(told["early"] == 0);
  CHECK(told["settled_ns"].get<double>() > 1);
  CHECK(told["settled_ns"] <= told["busy_ns"]);
  CHECK(told["busy_ns"] <= told["bound_ns"]);
  CHECK(told["bound_ns"].get<double>() <= told["period_ns"].get<double>() / 2);
  CHECK(told["simulated_ns"] == told["cycles"].get<double>() * told["period_ns"].get<double>());
  const std::string rows = slurp(folder.path("settling.csv"));
  CHECK(rows.starts_with("row,settled_ns,busy_ns\n1,"));
  CHECK(std::count(rows.begin(), rows.end(), '\n') == 1 + told["rows"].get<int>());
}

TEST_CASE("the waves show the blocks settle one after the other, and valid after them", "[timed][waves]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kStimulus);
  REQUIRE(run_blysk(folder, "simulate --format q8 --engine timed --period 40 --stimulus " + quoted(in) +
                                " --results " + quoted(folder.path("r.csv")) + " --vcd " +
                                quoted(folder.path("w.vcd")))
              .status == 0);
  const auto changes = changes_of(slurp(folder.path("w.vcd")));
  // Reset 80 ns; the second write's strobe goes up at 180 ns, down at 220 ns, the clock loads at 240 ns.
  const long long loaded = 240000;
  const auto at = [&](const std::string& name) { return last_in(changes.at(name), loaded, loaded + 20000); };
  const long long valid = last_in(changes.at("valid29"), loaded, loaded + 20001);
  CHECK(valid == loaded + 20000);
  CHECK(at("rg2.q_o") > loaded);
  CHECK(at("rg2.q_o") < loaded + 1000);
  const std::vector<std::string> chain{"rg2.q_o",   "mul7.p_o",    "add9.s_o", "mul10.p_o",
                                       "add11.s_o", "quant11.y_o", "mul12.p_o"};
  for (std::size_t i = 1; i < chain.size(); ++i) {
    CAPTURE(chain[i - 1], chain[i], at(chain[i - 1]), at(chain[i]));
    CHECK(at(chain[i]) > at(chain[i - 1]));
  }
  CHECK(at("inv8.y_o") > at("rg2.q_o"));
  for (const char* output : {"out25_red", "out26_green", "out27_blue"}) {
    CAPTURE(output);
    CHECK(at(output) > at("quant11.y_o"));
    CHECK(at(output) < valid);
  }
}

TEST_CASE("a strobe that comes too early is reported with time, signal and values", "[timed]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kStimulus);
  const std::string of = "simulate --format q8 --engine timed --stimulus " + quoted(in) + " --results " +
                         quoted(folder.path("r.csv")) + " --period ";
  const std::string settling = folder.path("s.csv");
  const outcome early = run_blysk(folder, of + "4 --json --settling " + quoted(settling));
  CHECK(early.status == 1);
  // Two cycles of reset, two a write; strobes come at the falling edges.
  CHECK_THAT(early.err,
             ContainsSubstring(
                 "blysk: row 2: the strobe at 26.000 ns comes too early: out25_red carries the code "));
  CHECK_THAT(early.err, ContainsSubstring(", expected 65280\n"));
  const json told = json::parse(early.out);
  CHECK(told["early"].get<int>() > 0);
  CHECK(told["early_strobes"][0]["row"] == 2);
  CHECK(told["early_strobes"][0]["time_ns"] == 26.0);
  CHECK(told["early_strobes"][0]["got"] != told["early_strobes"][0]["expected"]);
  // The strobe cuts the second row short, so when it settles is not known; the first one's outputs stay 0.
  const std::string rows = slurp(settling);
  CHECK(rows.starts_with("row,settled_ns,busy_ns\n1,"));
  CHECK_THAT(rows, ContainsSubstring("\n2,,"));
  CHECK(told["settled_ns"].get<double>() < 4);
  const std::string one = folder.write("in.csv", kStimulus.substr(0, 12) + "500,0.999,255,254,253\n");
  const outcome none = run_blysk(folder, of + "4 --json");
  CHECK(json::parse(none.out)["settled_ns"].is_null());
  folder.write("in.csv", kStimulus);
  CHECK(run_blysk(folder, of + "40").status == 0);
}

TEST_CASE("settle finds a gap that is right, and wrong one step below", "[timed][settle]") {
  const scratch folder;
  const outcome done = run_blysk(folder, "settle --format q8 --pairs 600 --json");
  CAPTURE(done.err);
  REQUIRE(done.status == 0);
  const json told = json::parse(done.out);
  CHECK(told["pairs_tried"].get<int>() >= 590);
  CHECK(told["pairs_tried"].get<int>() <= 600);
  CHECK(told["smallest_gap_ns"] == told["seen_ns"]);
  CHECK(told["seen_ns"] <= told["bound_ns"]);
  CHECK(told["path_ns"] <= told["bound_ns"]);
  CHECK(told["bound_ns"] < told["one_delay_a_block_ns"]);
  CHECK(told["seen_ns"].get<double>() > 0.5 * told["path_ns"].get<double>());
  CHECK(told["one_step_below"]["got"] != told["one_step_below"]["expected"]);

  // The same pair by the strobes of simulate: right at twice the gap as period, wrong 2 ps below, the same value.
  const json& worst = told["worst"];
  std::string csv = "n,cos,r,g,b\n";
  for (const char* row : {"before", "after"}) {
    const json& codes = worst[row];
    csv += std::to_string(codes["n"].get<int>()) + "," + std::to_string(codes["cos"].get<int>() / 256.0) +
           "," + std::to_string(codes["r"].get<int>()) + "," + std::to_string(codes["g"].get<int>()) + "," +
           std::to_string(codes["b"].get<int>()) + "\n";
  }
  const std::string in = folder.write("in.csv", csv);
  // The write before the first one of the pair leaves registers at 0, which may settle later: it is the first row's affair.
  const auto simulate = [&](double period) {
    return run_blysk(folder, "simulate --format q8 --engine timed --json --stimulus " + quoted(in) +
                                 " --results " + quoted(folder.path("r.csv")) + " --period " +
                                 std::to_string(period));
  };
  const double period = told["smallest_period_ns"];
  const auto second_row = [](const outcome& of) {
    const json all = json::parse(of.out)["early_strobes"];
    for (const json& each : all) {
      if (each["row"] == 2) return each;
    }
    return json();
  };
  CHECK(second_row(simulate(period)).is_null());
  CHECK_FALSE(second_row(simulate(period - 0.002)).is_null());
  CHECK_THAT(run_blysk(folder, "settle --format q8 --pairs 60").out, ContainsSubstring("smallest gap ") &&
                                                                         ContainsSubstring("bound ") &&
                                                                         ContainsSubstring(" is wrong\n"));
}

TEST_CASE("delta cycles show the order of settling without any delay", "[timed][waves]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kStimulus);
  const std::string of = "simulate --format q8 --engine systemc --stimulus " + quoted(in) + " --results " +
                         quoted(folder.path("r.csv")) + " --vcd " + quoted(folder.path("w.vcd"));
  REQUIRE(run_blysk(folder, of).status == 0);
  const auto flat = changes_of(slurp(folder.path("w.vcd")));
  REQUIRE(run_blysk(folder, of + " --vcd-deltas").status == 0);
  const auto steps = changes_of(slurp(folder.path("w.vcd")));
  const long long loaded = 60000;  // of the second write
  const std::vector<std::string> chain{"rg2.q_o",   "mul7.p_o",    "add9.s_o", "mul10.p_o",
                                       "add11.s_o", "quant11.y_o", "mul12.p_o"};
  for (std::size_t i = 1; i < chain.size(); ++i) {
    CAPTURE(chain[i]);
    CHECK(last_in(flat.at(chain[i]), loaded, loaded + 1000) == loaded);
    CHECK(last_in(steps.at(chain[i]), loaded, loaded + 1000) >
          last_in(steps.at(chain[i - 1]), loaded, loaded + 1000));
  }
}

TEST_CASE("what the engine timed cannot do is said in a line", "[timed]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kStimulus);
  const auto fails = [&](const std::string& arguments, const std::string& why) {
    const outcome of = run_blysk(folder, arguments);
    CAPTURE(arguments, of.err);
    CHECK(of.status == 2);
    CHECK_THAT(of.err, ContainsSubstring(why));
    CHECK(std::count(of.err.begin(), of.err.end(), '\n') == 1);
    CHECK_FALSE(fs::exists(folder.path("r.csv")));
  };
  const std::string of =
      "simulate --format q8 --stimulus " + quoted(in) + " --results " + quoted(folder.path("r.csv"));
  for (const char* period : {"0", "0.001", "-5", "0.003", "nan", "inf", "1e9"})
    fails(of + " --engine timed --period=" + period, "expected a multiple of 0.002 up to");
  fails(of + " --period 5", "--period is about delays and engine bit has none, expected engine timed");
  fails(of + " --engine systemc --delays x.json", "--delays is about delays and engine systemc has none");
  fails(of + " --settling " + quoted(folder.path("s.csv")), "--settling is about delays");
  fails(of + " --engine timed --vcd-deltas --vcd " + quoted(folder.path("w.vcd")),
        "--vcd-deltas shows SystemC's delta cycles and engine timed has delays in their place");
  fails(of + " --engine systemc --vcd-deltas", "--vcd-deltas is about the waves of --vcd");
  fails(of + " --engine timed --delays " + quoted(folder.path("none.json")), "none.json: cannot be read");
  fails(of + " --engine timed --delays " + quoted(folder.path("")), ": cannot be read (Is a directory)");
  fails("settle --format q8 --delays " + quoted(folder.path("")), ": cannot be read (Is a directory)");
  fails(of + " --engine nosuch", "expected golden, bit, systemc, verilator, timed");

  // Delays of another Verilog.
  const std::string delays = slurp(BLYSK_ROOT "/docs/tables/" BLYSK_DEVICE_IDENTIFIER "/delays_q8.json");
  std::string other = delays;
  const std::size_t at = other.find("sha256:") + 7;
  other[at] = other[at] == '0' ? '1' : '0';
  const std::string given = " --delays " + quoted(folder.write("d.json", other));
  fails(of + " --engine timed" + given, "d.json: belongs to another Verilog (sha256:");
  fails("settle --format q8" + given, "d.json: belongs to another Verilog (sha256:");
  fails("settle --format q12 --delays " + quoted(folder.write("e.json", delays)), "expected those of device");
  fails("settle --format q8 --pairs 1", "--pairs: is '1', expected a whole number from 10 to 1000000000");
  fails("settle --format q24 --as-published", "were not measured");
}
