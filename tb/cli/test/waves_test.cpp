// SPDX-License-Identifier: Apache-2.0
// The waves that `simulate --vcd` records: every wire carries what its name says, and the layout knows every name.
#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "tb/catch.h"
#include "tb/cli/test/program.h"
#include "tb/cli/test/waves.h"

// Formulas of q8 in raw units: cos has 8 fraction bits, a has 8, cos^2 - cos has 16, the parabola 24.
TEST_CASE("every wire of the waves carries what its name says", "[cli][waves]") {
  const scratch folder;
  const std::string vcd = folder.path("w.vcd");
  REQUIRE(run_blysk(folder, "simulate --format q8 --engine systemc --stimulus " +
                                quoted(BLYSK_ROOT "/docs/examples/fig3.csv") + " --results " +
                                quoted(folder.path("r.csv")) + " --vcd " + quoted(vcd))
              .status == 0);
  const waves seen(slurp(vcd));
  const std::map<std::string, std::string> level_strobes{
      {"rg1.q_o", "strobe15"}, {"rg3.q_o", "strobe20"}, {"rg4.q_o", "strobe22"}, {"rg5.q_o", "strobe24"}};
  const std::map<std::string, std::string> level_data{
      {"rg1.q_o", "n16"}, {"rg3.q_o", "red19"}, {"rg4.q_o", "green21"}, {"rg5.q_o", "blue23"}};
  std::map<std::string, int> writes;
  bool strobe17_before = false;
  REQUIRE(seen.values.size() > 40);
  for (std::size_t i = 0; i < seen.values.size(); ++i) {
    CAPTURE(i);
    const auto at = [&](const std::string& name) { return seen.value(i, name); };
    const auto signed_at = [&](const std::string& name) { return seen.value(i, name, true); };
    const long long n = at("rg1.q_o");
    const long long c = at("rg2.q_o");
    CHECK(at("valid29") == at("strobe17"));
    CHECK(at("node31.y_o") == 201);
    CHECK(signed_at("node32.y_o") == -1);
    CHECK(at("mul6.p_o") == 201 * n);
    if (n != 0) CHECK(at("add15.s_o") == 201 * n - 128);
    CHECK(at("mul7.p_o") == c * c);
    CHECK(signed_at("inv8.y_o") == -256 * c - 1);
    CHECK(signed_at("add9.s_o") == c * c - 256 * c);
    if (n != 0) {
      CHECK(signed_at("mul10.p_o") == (201 * n - 128) * (c * c - 256 * c));
      CHECK(signed_at("add11.s_o") == (201 * n - 128) * (c * c - 256 * c) + 65536 * c);
      const long long rounded = (signed_at("add11.s_o") + 32768) >> 16;
      CHECK(at("quant11.y_o") == std::max(0LL, std::min(256LL, rounded)));
    }
    for (const auto& [colour, out, number] :
         {std::tuple{"rg3.q_o", "out25_red", "mul12.p_o"}, std::tuple{"rg4.q_o", "out26_green", "mul13.p_o"},
          std::tuple{"rg5.q_o", "out27_blue", "mul14.p_o"}}) {
      CHECK(at(out) == at("quant11.y_o") * at(colour));
      CHECK(at(number) == at(out));
    }
    if (i == 0) continue;
    const auto before = [&](const std::string& name) { return seen.value(i - 1, name); };
    const bool rising = at("clk") == 1 && before("clk") == 0;
    for (const auto& [reg, strobe] : level_strobes) {
      const bool written = rising && before("rst_n") == 1 && before(strobe) == 1;
      CHECK(at(reg) == (written ? before(level_data.at(reg)) : before(reg)));
      writes[reg] += written ? 1 : 0;
    }
    if (rising) {
      const bool falls = strobe17_before && before("strobe17") == 0;
      CHECK(c == (falls ? before("cos18") : before("rg2.q_o")));
      writes["rg2.q_o"] += falls ? 1 : 0;
      strobe17_before = before("strobe17") == 1;
    } else {
      CHECK(c == before("rg2.q_o"));
    }
  }
  CHECK(writes["rg2.q_o"] >= 10);
  for (const auto& [reg, strobe] : level_strobes) CHECK(writes[reg] >= 1);
}

TEST_CASE("the layout of GTKWave fits the waves of every format", "[cli][waves]") {
  const auto fraction = GENERATE(8, 10, 12, 14, 16, 18, 20, 22, 24);
  const auto lobe = GENERATE(std::string(), std::string(" --as-published"));
  const scratch folder;
  const std::string vcd = folder.path("w.vcd");
  const std::string fitted = folder.path("fitted.gtkw");
  REQUIRE(run_blysk(folder, "simulate --format q" + std::to_string(fraction) + lobe +
                                " --engine systemc --stimulus " +
                                quoted(BLYSK_ROOT "/docs/examples/fig3.csv") + " --results " +
                                quoted(folder.path("r.csv")) + " --vcd " + quoted(vcd))
              .status == 0);
  REQUIRE(std::system(("'" BLYSK_LAYOUT "' --format q" + std::to_string(fraction) + lobe + " --output " +
                       quoted(fitted))
                          .c_str()) == 0);
  const waves seen(slurp(vcd));
  std::map<std::string, int> shifts;
  std::map<std::string, bool> are_signed;
  int rows = 0;
  int reals = 0;
  std::istringstream lines(slurp(fitted));
  std::string line;
  int shift = 0;
  unsigned long flags = 0;
  while (std::getline(lines, line)) {
    if (line.starts_with('@')) flags = std::stoul(line.substr(1), nullptr, 16);
    if (line.starts_with("[fpshift_count] ")) shift = std::stoi(line.substr(16));
    const auto start = line.find("SystemC.");
    if (line.starts_with('[') || start == std::string::npos) continue;
    const std::string row = line.substr(start + 8);
    const std::string name = row.substr(0, row.find('['));
    CAPTURE(fraction, lobe, line);
    REQUIRE(seen.widths.count(name) == 1);
    ++rows;
    if (name.starts_with("values.")) {
      ++reals;
      continue;
    }
    const int width = row.find('[') == std::string::npos ? 1 : std::stoi(row.substr(row.find('[') + 1)) + 1;
    CHECK(width == seen.widths.at(name));
    shifts[name] = shift;
    are_signed[name] = (flags & 0x400) != 0;
    shift = 0;
  }
  CHECK(rows > 30);
  CHECK(reals == 6);                         // cos, BRDF, three colours, error
  const int slope = std::min(fraction, 20);  // K and D of docs/devices
  const int square = std::min({2 * fraction, fraction + 12, 35});
  const std::map<std::string, int> expected{{"cos18", fraction},           {"rg2.q_o", fraction},
                                            {"node31.y_o", slope},         {"node32.y_o", 1},
                                            {"mul6.p_o", slope},           {"add15.s_o", slope},
                                            {"mul7.p_o", square},          {"inv8.y_o", square},
                                            {"add9.s_o", square},          {"mul10.p_o", slope + square},
                                            {"add11.s_o", slope + square}, {"quant11.y_o", fraction},
                                            {"out25_red", fraction},       {"out26_green", fraction},
                                            {"out27_blue", fraction}};
  for (const auto& [name, bits] : expected) {
    CAPTURE(fraction, lobe, name);
    CHECK(shifts[name] == bits);
  }
  // The outputs as published are signed, and drawn as such.
  for (const char* name : {"quant11.y_o", "out25_red", "out26_green", "out27_blue"}) {
    CAPTURE(fraction, lobe, name);
    CHECK(are_signed[name] == !lobe.empty());
  }
  CHECK(are_signed["add9.s_o"]);
  CHECK_FALSE(are_signed["cos18"]);
}

TEST_CASE("the waves of the exported Verilog are those of SystemC in every half period, a cycle earlier",
          "[cli][waves]") {
  const std::string format = GENERATE("q8", "q24");
  const scratch folder;
  const auto waves_of = [&](const std::string& engine) {
    const std::string vcd = folder.path(engine + ".vcd");
    REQUIRE(run_blysk(folder, "simulate --format " + format + " --engine " + engine + " --stimulus " +
                                  quoted(BLYSK_ROOT "/docs/examples/fig3.csv") + " --results " +
                                  quoted(folder.path("r.csv")) + " --vcd " + quoted(vcd))
                .status == 0);
    return waves(slurp(vcd));
  };
  const waves systemc = waves_of("systemc");
  const waves verilator = waves_of("verilator");
  // SystemC's host lets a cycle pass after the reset, and runs on for the half period in which its monitor reads.
  constexpr std::size_t kLater = 2;
  const std::size_t common = verilator.values.size();
  REQUIRE(common > 40);
  CHECK(systemc.values.size() == common + kLater);
  std::size_t compared = 0;
  for (const auto& [name, code] : systemc.codes) {
    if (name != "clk" && name.find('.') == std::string::npos) continue;
    CAPTURE(name);
    ++compared;
    for (std::size_t i = 0; i + 1 < common; ++i) {  // SystemC ends in the middle of the last one
      CAPTURE(i);
      if (name == "values.error_real") {  // SystemC writes ten digits more than it is rounded to
        REQUIRE(verilator.real(i, name) == Approx(systemc.real(i + kLater, name)).epsilon(1e-12));
      } else if (name.starts_with("values.")) {
        REQUIRE(verilator.values[i].at(verilator.codes.at(name)) == systemc.values[i + kLater].at(code));
      } else {
        REQUIRE(verilator.bits(i, name) == systemc.bits(i + kLater, name));
      }
    }
  }
  CHECK(compared > 15);
}

TEST_CASE("FST has the waves of VCD", "[cli][waves]") {
  if (std::system("command -v vcd2fst fst2vcd >/dev/null") != 0) {
    WARN("vcd2fst is not installed: not tried");
    return;
  }
  const scratch folder;
  const auto record = [&](const std::string& name) {
    REQUIRE(run_blysk(folder, "simulate --format q8 --engine systemc --stimulus " +
                                  quoted(BLYSK_ROOT "/docs/examples/fig3.csv") + " --results " +
                                  quoted(folder.path("r.csv")) + " --vcd " + quoted(folder.path(name)))
                .status == 0);
    return folder.path(name);
  };
  const waves direct(slurp(record("w.vcd")));
  REQUIRE(std::system(
              ("fst2vcd " + quoted(record("w.fst")) + " >" + quoted(folder.path("back.vcd"))).c_str()) == 0);
  const waves back(slurp(folder.path("back.vcd")));
  CHECK(folder.names().size() == 4);
  REQUIRE(back.values.size() == direct.values.size());
  REQUIRE(back.codes.size() == direct.codes.size());
  for (const auto& [name, code] : direct.codes) {
    CAPTURE(name);
    for (std::size_t i = 0; i < direct.values.size(); ++i) {
      if (name.starts_with("values.")) {
        REQUIRE(back.real(i, name) == direct.real(i, name));
      } else {
        REQUIRE(back.value(i, name) == direct.value(i, name));
      }
    }
  }
}
