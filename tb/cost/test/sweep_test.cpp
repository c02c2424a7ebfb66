// SPDX-License-Identifier: Apache-2.0
// Sweeps over word lengths: what they contain, how they go on after a stop, and how shards come together.
#include <filesystem>
#include <fstream>
#include <set>

#include "tb/catch_text.h"
#include "tb/cost/sweep.h"
#include "tb/scratch.h"

namespace {

using namespace blysk;
using namespace blysk::cost;
namespace fs = std::filesystem;

const std::string kDevice = devices().front()->name();

/// Four small combinations.
sweep small() {
  return {kDevice, {}, {{"cos", {4, 5}}, {"coefficient", {4, 5}}, {"square", {8, 8}}}};
}

/// Of the row's file.
std::string name_of(std::size_t point) {
  return points_of(small()).first[point].name(small()) + ".json";
}

nlohmann::ordered_json json_of(const std::vector<sweep_row>& rows) {
  return json_rows(small(), rows, {domain::whole, domain::lobe});
}

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

}  // namespace

TEST_CASE("ranges and shards are read or refused", "[cost]") {
  CHECK(parse_range("cos", "12").first == 12);
  CHECK(parse_range("cos", "8..12").last == 12);
  for (const char* text : {"", "..", "8..", "..12", "12..8", "0..3", "8..65", "8.5", "-3", "8...12", "x"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH(parse_range("cos", text),
                      ContainsSubstring("--cos is ") && ContainsSubstring("expected bits"));
  }
  CHECK(parse_shard("2/8").index == 2);
  for (const char* text : {"", "1", "0/4", "5/4", "1/0", "-1/4", "1/4/2", "a/b"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH(parse_shard(text), ContainsSubstring("--shard is ") && ContainsSubstring("1/4 .. 4/4"));
  }
}

TEST_CASE("a sweep has every combination that the laws allow", "[cost]") {
  CHECK(points_of(small()).first.size() == 4);
  const auto [points, refused] = points_of({kDevice, {}, {{"cos", {8, 9}}, {"square", {7, 10}}}});
  CHECK(points.size() == 5);  // 8, 9, 10 of cos 8; 9, 10 of cos 9
  CHECK(refused == 3);
  CHECK_THROWS_WITH(points_of({kDevice, {}, {{"nothing", {1, 2}}}}),
                    ContainsSubstring("has no word length nothing, expected"));
  CHECK_THROWS_WITH(points_of({kDevice, {}, {{"cos", {8, 25}}}}), ContainsSubstring("expected at most 24"));
}

TEST_CASE("roundings are read or refused", "[cost]") {
  using specular::rounding;
  CHECK(parse_roundings("all") ==
        std::vector{rounding::nearest, rounding::even, rounding::truncate, rounding::jam});
  CHECK(parse_roundings("jam,nearest") == std::vector{rounding::jam, rounding::nearest});
  for (const char* text : {"", "up", "nearest,", "nearest jam"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH(parse_roundings(text), ContainsSubstring("does not exist, expected nearest, even"));
  }
  CHECK_THROWS_WITH(parse_roundings("all,jam"), ContainsSubstring("expected all alone or a list of names"));
}

TEST_CASE("a sweep has every rounding and every value of an option", "[cost]") {
  using specular::rounding;
  // The first option of the device of which there are several to choose from.
  std::string option;
  std::vector<std::string> values;
  for (const blysk::option& each : devices().front()->options()) {
    if (each.values.size() < 2 || each.is_flag()) continue;
    option = each.name;
    values = each.values;
    break;
  }
  REQUIRE(values.size() >= 2);
  const sweep of{kDevice,
                 {{option, values}},
                 {{"cos", {4, 4}}, {"coefficient", {4, 4}}, {"square", {8, 8}}},
                 {rounding::nearest, rounding::truncate}};
  const std::vector<sweep_point> points = points_of(of).first;
  REQUIRE(points.size() == 2 * values.size());
  std::set<std::string> names;
  for (const sweep_point& each : points) names.insert(each.name(of));
  CHECK(names.size() == points.size());
  CHECK(points[0].how == rounding::nearest);
  CHECK(points[1].how == rounding::truncate);
  CHECK(points[1].name(of) == points[0].name(of) + "_rounding_truncate");

  const scratch folder;
  const auto rows = json_rows(of, run_sweep(of, {folder.path("sweep"), {}, 1}, {}), {domain::whole});
  CHECK(rows == json_rows(of, run_sweep(of, {folder.path("sweep"), {}, 1}, {}), {domain::whole}));
  CHECK(rows[0]["options"][option] == values[0]);
  CHECK(rows[2]["options"][option] == values[1]);
  CHECK(rows[0]["rounding"] == "nearest");
  CHECK(rows[1]["rounding"] == "truncate");
  // What is cut off is never above: half an ulp less on the average of what is not exact.
  CHECK(rows[1]["bias"].get<double>() < rows[0]["bias"].get<double>());
  CHECK(rows[0]["format"].is_null());  // no format has four bits
  sweep twice = of;
  twice.roundings = {rounding::jam, rounding::jam};
  CHECK_THROWS_WITH(twice.check(), ContainsSubstring("--rounding has jam twice"));
  twice = of;
  twice.options[option] = {values[0], values[0]};
  CHECK_THROWS_WITH(twice.check(), ContainsSubstring("twice, expected each once"));
}

TEST_CASE("a row of a format's word lengths, rounded as built, names the format", "[cost]") {
  using specular::rounding;
  const sweep of{kDevice, {}, {{"cos", {8, 9}}}, {rounding::nearest, rounding::even}};
  const std::vector<sweep_point> points = points_of(of).first;
  REQUIRE(points.size() == 4);
  CHECK(points[0].format() == "q8");
  CHECK(!points[1].format());
  CHECK(!points[2].format());
}

TEST_CASE("a sweep goes on where it stopped", "[cost]") {
  const scratch folder;
  const std::string to = folder.path("sweep");
  const nlohmann::ordered_json whole = json_of(run_sweep(small(), {"", {}, 1}, {}));
  CHECK(json_of(run_sweep(small(), {to, {}, 1}, {})) == whole);
  const std::string name = name_of(2);
  REQUIRE(fs::remove(to + "/" + name));
  const auto others = fs::last_write_time(to + "/" + name_of(0));
  CHECK(json_of(run_sweep(small(), {to, {}, 2}, {})) == whole);
  CHECK(fs::last_write_time(to + "/" + name_of(0)) == others);
  CHECK(names_in(to).size() == 5);

  // A row that was damaged, another sweep, a folder of something else.
  std::ofstream(to + "/" + name) << "{}";
  CHECK_THROWS_WITH(run_sweep(small(), {to, {}, 1}, {}), ContainsSubstring(name + ": is damaged"));
  sweep other = small();
  other.widths["cos"] = {4, 4};
  CHECK_THROWS_WITH(run_sweep(other, {to, {}, 1}, {}),
                    ContainsSubstring("belongs to another sweep or shard"));
  CHECK_THROWS_WITH(run_sweep(small(), {to, {1, 2}, 1}, {}),
                    ContainsSubstring("belongs to another sweep or shard"));
  fs::create_directory(folder.path("taken"));
  std::ofstream(folder.path("taken") + "/notes") << "mine";
  CHECK_THROWS_WITH(run_sweep(small(), {folder.path("taken"), {}, 1}, {}),
                    ContainsSubstring("holds notes, expected an empty folder"));
  CHECK(names_in(folder.path("taken")) == std::vector<std::string>{"notes"});
}

TEST_CASE("two sweeps do not share a folder", "[cost]") {
  const scratch folder;
  const std::string to = folder.path("sweep");
  bool was_refused = false;
  run_sweep(small(), {to, {}, 1}, [&](double) {
    if (was_refused) return;
    CHECK_THROWS_WITH(run_sweep(small(), {to, {}, 1}, {}), ContainsSubstring("is in use by another run"));
    was_refused = true;
  });
  CHECK(was_refused);
}

TEST_CASE("shards come together as the whole sweep", "[cost]") {
  const scratch folder;
  const nlohmann::ordered_json whole = json_of(run_sweep(small(), {"", {}, 1}, {}));
  std::vector<std::string> parts;
  for (int i = 1; i <= 3; ++i) {
    parts.push_back(folder.path(std::to_string(i)));
    run_sweep(small(), {parts.back(), {i, 3}, 1}, {});
  }
  const std::string to = folder.path("whole");
  CHECK_THROWS_WITH(merge_shards({parts[0], parts[2]}, to), ContainsSubstring("shard 2/3 is missing"));
  CHECK_THROWS_WITH(merge_shards({parts[0], parts[0]}, to), ContainsSubstring("is shard 1/3 once more"));
  CHECK_THROWS_WITH(merge_shards({folder.path("none")}, to), ContainsSubstring("has no sweep.json"));
  CHECK(!fs::exists(to));
  CHECK(json_of(merge_shards(parts, to).second) == whole);
  // The whole is a sweep's folder like any other.
  CHECK(json_of(run_sweep(small(), {to, {}, 1}, {})) == whole);

  const std::string lost = parts[1] + "/" + name_of(1);
  const std::string kept = folder.path("kept");
  fs::rename(lost, kept);
  std::ofstream(lost) << "[]";
  CHECK_THROWS_WITH(merge_shards(parts, folder.path("again")),
                    ContainsSubstring(name_of(1) + ": is damaged"));
  REQUIRE(fs::remove(lost));
  CHECK_THROWS_WITH(merge_shards(parts, folder.path("again")), ContainsSubstring("is in no shard"));
  sweep other = small();
  other.widths["cos"] = {4, 4};
  run_sweep(other, {folder.path("other"), {2, 3}, 1}, {});
  CHECK_THROWS_WITH(merge_shards({parts[0], folder.path("other"), parts[2]}, folder.path("again")),
                    ContainsSubstring("is of another sweep"));
}
