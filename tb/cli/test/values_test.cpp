// SPDX-License-Identifier: Apache-2.0
// The real numbers in the waves: those that the wires stand for at every change, and the difference from the formula.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "tb/catch.h"
#include "tb/cli/test/program.h"
#include "tb/cli/test/waves.h"
#include "tb/device.h"
#include "tb/inputs.h"
#include "tb/wave_values.h"

namespace {

using namespace blysk;

/// Random rows of a device, as columns and as CSV.
struct stimulus {
  columns rows;
  std::string csv;

  stimulus(const selection& asked, std::uint64_t count) {
    const std::vector<port> data = of_role(asked.of().ports(asked), port::role::data);
    csv = column_names(data, port::role::data) + "\n";
    for_random_inputs(asked, count, 1, [&](const columns& made) { rows = made; });
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (std::size_t i = 0; i < data.size(); ++i) {
        const double value = std::ldexp(rows[i].real(row), -data[i].carries->frac);
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", value);
        if (i > 0) csv += ",";
        csv += text;
      }
      csv += "\n";
    }
  }
};

waves record(const selection& asked, const std::string& engine, const std::string& csv) {
  const scratch folder;
  const std::string vcd = folder.path("w.vcd");
  const outcome done =
      run_blysk(folder, "simulate --device " + asked.of().name() + " --format " + asked.format() +
                            " --engine " + engine + " --stimulus " + quoted(folder.write("in.csv", csv)) +
                            " --results " + quoted(folder.path("out.csv")) + " --vcd " + quoted(vcd));
  CAPTURE(done.err);
  REQUIRE(done.status == 0);
  return waves(slurp(vcd));
}

/// The BRDF is no port: in SystemC's waves it is what a block gives.
std::string signal_of(const port& what, const std::string& engine, const waves& seen) {
  const std::string& name = engine == "verilator" ? what.name : what.wave;
  return seen.codes.count(name) != 0 ? name : "";
}

}  // namespace

TEST_CASE("values are what the wires stand for, and the error is the device minus its formula",
          "[cli][values]") {
  const std::string engine = GENERATE("systemc", "verilator");
  const std::string format = GENERATE("q8", "q24");
  for (const device* each : devices()) {
    CAPTURE(each->name(), format, engine);
    const selection asked = choose(each->name(), format);
    const std::vector<port> ports = each->ports(asked);
    const stimulus given(asked, each->draws_lines() ? 3 : 40);
    const waves seen = record(asked, engine, given.csv);

    // A double has fewer digits in the file than it needs: the nearest code is the code.
    std::size_t compared = 0;
    for (const port& of : ports) {
      const std::string value = value_name(of);
      if (value.empty()) continue;
      REQUIRE(seen.codes.count("values." + value) == 1);
      const std::string signal = signal_of(of, engine, seen);
      if (signal.empty()) continue;
      ++compared;
      for (std::size_t i = 0; i < seen.values.size(); ++i) {
        CAPTURE(value, i);
        const double shown = seen.real(i, "values." + value);
        REQUIRE(std::llround(std::ldexp(shown, of.carries->frac)) ==
                seen.value(i, signal, of.carries->is_signed));
        REQUIRE(shown == Approx(std::ldexp(static_cast<double>(seen.value(i, signal, of.carries->is_signed)),
                                           -of.carries->frac))
                             .epsilon(1e-15));
      }
    }
    CHECK(compared >= 1);

    // The formula by itself, row after row, where the device confirms a row.
    columns expected;
    each->make_golden(asked)->run(given.rows, expected);
    const port& judged = ports[error_port(ports)];
    std::size_t column = 0;
    for (const port& of : of_role(ports, port::role::result)) {
      if (of.name == judged.name) break;
      ++column;
    }
    const bool has_strobes = protocol_of(ports) == protocol::strobes;
    const port& valid = ports[find_role(ports, port::role::valid)];
    const std::string valid_signal = engine == "verilator" ? valid.name : valid.wave;
    std::size_t rows = 0;
    std::size_t pulses = 0;
    for (std::size_t i = 1; i < seen.values.size(); ++i) {
      const bool is_up = seen.value(i, valid_signal) == 1;
      bool confirms;
      if (has_strobes) {  // the leading edge belongs to the write before
        confirms = is_up && seen.value(i - 1, valid_signal) == 0 && pulses++ > 0;
      } else {  // SystemC repeats the last half period as the end of its record
        confirms = is_up && seen.value(i, "clk") == 1 && i + 1 < seen.values.size();
        if (!is_up) REQUIRE(seen.real(i, "values.error_real") == 0);
      }
      if (!confirms) continue;
      CAPTURE(i, rows);
      REQUIRE(rows < expected.size());
      const double device = seen.real(i, "values." + value_name(judged));
      REQUIRE(seen.real(i, "values.error_real") == Approx(device - expected[column].real(rows))
                                                       .epsilon(1e-5)
                                                       .margin(1e-15 * std::max(1.0, std::abs(device))));
      ++rows;
    }
    CHECK(rows == expected.size());
  }
}

TEST_CASE("the layout beside an export shows every value of a recorded run", "[cli][values]") {
  const selection asked = choose(kDevice, "q12");
  const waves seen = record(asked, "verilator", stimulus(asked, 5).csv);
  const std::string layout =
      slurp(BLYSK_ROOT "/rtl_verilog/" + asked.folder_name() + "/" + asked.top_name() + ".gtkw");
  std::size_t rows = 0;
  for (const auto& [signal, code] : seen.codes) {
    if (!signal.starts_with("values.")) continue;
    CAPTURE(signal);
    ++rows;
    CHECK(layout.find("\nTOP." + signal + "\n") != std::string::npos);
  }
  CHECK(rows == 6);
}

TEST_CASE("markers of a layout stand where the first write ends, loads and is confirmed", "[cli][values]") {
  const std::string engine = GENERATE("systemc", "verilator");
  for (const device* each : devices()) {
    CAPTURE(each->name(), engine);
    const selection asked = choose(each->name(), "q12");
    const std::vector<port> ports = each->ports(asked);
    const scratch folder;
    const std::string made = folder.path("w.gtkw");
    REQUIRE(std::system((quoted(BLYSK_LAYOUT) + " --device " + each->name() + " --format q12 --output " +
                         quoted(made) + (engine == "verilator" ? " --verilog" : ""))
                            .c_str()) == 0);
    const std::string layout = slurp(made);
    std::istringstream line(layout.substr(layout.find("\n*") + 2));
    double zoom, marker;
    long long ends, loads, confirms;
    line >> zoom >> marker >> ends >> loads >> confirms;
    if (protocol_of(ports) != protocol::strobes) {
      CHECK((ends == -1 && loads == -1 && confirms == -1));
      continue;
    }
    const waves seen = record(asked, engine, stimulus(asked, 5).csv);
    const auto name_of = [&](const port& of) { return engine == "verilator" ? of.name : of.wave; };
    const auto steps = [&](const std::string& signal, long long at_ps, long long to) {
      const auto i = static_cast<std::size_t>(at_ps / 5000);  // a record for each half period
      return seen.value(i, signal) == to && seen.value(i - 1, signal) == 1 - to;
    };
    for (const port& strobe : of_role(ports, port::role::strobe)) {
      if (strobe.edge == write_edge::trailing) CHECK(steps(name_of(strobe), ends, 0));
    }
    CHECK(steps("clk", loads, 1));
    CHECK(seen.values[static_cast<std::size_t>(loads / 5000)] !=
          seen.values[static_cast<std::size_t>(loads / 5000) - 1]);
    CHECK(steps(name_of(ports[find_role(ports, port::role::valid)]), confirms, 1));
  }
}
