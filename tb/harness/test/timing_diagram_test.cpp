// SPDX-License-Identifier: Apache-2.0
// Timing diagrams of a waveform written by hand: what changes when, which edges have arrows.
#include "tb/harness/timing_diagram.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "tb/catch.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;

/// A file that vanishes with the test.
struct waveform {
  std::string path =
      (std::filesystem::temp_directory_path() / ("blysk timing " + std::to_string(getpid()) + ".vcd"));

  explicit waveform(const std::string& text) { std::ofstream(path) << text; }
  ~waveform() { std::filesystem::remove(path); }
};

/// cos is written by the trailing edge of its strobe; half a clock period is 5.
const std::vector<port> kPorts{
    {"clk", "", "clk", "", port::role::clock},
    {"rst_n", "", "rst_n", "", port::role::reset},
    {"c_i", "", "cos", "", port::role::data, false, wire_format{0, 3, true, -8, 7}, "c"},
    {"we_i", "", "strobe", "", port::role::strobe, false, {}, "", "c_i", write_edge::trailing},
    {"y_o", "", "out", "", port::role::result, false, wire_format{4, 0, true, -8, 7}, "y"},
    {"valid_o", "", "valid", "", port::role::valid}};

const std::string kHeader =
    "$comment\nblysk-device --device one\n$end\n$scope module SystemC $end\n$var wire 1 a clk $end\n"
    "$var wire 1 b rst_n $end\n$var wire 1 d strobe $end\n$var wire 4 e out [3:0] $end\n$var wire 1 f valid "
    "$end\n"
    "$scope module values $end\n$var real 1 g c_real $end\n$var real 1 h y_real $end\n$upscope "
    "$end\n$upscope $end\n"
    "$enddefinitions $end\n";

const std::string kWaves = kHeader +
                           "$dumpvars\n1a\n1b\n0d\nb0 e\n0f\nr0 g\nr0 h\n$end\n"
                           "#5\n0a\n1d\n1f\nr-0.125 g\n"
                           "#10\n1a\n"
                           "#15\n0a\n0d\n0f\n"
                           "#20\n1a\nb1111 e\nr-1 h\n"
                           "#25\n0a\n1d\n1f\n"
                           "#30\n1a\n";

}  // namespace

TEST_CASE("a timing diagram has every change and arrows from edges to what they do", "[harness][timing]") {
  const waveform file(kWaves);
  const harness::wave_changes waves(file.path);
  CHECK(waves.comment() == std::vector<std::string>{"blysk-device --device one"});
  CHECK(waves.at("SystemC.out", 19) == "0");
  CHECK(waves.at("SystemC.out", 20) == "1111");
  CHECK_THROWS_AS(waves.at("SystemC.other", 20), std::invalid_argument);

  harness::timing_diagram shown = harness::diagram_of(kPorts, waves, 5, 0, 7);
  shown.title = "a <title>";
  const auto json = nlohmann::json::parse(harness::wave_json(shown));
  const auto lane = [&](const std::string& name) {
    for (const auto& each : json["signal"]) {
      if (!each.empty() && each["name"] == name) return each;
    }
    throw std::logic_error("no lane " + name);
  };
  CHECK(lane("clk")["wave"] == "1010101");
  CHECK(lane("rst_n")["wave"] == "1......");
  CHECK(lane("strobe")["wave"] == "01.0.1.");
  CHECK(lane("cos")["wave"] == "==.....");
  CHECK(lane("cos")["data"] == nlohmann::json::array({"0", "-0.125"}));
  CHECK(lane("out")["wave"] == "=...=..");
  CHECK(lane("out")["data"] == nlohmann::json::array({"0", "-1"}));
  // 17's trailing edge at tick 3 loads at tick 4; 29's first leading edge confirms nothing, its second one does.
  const std::string loads = json["edge"][0];
  CHECK(loads.substr(4) == " loads");
  CHECK(lane("strobe")["node"].get<std::string>()[3] == loads[0]);
  CHECK(lane("out")["node"].get<std::string>()[4] == loads[3]);
  const std::string confirms = json["edge"][1];
  CHECK(confirms.substr(4) == " confirms");
  CHECK(lane("valid")["node"].get<std::string>()[5] == confirms[0]);
  CHECK(json["edge"].size() == 2);

  const std::string svg = harness::svg_text(shown);
  CHECK(svg.find("a &lt;title&gt;") != std::string::npos);
  std::size_t arrows = 0;
  for (auto at = svg.find("class=\"arrow\""); at != std::string::npos;
       at = svg.find("class=\"arrow\"", at + 1))
    ++arrows;
  CHECK(arrows == 2);
}

TEST_CASE("a waveform that is not whole is refused", "[harness][timing]") {
  const waveform no_end("$scope module SystemC $end\n");
  CHECK_THROWS_AS(harness::wave_changes(no_end.path), usage_error);
  const waveform no_scope("$upscope $end\n$enddefinitions $end\n");
  CHECK_THROWS_AS(harness::wave_changes(no_scope.path), usage_error);
  const waveform no_time(kHeader + "#x\n");
  CHECK_THROWS_AS(harness::wave_changes(no_time.path), usage_error);
  const waveform no_value(kHeader + "#5\n1a\n");
  const harness::wave_changes waves(no_value.path);
  CHECK_THROWS_AS(waves.at("SystemC.clk", 4), std::invalid_argument);
  CHECK_THROWS_AS(harness::diagram_of(kPorts, waves, 5, 0, 7), std::invalid_argument);
  CHECK_THROWS_AS(harness::diagram_of({kPorts.front()}, waves, 5, 0, 7), std::invalid_argument);
}
