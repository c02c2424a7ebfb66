// SPDX-License-Identifier: Apache-2.0
// blysk explore, as its user calls it.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tb/catch_text.h"
#include "tb/cli/test/program.h"

namespace {

using json = nlohmann::ordered_json;

/// Rows of the first device in a folder: cost and one error on each domain.
void write_row(const scratch& folder, const std::string& format, int lut, double area, double error) {
  const json from{{"digest", "sha256:0"}, {"tools", {{"yosys", "Yosys 1"}}}, {"script", "synth"}};
  json cost{{"device", kDevice}, {"format", format}, {"options", json::object()}};
  cost["ice40"] = from;
  for (const char* key : {"carry", "ff", "dsp", "ram_bits"}) cost["ice40"][key] = 0;
  cost["ice40"]["lut"] = lut;
  cost["hx8k"] = from;
  cost["hx8k"].update({{"part", "x"}, {"seeds", {1, 2}}, {"fmax_mhz", {50.0, 4e4 / lut}}});
  cost["osu018"] = from;
  cost["osu018"].update({{"cells", 1}, {"area_nand2", area}, {"path_ns", 10.0}});
  json errors{{"device", kDevice}, {"format", format}, {"options", json::object()}};
  for (const char* domain : {"whole", "lobe", "epicentre", "epicentre-0.60", "epicentre-0.56",
                             "epicentre-inflection", "sphere", "teapot"}) {
    json& of = errors["domains"][domain];
    of = {{"status", "exhaustive"}, {"points", 10},         {"max_abs_n", 1},
          {"relative_points", 9},   {"ulps", {1, 2, 3, 4}}, {"falls", 0}};
    for (const char* key : {"max_abs_err", "max_abs_cos", "mean_abs_err", "bias", "rms_err",
                            "error_probability", "max_rel_err", "mean_rel_err", "nmse"})
      of[key] = error;
    of["max_step"] = 3;
  }
  fs::create_directories(folder.path("rows"));
  folder.write("rows/cost_" + format + ".json", cost.dump(2));
  folder.write("rows/errors_" + format + ".json", errors.dump(2));
}

std::string rows_in(const scratch& folder) {
  return " --measured " + quoted(folder.path("rows"));
}

}  // namespace

TEST_CASE("explore answers from the rows that it was built with, at once", "[explore]") {
  const scratch folder;
  const outcome table = run_blysk(folder, "explore");
  CHECK(table.status == 0);
  CHECK_THAT(table.out, ContainsSubstring("max_abs_err, lobe"));
  const outcome all = run_blysk(folder, "explore --json");
  REQUIRE(all.status == 0);
  const json rows = json::parse(all.out);
  REQUIRE(rows.is_array());
  for (const json& row : rows) {
    CHECK(row.contains("domain"));
    CHECK(row["command"].get<std::string>().find("scripts/synth " + row["device"].get<std::string>()) == 0);
  }
}

TEST_CASE("explore finds what is cheapest within a tolerance", "[explore]") {
  const scratch folder;
  write_row(folder, "q8", 1000, 4000, 0.5);
  write_row(folder, "q12", 2000, 3000, 0.1);
  const std::string from = "explore --domain lobe" + rows_in(folder);
  const outcome found = run_blysk(folder, from + " --tolerance 0.5 --metric rms_err --target ice40 --json");
  CAPTURE(found.err);
  REQUIRE(found.status == 0);
  const json chosen = json::parse(found.out);
  CHECK(chosen["cheapest"]["format"] == "q8");
  REQUIRE(chosen["neighbours"].size() == 1);
  CHECK(chosen["neighbours"][0]["format"] == "q12");
  CHECK(chosen["neighbours"][0]["side"] == "better");
  CHECK(chosen["cheapest"]["is_stale"] == true);  // no Verilog has this digest
  CHECK(json::parse(
            run_blysk(folder, from + " --tolerance 0.5 --target asic --json").out)["cheapest"]["format"] ==
        "q12");

  const outcome text = run_blysk(folder, from + " --tolerance 5e-1 --target asic --clock 100MHz");
  CHECK(text.status == 0);
  CHECK_THAT(text.out,
             ContainsSubstring("cheapest   " + kDevice + " q12: max_abs_err 0.1, 3000 NAND2") &&
                 ContainsSubstring("scripts/synth " + kDevice + " q12 && build/bin/blysk explore --measure"));
  CHECK(run_blysk(folder, from + " --tolerance 0.5 --clock 41MHz --json").status ==
        1);  // q8 has a seed with 40
  const outcome none = run_blysk(folder, from + " --tolerance 0.01");
  CHECK(none.status == 1);
  CHECK_THAT(none.out,
             ContainsSubstring("none: no configuration whose cost was measured has max_abs_err <= 0.01") &&
                 ContainsSubstring("nearest"));
  CHECK_THAT(
      run_blysk(folder, from + " --tolerance 0.5 --clock 9999MHz").out,
      ContainsSubstring("none: no configuration whose cost was measured has max_abs_err <= 0.5 at 9999 MHz"));
  // What would do, but has no cost, is not passed over.
  write_row(folder, "q14", 1, 1, 0.001);
  fs::remove(folder.path("rows/cost_q14.json"));
  const outcome unpriced = run_blysk(folder, from + " --tolerance 0.01");
  CHECK(unpriced.status == 1);
  CHECK_THAT(unpriced.out,
             ContainsSubstring("no cost    one more is within the tolerance, such as " + kDevice + " q14"));
  const outcome bare = run_blysk(folder, from + " --tolerance 0.01 --format q14");
  CHECK(bare.status == 1);
  CHECK_THAT(bare.out,
             ContainsSubstring("none: no configuration of these has an error in lobe and a cost in "));
  CHECK(json::parse(
            run_blysk(folder, from + " --tolerance 0.01 --json").out)["within_tolerance_without_cost"] ==
        json{kDevice + " q14"});
}

TEST_CASE("explore prints tables, CSV and a page", "[explore]") {
  const scratch folder;
  write_row(folder, "q8", 1000, 4000, 0.5);
  const std::string from = "explore" + rows_in(folder);
  const outcome table = run_blysk(folder, from);
  CHECK_THAT(table.out, ContainsSubstring("0.5  1000") && ContainsSubstring("stale"));
  CHECK_THAT(table.err, ContainsSubstring("blysk: 1 rows are stale"));
  CHECK_THAT(run_blysk(folder, from + " --markdown").out,
             ContainsSubstring("| " + kDevice + " q8 | 0.5 | 1000 |"));
  const std::string csv = run_blysk(folder, from + " --csv --domain sphere").out;
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 2);
  CHECK(run_blysk(folder, from + " --html " + quoted(folder.path("page.html"))).status == 0);
  CHECK_THAT(slurp(folder.path("page.html")),
             ContainsSubstring("\"lut\":1000") && ContainsSubstring("</html>"));
}

TEST_CASE("explore says that nothing was measured, in place of a table without rows", "[explore]") {
  const scratch folder;
  write_row(folder, "q8", 1000, 4000, 0.5);
  const outcome none = run_blysk(folder, "explore --format q24" + rows_in(folder));
  CHECK(none.status == 0);
  CHECK(none.out.empty());
  CHECK(none.err.starts_with("blysk: no measured configuration is of this device"));
}

TEST_CASE("each command that explore prints is one that runs, up to its measurements", "[explore]") {
  const scratch folder;
  const json rows = json::parse(run_blysk(folder, "explore --json --domain whole").out);
  const json listed = json::parse(run_blysk(folder, "list --json").out);
  REQUIRE(rows.size() > 20);
  int listed_rows = 0;
  for (const json& row : rows) {
    const auto command = row["command"].get<std::string>();
    CAPTURE(command);
    const auto begin = command.find("explore --measure");
    if (begin == std::string::npos) {
      CHECK(row["max_abs_err"].is_null());
      continue;
    }
    // A word length that no device has stands where the measurement would begin.
    const outcome run = run_blysk(folder, command.substr(begin) + " --shard 0/1");
    CHECK(run.status == 2);
    CHECK_THAT(run.err, ContainsSubstring("--shard is 0/1, expected one of so many"));
    // What is listed of a device in its own form is what explore says of that form; a digit of a quotient each cycle takes
    // a cycle more for each bit.
    if (!row["options"].empty()) continue;
    const auto name = row["device"].get<std::string>();
    if (name.ends_with("-iterative")) {
      CHECK(row["latency_cycles"] == std::stoi(row["format"].get<std::string>().substr(1)) + 3);
      continue;
    }
    for (const json& device : listed["devices"]) {
      if (device["name"] != name) continue;
      ++listed_rows;
      CHECK(device["latency_cycles"] == row["latency_cycles"]);
    }
  }
  CHECK(listed_rows > 10);
}

TEST_CASE("options in other words choose the same rows", "[explore]") {
  const scratch folder;
  const auto rows = [&](const std::string& arguments) {
    const outcome run = run_blysk(folder, "explore --json --domain whole " + arguments);
    CAPTURE(arguments, run.err);
    REQUIRE(run.status == 0);
    return json::parse(run.out);
  };
  const json all = json::parse(run_blysk(folder, "list --json").out);
  std::size_t found = 0;
  for (const json& device : all["devices"]) {
    for (const auto& [alias, options] : device["aliases"].items()) {
      CAPTURE(alias);
      std::string words = "--device " + device["name"].get<std::string>();
      for (const auto& [name, value] : options.items())
        words += " --" + name + " " + value.get<std::string>();
      CHECK(rows("--device " + alias) == rows(words));
    }
    // "2.0" is 2.
    for (const json& option : device["options"]) {
      if (option["name"] != "stages") continue;
      const std::string name = device["name"];
      CHECK(rows("--device " + name + " --stages 2.0") == rows("--device " + name + " --stages 2"));
      // A list of cuts is one way to build the device, and some lists are those of a number of stages.
      for (const char* cuts : {"1", "2", "3", "1,2", "2,3", "2,4", "2,3,5", "1,2,3,4,5"}) {
        const json chosen = rows("--device " + name + " --cuts " + cuts);
        CAPTURE(name, cuts, chosen);
        found += chosen.size();
        for (const json& row : chosen) CHECK(row["options"] == chosen[0]["options"]);
      }
    }
  }
  CHECK(found > 0);
}

TEST_CASE("explore refuses bad use and bad files in one line", "[explore]") {
  const scratch folder;
  write_row(folder, "q8", 1000, 4000, 0.5);
  const std::string row = slurp(folder.path("rows/cost_q8.json"));
  const auto fails = [&](const std::string& arguments, const std::string& message) {
    const outcome failed = run_blysk(folder, "explore " + arguments);
    CAPTURE(arguments, failed.out, failed.err);
    CHECK(failed.status == 2);
    CHECK(failed.out.empty());
    CHECK(failed.err.starts_with("blysk: "));
    CHECK_THAT(failed.err, ContainsSubstring(message));
    CHECK(std::count(failed.err.begin(), failed.err.end(), '\n') == 1);
  };
  for (const char* tolerance : {"0", "nan", "-1", "inf", "x"})
    fails("--tolerance " + std::string(tolerance), "expected a finite number above zero");
  fails("--tolerance ''", "--tolerance is '', expected a value");
  fails("--html ''", "--html is '', expected a value");
  for (const char* form : {"--csv", "--json", "--cos 4 --csv", "merge a b --output c --json"})
    fails(std::string(form) + " --metric bias", "--metric chooses one error, and --json and --csv have all");
  fails("--tolerance 1 --metric worst", "metric worst does not exist, expected max_abs_err");
  fails("--tolerance 1 --target ecp5", "target ecp5 does not exist");
  fails("--tolerance 1 --domain all", "domain all does not exist");
  fails("--tolerance 1 --clock 50kHz", "--clock is 50kHz, expected a finite number above zero such as 50MHz");
  fails("--metric worst", "metric worst does not exist");
  fails("--clock 50MHz", "expected --tolerance with it");
  fails("--device nothing", "device nothing does not exist");
  fails("--format q9", "format q9 does not exist");
  fails("--json --csv", "see blysk explore --help");
  for (const char* form : {"--csv", "--markdown", "--html x.html"})
    fails(std::string("--tolerance 0.1 ") + form,
          "is no form of what is cheapest, expected a text or --json");
  fails("--target asic", "--target is a condition on what is cheapest, expected --tolerance with it");
  fails("--target nonsense", "target nonsense does not exist");
  fails("--jobs 2", "--jobs is of a sweep, expected ranges of word lengths");
  fails("--jobs 0x2", "--jobs: is '0x2', expected a whole number from 1 to 1024");
  fails("merge a b --output c --target asic", "--target says nothing to merge");
  fails("merge a b --output c --device " + kDevice, "--device says nothing to merge");
  fails("--shard 1/2", "expected ranges of word lengths");
  fails("--cos 8 --shard 3/2", "--shard is 3/2");
  fails("--cos 12..8", "--cos is 12..8");
  for (const char* list : {"8,9", "8-9", "x"})
    fails("--cos " + std::string(list), "expected bits such as 12 or a range such as 8..12");
  fails("--cos 8 --output -", "--output is -, expected a directory");
  fails("merge a b --output -", "--output is -, expected a directory");
  fs::create_symlink("loop2", folder.path("loop1"));
  fs::create_symlink("loop1", folder.path("loop2"));
  for (const char* each : {"--measured ", "merge --output x "})
    fails(each + quoted(folder.path("loop1")),
          ": cannot be read (Too many levels of symbolic links), expected ");
  folder.write("rows/cost_copy.json", row);
  fails(rows_in(folder), "cost_copy.json: is a row of another name, expected cost_q8.json");
  fs::remove(folder.path("rows/cost_copy.json"));
  fs::create_directory(folder.path("rows/more"));
  folder.write("rows/more/cost_q8.json", row);
  fails(rows_in(folder), "cost_q8.json: is one more cost row of device ");
  fs::remove_all(folder.path("rows/more"));
  std::string misspelt = row;
  misspelt.replace(misspelt.find("\"ice40\""), 7, "\"ice4\"");
  folder.write("rows/cost_q8.json", misspelt);
  fails(rows_in(folder), "cost_q8.json: is damaged: 'ice4' is no part of it");
  folder.write("rows/cost_q8.json", row);
  const std::string errors = slurp(folder.path("rows/errors_q8.json"));
  for (const auto& [key, value] : std::vector<std::pair<std::string, std::string>>{{"max_abs_n", "99999"},
                                                                                   {"max_abs_cos", "1.5"},
                                                                                   {"error_probability", "5"},
                                                                                   {"bias", "-7"},
                                                                                   {"max_abs_err", "1e-9"},
                                                                                   {"mean_rel_err", "1e9"}}) {
    std::string changed = errors;
    const std::size_t at = changed.find("\"" + key + "\": ") + key.size() + 4;
    changed.replace(at, changed.find_first_of(",\n", at) - at, value);
    folder.write("rows/errors_q8.json", changed);
    fails(rows_in(folder), "errors_q8.json: is damaged: ");
  }
  folder.write("rows/errors_q8.json", errors);
  fails(rows_in(folder) + " --html " + quoted(folder.path("rows/cost_q8.json")), "expected different files");
  CHECK(slurp(folder.path("rows/cost_q8.json")) == row);
  fails("--cos 8 --square 20", "no combination of these word lengths fits");
  fails("--cos 8 --html x.html", "rows that are measured now have no cost");
  fails("--cos 8 --cos 9", "--cos is 8 and 9, expected one of them");
  fails("--cos 4 --rounding up", "rounding up does not exist, expected nearest, even, truncate, jam, or all");
  fails("--cos 4 --rounding all,even", "--rounding is all,even, expected all alone or a list of names");
  fails("--cos 4 --rounding ''", "--rounding is '', expected a value");
  fails("--cos 4 --rounding jam,jam", "--rounding has jam twice, expected each once");
  fails("--rounding truncate --tolerance 1", "rows that are measured now have no cost");
  fails("--measured " + quoted(folder.path("none")), "none: is no folder");
  fs::create_directory(folder.path("empty"));
  fails("--measured " + quoted(folder.path("empty")), "holds no measured rows");
  fails("--html " + quoted(folder.path("no/page.html")), "cannot be written");
  fails("merge " + quoted(folder.path("empty")) + " --output " + quoted(folder.path("to")),
        "has no sweep.json");
  folder.write("rows/cost_q8.json", row.substr(0, row.size() - 20));
  fails(rows_in(folder), "cost_q8.json:");
  folder.write("rows/cost_q8.json", "{}");
  fails(rows_in(folder), "cost_q8.json: is damaged");
  std::string other = row;
  other.replace(other.find("\"q8\""), 4, "\"q9\"");
  folder.write("rows/cost_q8.json", other);
  fails(rows_in(folder), "cost_q8.json: is no row of this program: format q9 does not exist");
}

TEST_CASE("merge writes into an empty folder or that of the same sweep", "[explore]") {
  const scratch folder;
  const auto at = [&](const char* name) { return quoted(folder.path(name)); };
  const auto sweep = [&](const std::string& more) {
    return run_blysk(folder, "explore --cos 4 " + more).status;
  };
  REQUIRE(sweep("--coefficient 4 --square 8 --output " + at("a")) == 0);
  REQUIRE(sweep("--coefficient 5 --square 8 --output " + at("b")) == 0);
  fs::create_directory(folder.path("a/logs"));
  folder.write("a/left.part", "half a row");
  const auto merge = [&](const std::string& arguments) {
    return run_blysk(folder, "explore merge " + arguments);
  };
  CHECK(merge(at("a") + " --output " + at("w") + " --metric typo").status == 2);
  CHECK(!fs::exists(folder.path("w")));
  REQUIRE(merge(at("a") + " --output " + at("w")).status == 0);
  CHECK(std::distance(fs::directory_iterator(folder.path("w")), fs::directory_iterator()) == 2);
  CHECK(merge(at("a") + " --output " + at("w")).status == 0);
  const std::string description = slurp(folder.path("w/sweep.json"));
  const outcome other = merge(at("b") + " --output " + at("w"));
  CHECK(other.status == 2);
  CHECK_THAT(other.err, ContainsSubstring("w: belongs to another sweep or shard"));
  CHECK(slurp(folder.path("w/sweep.json")) == description);
  CHECK_THAT(merge(at("a") + " --output " + at("a")).err, ContainsSubstring("a: is one of the shards"));
}

TEST_CASE("explore takes each value of each option of a device", "[explore]") {
  const scratch folder;
  int tried = 0;
  const json listed = json::parse(run_blysk(folder, "list --json").out);
  for (const json& device : listed["devices"]) {
    for (const auto& option : device["options"]) {
      for (const auto& value : option["values"]) {
        const std::string arguments =
            fmt::format("explore --csv --device {} --{}={}", device["name"].get<std::string>(),
                        option["name"].get<std::string>(), value.get<std::string>());
        CAPTURE(arguments);
        const outcome run = run_blysk(folder, arguments);
        CHECK(run.status == 0);
        CHECK(run.out.starts_with("device,"));
        ++tried;
      }
    }
  }
  CHECK(tried > 10);
}

TEST_CASE("explore measures errors at word lengths of one's own", "[explore]") {
  const scratch folder;
  const std::string format = "explore --measure --format q8 --domain whole --json";
  const json named = json::parse(run_blysk(folder, format).out);
  REQUIRE(named.size() == 1);
  CHECK(named[0]["points"] == 257000);
  // Its own command repeats the row.
  const std::string command = named[0]["command"];
  const std::string arguments = command.substr(command.find("explore"));
  CHECK(json::parse(run_blysk(folder, arguments + " --domain whole --json").out) == named);
  const outcome table = run_blysk(folder, arguments + " --csv --domain whole");
  CHECK(std::count(table.out.begin(), table.out.end(), '\n') == 2);
}

TEST_CASE("each value of an option has the word lengths of its own format", "[explore]") {
  const scratch folder;
  const auto measured = [&](const std::string& arguments) {
    const outcome run =
        run_blysk(folder, "explore --measure --format q8 --domain epicentre --json " + arguments);
    return run.status == 0 ? json::parse(run.out) : json();
  };
  int pairs = 0;
  const json listed = json::parse(run_blysk(folder, "list --json").out);
  for (const json& device : listed["devices"]) {
    for (const auto& option : device["options"]) {
      if (option["values"].size() < 2) continue;
      const std::string words =
          "--device " + device["name"].get<std::string>() + " --" + option["name"].get<std::string>() + " ";
      const std::string a = option["values"][0], b = option["values"][1];
      const json of_a = measured(words + a), of_b = measured(words + b);
      if (of_a.empty() || of_b.empty()) continue;  // it shades no point
      CAPTURE(words);
      ++pairs;
      CHECK(measured(words + a + "," + b) == json{of_a[0], of_b[0]});
      CHECK(measured(words + b + "," + a) == json{of_b[0], of_a[0]});
    }
  }
  CHECK(pairs >= 3);
}

TEST_CASE("a table of CSV has a header, and a comma in a cell is in quotes", "[explore]") {
  const scratch folder;
  const std::string sweep = "explore --csv --domain epicentre --cos 8 ";
  const outcome full = run_blysk(folder, sweep + "--shard 1/2");
  const outcome none = run_blysk(folder, sweep + "--shard 2/2");
  CHECK(none.status == 0);
  CHECK(full.out.starts_with(none.out));
  CHECK(std::count(none.out.begin(), none.out.end(), '\n') == 1);
  CHECK(none.out.starts_with("device,"));

  const json listed = json::parse(run_blysk(folder, "list --json").out);
  for (const json& device : listed["devices"]) {
    for (const auto& option : device["options"]) {
      if (option["name"] != "cuts") continue;
      const std::string words = device["name"].get<std::string>() + " --cuts 2,4";
      const std::string row = run_blysk(folder, sweep + "--device " + words).out;
      CHECK_THAT(row, ContainsSubstring(words + " --") && !ContainsSubstring(";4"));
      CHECK_THAT(row, ContainsSubstring(",\"build/bin/blysk explore --device " + words));
      // The fields of each line, what is in quotes as one.
      std::size_t fields[2] = {0, 0}, line = 0;
      bool is_quoted = false;
      for (const char each : row) {
        if (each == '"') is_quoted = !is_quoted;
        if (each == ',' && !is_quoted) ++fields[line];
        if (each == '\n' && line < 1) ++line;
      }
      CHECK(fields[0] == fields[1]);
    }
  }
}

TEST_CASE("a sweep that was killed goes on with nothing lost", "[explore]") {
  const scratch folder;
  const std::string to = folder.path("sweep");
  const std::string sweep = "explore --cos 8..11 --domain whole --csv";
  const std::string whole = run_blysk(folder, sweep).out;
  // Killed as soon as the second row is there.
  const std::string script =
      folder.write("kill.sh", quoted(BLYSK_PROGRAM) + " " + sweep + " --output " + quoted(to) +
                                  " >/dev/null 2>&1 &\n" + "until [ \"$(ls " + quoted(to) +
                                  " 2>/dev/null | wc -l)\" -ge 3 ]; do sleep 0.02; done\n" +
                                  "kill -KILL $!\nwait 2>/dev/null\ntrue\n");
  REQUIRE(std::system(("bash " + quoted(script)).c_str()) == 0);
  const auto rows_there = [&] {
    return std::count_if(fs::directory_iterator(to), fs::directory_iterator(), [](const auto& entry) {
      return entry.path().filename().string().starts_with("co");
    });
  };
  REQUIRE(rows_there() >= 2);
  const outcome again = run_blysk(folder, sweep + " --output " + quoted(to));
  CAPTURE(again.err);
  CHECK(again.status == 0);
  CHECK(again.out == whole);
  CHECK(rows_there() == 4);
}
