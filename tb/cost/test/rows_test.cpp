// SPDX-License-Identifier: Apache-2.0
// Rows of measured cost: read, refused, chosen from, put into pages.
#include <filesystem>
#include <fstream>

#include "tb/catch_text.h"
#include "tb/cost/annotated.h"
#include "tb/cost/certificate_row.h"
#include "tb/cost/digest.h"
#include "tb/cost/page.h"
#include "tb/cost/reports.h"
#include "tb/cost/table.h"

namespace {

using namespace blysk;
using namespace blysk::cost;

const std::string kDevice = devices().front()->name();

/// A row with a cost and one error on every domain.
configuration row_of(const std::string& format, std::int64_t lut, double mhz, double error) {
  configuration row{choose(kDevice, format)};
  row.cost = {kDevice, format,
              {},      ice40_cells{{}, lut, 1, 2, 0, 0},
              {},      placement{{}, "part", {1, 2, 3}, {mhz + 1, mhz, mhz + 2}},
              {}};
  row.errors.emplace();
  for (errors& each : *row.errors) {
    each.points = 10;
    each.max_abs_err = error;
    each.bias = -error / 2;
  }
  return row;
}

std::string label_of(const configuration* of) {
  return of == nullptr ? "none" : of->asked.format();
}

std::string chosen(const std::vector<configuration>& all, double tolerance, double mhz = 0) {
  const choice found = choose_cheapest(all, tolerance, find_metric("max_abs_err"), domain::lobe,
                                       find_technology("ice40"), mhz);
  return label_of(found.cheaper) + " < " + label_of(found.cheapest) + " < " + label_of(found.better);
}

}  // namespace

TEST_CASE("a row of cost is read as it was written", "[cost]") {
  cost_row row = row_of("q8", 100, 20, 0.1).cost;
  row.osu018 = standard_cells{{"sha256:1", {{"yosys", "Yosys 0"}}, "synth"}, 7, 123.4, 5.25};
  row.ice40_dsp = ice40_cells{{"sha256:2", {}, "x"}, 1, 2, 3, 4, 4096};
  const std::string text = stored_text(json_of(row));
  CHECK(stored_text(json_of(parse_cost_row("file", text))) == text);
}

TEST_CASE("a damaged row is refused in one line", "[cost]") {
  const std::string text = stored_text(json_of(row_of("q8", 100, 20, 0.1).cost));
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& message) {
    std::string damaged = text;
    const std::size_t at = damaged.find(from);
    REQUIRE(at != std::string::npos);
    damaged.replace(at, from.size(), to);
    CHECK_THROWS_WITH(parse_cost_row("file", damaged),
                      ContainsSubstring(message) && !ContainsSubstring("\n"));
  };
  refused("\"format\"", "\"fromat\"", "file: is damaged: a key is missing");
  refused("\"lut\": 100", "\"lut\": -100", "file: is damaged: lut is no count");
  refused("\"lut\": 100", "\"lut\": \"100\"", "file: is damaged");
  refused("\"lut\": 100", "\"lut\": 100.5", "lut is no count");
  refused("\"lut\": 100,\n", "\"lut\": 100\n", "file:10: is damaged, expected JSON");
  refused("20.0", "0.0", "not one clock above zero for each seed");
  refused("21.0,", "", "not one clock above zero for each seed");
  CHECK_THROWS_WITH(parse_cost_row("file", text.substr(0, text.size() / 2)),
                    ContainsSubstring("is damaged, expected JSON"));
  CHECK_THROWS_WITH(parse_cost_row("file", ""), ContainsSubstring("file:1: is damaged"));
  CHECK_THROWS_WITH(parse_cost_row("file", "[]"), ContainsSubstring("is damaged"));
}

TEST_CASE("a row of energy is read, and a damaged one refused in one line", "[cost]") {
  const std::string text =
      R"({"device": "d", "format": "q8", "options": {}, "digest": "sha256:1", "stimuli": {"sphere": {)"
      R"("with_delays": {"toggles": 40, "pj": 8}, "without": {"toggles": 10, "pj": 2.5},)"
      R"("blocks": {"mul": {"with_delays": {"toggles": 30, "pj": 6}, "without": {"toggles": 5, "pj": 1}}}}}})";
  const energy_row row = parse_energy_row("file", text);
  CHECK(row.stimuli.at("sphere").whole.with_delays.pj == 8);
  CHECK(row.stimuli.at("sphere").whole.without.toggles == 10);
  CHECK(row.stimuli.at("sphere").blocks.at("mul").with_delays.toggles == 30);
  for (const char* const key : {"digest", "with_delays", "toggles", "blocks"}) {
    std::string damaged = text;
    damaged.replace(damaged.find(key), 2, "??");
    CAPTURE(key);
    CHECK_THROWS_WITH(parse_energy_row("file", damaged),
                      ContainsSubstring("file: is damaged") && !ContainsSubstring("\n"));
  }
  CHECK_THROWS_WITH(parse_energy_row("file", "{"), ContainsSubstring("file"));
}

TEST_CASE("reports of the tools are read", "[cost]") {
  const ice40_cells cells = read_ice40_cells("stat", R"({"modules": {}, "design": {"num_cells_by_type": {
      "SB_CARRY": 125, "SB_DFFESR": 43, "SB_DFFSR": 1, "SB_LUT4": 1527, "SB_MAC16": 3, "SB_RAM40_4K": 5}}})");
  CHECK(cells.lut == 1527);
  CHECK(cells.carry == 125);
  CHECK(cells.ff == 44);
  CHECK(cells.dsp == 3);
  CHECK(cells.ram_bits == 20480);
  CHECK_THROWS_WITH(read_ice40_cells("stat", R"({"design": {"num_cells_by_type": {"SB_NEW": 1}}})"),
                    ContainsSubstring("cells SB_NEW"));
  CHECK_THROWS_WITH(read_ice40_cells("stat", "{}"), ContainsSubstring("stat: has no number of cells"));

  CHECK(read_fmax("report", R"({"fmax": {"clk": {"achieved": 24.25, "constraint": 100}}})") == 24.25);
  CHECK_THROWS_WITH(read_fmax("report", R"({"fmax": {}})"), ContainsSubstring("report: has no single clock"));

  const std::string stat =
      "   Number of cells:               4305\n   Chip area for module '\\top': 106709.000000\n";
  const std::string liberty = "cell (NAND2X1) {\narea : 24;\n";
  const standard_cells area = read_standard_cells("stat", stat, liberty);
  CHECK(area.cells == 4305);
  CHECK(area.area_nand2 == 4446.2);
  CHECK_THROWS_WITH(read_standard_cells("stat", stat, "cell (INV) {\n"),
                    ContainsSubstring("area of a NAND2X1"));
  CHECK_THROWS_WITH(read_standard_cells("stat", "", liberty), ContainsSubstring("stat: cannot be read"));

  CHECK(read_path_ns("path", "           986.8146   slack (MET)\n", 1000) == 13.185);
  CHECK(read_path_ns("path", "             -1.5   slack (VIOLATED)\n", 10) == 11.5);
  CHECK_THROWS_WITH(read_path_ns("path", "Error: netlist.v, 5 syntax error\n 9.0 slack (MET)\n", 10),
                    ContainsSubstring("an error of OpenSTA"));
  CHECK_THROWS_WITH(read_path_ns("path", "No paths found.\n", 10), ContainsSubstring("path: cannot be read"));
}

TEST_CASE("a placement has its least, median and most", "[cost]") {
  placement placed{{}, "part", {1, 2, 3, 4}, {3, 1, 4, 2}};
  CHECK(placed.least() == 1);
  CHECK(placed.median() == 2);
  CHECK(placed.most() == 4);
  placed.fmax_mhz.push_back(9);
  CHECK(placed.median() == 3);
}

TEST_CASE("what is cheapest within a tolerance, and its neighbours", "[cost]") {
  const std::vector<configuration> all{row_of("q8", 100, 40, 0.5), row_of("q10", 200, 30, 0.2),
                                       row_of("q12", 300, 20, 0.3), row_of("q14", 400, 10, 0.1)};
  CHECK(chosen(all, 1) == "none < q8 < q10");
  CHECK(chosen(all, 0.5) == "none < q8 < q10");
  CHECK(chosen(all, 0.3) == "q8 < q10 < q14");  // q12 costs more and is worse
  CHECK(chosen(all, 0.1) == "q10 < q14 < none");
  CHECK(chosen(all, 0.3, 15) == "q8 < q10 < none");   // q14 is too slow
  CHECK(chosen(all, 0.3, 35) == "q8 < none < none");  // and q10
  CHECK(chosen(all, 0.01) == "q14 < none < none");    // nothing is so good; the best of all
  CHECK(chosen({}, 0.01) == "none < none < none");
  std::vector<const configuration*> front =
      front_of(all, find_metric("max_abs_err"), domain::lobe, find_technology("ice40"));
  REQUIRE(front.size() == 3);
  CHECK(label_of(front[1]) == "q10");
  CHECK(label_of(front[2]) == "q14");
}

TEST_CASE("names that do not exist are refused with those that do", "[cost]") {
  CHECK_THROWS_WITH(find_metric("worst"),
                    ContainsSubstring("metric worst does not exist, expected max_abs_err, "));
  CHECK_THROWS_WITH(find_technology("ecp5"),
                    ContainsSubstring("target ecp5 does not exist, expected ice40, asic"));
  CHECK_THROWS_WITH(find_domain("all"),
                    ContainsSubstring("domain all does not exist, expected whole, lobe, "));
}

TEST_CASE("rows of JSON have the keys that programs read, and CSV the same", "[cost]") {
  const auto rows = json_rows({row_of("q8", 100, 40, 0.5)}, std::array{domain::whole, domain::sphere});
  REQUIRE(rows.size() == 2);
  for (const char* key : {"max_abs_err",
                          "mean_abs_err",
                          "bias",
                          "rms_err",
                          "error_probability",
                          "max_rel_err",
                          "nmse",
                          "domain",
                          "status",
                          "lut",
                          "carry",
                          "ff",
                          "dsp",
                          "ram_bits",
                          "fmax_mhz",
                          "area_nand2",
                          "path_ns",
                          "latency_cycles",
                          "energy_pj",
                          "tools",
                          "digest",
                          "command"}) {
    CAPTURE(key);
    CHECK(rows[0].contains(key));
  }
  CHECK(rows[1]["domain"] == "sphere");
  CHECK(rows[0]["bias"] == -0.25);
  CHECK(rows[0]["fmax_mhz"] == 41);
  CHECK(rows[0]["area_nand2"].is_null());
  const std::string csv = csv_of(rows);
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 3);
  const auto commas = std::count(csv.begin(), csv.begin() + static_cast<std::ptrdiff_t>(csv.find('\n')), ',');
  CHECK(std::count(csv.begin(), csv.end(), ',') == 3 * commas);
}

TEST_CASE("the page of HTML holds the rows and needs no other file", "[cost]") {
  auto rows = json_rows({row_of("q8", 100, 40, 0.5)}, std::array{domain::lobe});
  rows[0]["command"] = "</script><b>";
  const std::string page = html_page(rows, "rms_err");
  CHECK_THAT(page, ContainsSubstring("fill(\"error\", errors, \"rms_err\");"));
  CHECK_THAT(page, ContainsSubstring("\"max_abs_err\":0.5"));
  CHECK_THAT(page, !ContainsSubstring("</script><b>"));
  for (const char* outside : {"src=", "href=", "@import", "url(", "fetch("})
    CHECK_THAT(page, !ContainsSubstring(outside));
}

TEST_CASE("a page's generated blocks are made anew and nothing else", "[cost]") {
  const std::vector<configuration> all{row_of("q8", 100, 40, 0.5), row_of("q10", 200, 30, 0.2)};
  const std::string page =
      "# Title\n<!-- generated: front ice40 max_abs_err lobe -->\nold\n<!-- end of generated -->\nend\n";
  const std::string made = with_generated_blocks("page", page, all);
  CHECK_THAT(made, ContainsSubstring("| 0.2 | 200 | 30.0 |") && !ContainsSubstring("old") &&
                       Catch::StartsWith("# Title\n") && Catch::EndsWith("\nend\n"));
  CHECK(with_generated_blocks("page", made, all) == made);
  const auto refused = [&](const std::string& text, const std::string& message) {
    CHECK_THROWS_WITH(with_generated_blocks("page", text, all), ContainsSubstring(message));
  };
  refused("a\n<!-- generated: rows q8 -->\n", "page:2: begins a generated block");
  refused("<!-- end of generated -->\n", "page:1: ends a generated block");
  refused("<!-- generated: fronts -->\n<!-- end of generated -->\n", "page:1: block fronts is unknown");
  refused("<!-- generated: front ice40 -->\n<!-- end of generated -->\n",
          "page:1: block front has too few words");
  refused("<!-- generated: front ice40 x lobe -->\n<!-- end of generated -->\n",
          "page:1: metric x does not exist");
}

TEST_CASE("a paragraph has the figures that it says it quotes", "[cost]") {
  const std::vector<configuration> all{row_of("q8", 100, 40, 0.5), row_of("q10", 200, 30, 0.284)};
  const std::string device = all[0].asked.of().name();
  const std::string quoted = "<!-- figures: " + device + " q8 lut, " + device + " q10 max_abs_err lobe -->\n";
  const auto page = [&](const std::string& text) {
    return with_generated_blocks("page", quoted + text, all);
  };
  for (const char* text :
       {"It takes 100 LUT, and 0.28 is its error.\n", "An error of 0.284, 100\nLUT.\n\nMore: 7.\n"})
    CHECK(page(text) == quoted + text);
  const auto refused = [&](const std::string& text, const std::string& message) {
    CHECK_THROWS_WITH(with_generated_blocks("page", text, all), ContainsSubstring(message));
  };
  refused(quoted + "It takes 101 LUT, and 0.28 is its error.\n",
          "page:1: the paragraph does not have " + device + " q8 lut, expected 100");
  refused(quoted + "It takes 100 LUT, and 0.29 is its error.\n", "max_abs_err lobe, expected 0.284");
  refused(quoted + "It takes 1000 LUT, q100, 100x, 0.28.\n", "q8 lut, expected 100");
  refused(quoted + "None.\n\n100 LUT, 0.28\n", "q8 lut, expected 100");
  const std::string ratio = "<!-- figures: " + device + "/" + device + " q10 lut -->\n";
  CHECK(page("It takes 100 LUT, 0.28.\n\n" + ratio + "1.0 times\n").ends_with("1.0 times\n"));
  refused(ratio + "1.1 times\n", "expected 1");
  const std::vector<configuration> large{row_of("q8", 5649, 40, 0.5)};
  const std::string luts = "<!-- figures: " + device + " q8 lut -->\n";
  for (const char* text : {"5600\n", "5650\n", "5649\n", "5649.0\n"})
    CHECK_NOTHROW(with_generated_blocks("page", luts + text, large));
  for (const char* text : {"5700\n", "6000\n", "5640\n", "5650.0\n"})
    CHECK_THROWS(with_generated_blocks("page", luts + text, large));
  refused("<!-- figures: " + device + " q9 lut -->\n100\n", "q9 lut: was not measured");
  refused("<!-- figures: " + device + " q8 luts -->\n100\n", "is no number that was measured");
  refused("<!-- figures: " + device + " q8 -->\n100\n", "is no figure, expected DEVICE FORMAT COLUMN");
  refused("<!-- figures: " + device + " q8 rms nowhere -->\n100\n", "nowhere");
}

TEST_CASE("digests depend on the Verilog and on nothing else", "[cost]") {
  const std::string of_none = "sha256:e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
  CHECK(verilog_digest({}) == of_none);
  CHECK(verilog_digest({{"a.sdc", "x"}}) == of_none);
  // printf 'a.v\nmodule a; endmodule\n\0' | sha256sum
  CHECK(verilog_digest({{"a.v", "module a; endmodule\n"}, {"a.f", "a.v\n"}}) ==
        "sha256:9874892a9bbb63d562c023ded17947cab011b76ad6947be08684557e05e98914");
  CHECK(verilog_digest({{"a.v", "b"}}) != verilog_digest({{"a.v", "c"}}));
  CHECK(verilog_digest({{"a.v", "b"}}) != verilog_digest({{"b.v", "b"}}));
}

TEST_CASE("a row of other Verilog is stale", "[cost]") {
  configuration row = row_of("q8", 100, 40, 0.5);
  row.cost.hx8k.reset();
  const std::string today = exported_digests({row.asked}).front();
  REQUIRE(today.size() == 71);
  CHECK(exported_digests({row.asked, choose(kDevice, "q10"), row.asked})[2] == today);
  std::vector<configuration> all{row, row};
  all[0].cost.ice40->from.digest = today;
  all[1].cost.ice40->from.digest = "sha256:of another";
  look_for_stale(all);
  CHECK(!all[0].is_stale);
  CHECK(all[1].is_stale);
}

TEST_CASE("the head of an export leaves out what belongs to another Verilog", "[cost]") {
  const selection asked = choose(kDevice, "q8");
  const std::string today = exported_digests({asked}).front();
  const std::string head = head_of(asked, today);
  for (const char* const line :
       {"//   computes: ", "//   iCE40: ", "//   iCE40 HX8K: ", "//   OSU018: ", "//   settles: "})
    CHECK_THAT(head, ContainsSubstring(line));
  CHECK_THAT(head, ContainsSubstring("//   digest: " + today + "\n"));
  const std::string other = head_of(asked, "sha256:of another");
  for (const char* const line :
       {"//   iCE40: ", "//   iCE40 HX8K: ", "//   OSU018: ", "//   settles: ", "certificate: "})
    CHECK_THAT(other, !ContainsSubstring(line));
  CHECK_THAT(other, ContainsSubstring(
                        "options: certificate, iCE40, iCE40 with DSP, iCE40 HX8K, OSU018, settling\n"));
}

TEST_CASE("a damaged certificate is refused in one line", "[cost]") {
  const certificate row{
      .device = kDevice,
      .format = "q8",
      .digest = "sha256:1",
      .gappa = "1.4.1",
      .bound = 0.5,
      .seen = {.max_abs_err = 0.25, .n = 3, .cos = 0.5, .inputs = 7, .is_exhaustive = true}};
  const std::string text = stored_text(json_of(row));
  CHECK(stored_text(json_of(parse_certificate("file", text))) == text);
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string damaged = text;
    const std::size_t at = damaged.find(from);
    REQUIRE(at != std::string::npos);
    damaged.replace(at, from.size(), to);
    CHECK_THROWS_WITH(parse_certificate("file", damaged),
                      ContainsSubstring("file: is damaged") && !ContainsSubstring("\n"));
  };
  refused("\"bound\"", "\"bond\"");
  refused("0.5", "-0.5");
  refused("0.25", "0.0");
  refused("0.25", "0.75");
  refused("\"q8\"", "\"q9\"");
  refused("0.5", "\"0.5\"");
  CHECK_THROWS_WITH(with_certificates(BLYSK_TABLES, "page", "no place"),
                    ContainsSubstring("page: has no place"));
}

TEST_CASE("the wrapper connects every port once", "[cost]") {
  for (const device* each : devices()) {
    const selection asked = choose(each->name(), "q8");
    const std::string text = serial_wrapper(asked, "bench");
    CAPTURE(text);
    for (const port& of : each->ports(asked)) {
      if (of.is_inner) continue;
      const std::size_t at = text.find("." + of.name + "(");
      REQUIRE(at != std::string::npos);
      CHECK(text.find("." + of.name + "(", at + 1) == std::string::npos);
    }
  }
}

TEST_CASE("the rows in docs/tables are whole", "[cost]") {
  const std::vector<configuration> from_folder = read_measured(BLYSK_TABLES);
  CHECK(!from_folder.empty());
  const std::vector<configuration> embedded = read_measured("");
  CHECK(json_rows(embedded, std::array{domain::lobe}) == json_rows(from_folder, std::array{domain::lobe}));
}
