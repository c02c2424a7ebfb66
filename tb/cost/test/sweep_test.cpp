// SPDX-License-Identifier: Apache-2.0
// Sweeps over word lengths: what they contain, how they go on after a stop, and how shards come together.
#include <stdlib.h>

#include <filesystem>
#include <fstream>

#include "tb/catch.h"
#include "tb/cost/sweep.h"

namespace {

using namespace blysk;
using namespace blysk::cost;
using Catch::Contains;
namespace fs = std::filesystem;

const std::string kDevice = devices().front()->name();

class scratch {
 public:
  scratch() {
    std::string pattern = (fs::temp_directory_path() / "blysk sweep XXXXXX").string();
    folder_ = mkdtemp(pattern.data());
  }
  ~scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  scratch(const scratch&) = delete;
  scratch& operator=(const scratch&) = delete;
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  fs::path folder_;
};

/// Four small combinations.
sweep small() {
  return {kDevice, {}, {{"cos", {4, 5}}, {"coefficient", {4, 5}}, {"square", {8, 8}}}};
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
    CHECK_THROWS_WITH(parse_range("cos", text), Contains("--cos is ") && Contains("expected bits"));
  }
  CHECK(parse_shard("2/8").index == 2);
  for (const char* text : {"", "1", "0/4", "5/4", "1/0", "-1/4", "1/4/2", "a/b"}) {
    CAPTURE(text);
    CHECK_THROWS_WITH(parse_shard(text), Contains("--shard is ") && Contains("1/4 .. 4/4"));
  }
}

TEST_CASE("a sweep has every combination that the laws allow", "[cost]") {
  CHECK(points_of(small()).first.size() == 4);
  const auto [points, refused] = points_of({kDevice, {}, {{"cos", {8, 9}}, {"square", {7, 10}}}});
  CHECK(points.size() == 5);  // 8, 9, 10 of cos 8; 9, 10 of cos 9
  CHECK(refused == 3);
  CHECK_THROWS_WITH(points_of({kDevice, {}, {{"nothing", {1, 2}}}}),
                    Contains("has no word length nothing, expected"));
  CHECK_THROWS_WITH(points_of({kDevice, {}, {{"cos", {8, 25}}}}), Contains("expected at most 24"));
}

TEST_CASE("a sweep goes on where it stopped", "[cost]") {
  const scratch folder;
  const std::string to = folder.path("sweep");
  const nlohmann::ordered_json whole = json_of(run_sweep(small(), {"", {}, 1}, {}));
  CHECK(json_of(run_sweep(small(), {to, {}, 1}, {})) == whole);
  const std::string name = name_of(points_of(small()).first[2].bits) + ".json";
  REQUIRE(fs::remove(to + "/" + name));
  const auto others = fs::last_write_time(to + "/" + name_of(points_of(small()).first[0].bits) + ".json");
  CHECK(json_of(run_sweep(small(), {to, {}, 2}, {})) == whole);
  CHECK(fs::last_write_time(to + "/" + name_of(points_of(small()).first[0].bits) + ".json") == others);
  CHECK(names_in(to).size() == 5);

  // A row that was damaged, another sweep, a folder of something else.
  std::ofstream(to + "/" + name) << "{}";
  CHECK_THROWS_WITH(run_sweep(small(), {to, {}, 1}, {}), Contains(name + ": is damaged"));
  sweep other = small();
  other.widths["cos"] = {4, 4};
  CHECK_THROWS_WITH(run_sweep(other, {to, {}, 1}, {}), Contains("belongs to another sweep or shard"));
  CHECK_THROWS_WITH(run_sweep(small(), {to, {1, 2}, 1}, {}), Contains("belongs to another sweep or shard"));
  fs::create_directory(folder.path("taken"));
  std::ofstream(folder.path("taken") + "/notes") << "mine";
  CHECK_THROWS_WITH(run_sweep(small(), {folder.path("taken"), {}, 1}, {}),
                    Contains("holds notes, expected an empty folder"));
  CHECK(names_in(folder.path("taken")) == std::vector<std::string>{"notes"});
}

TEST_CASE("two sweeps do not share a folder", "[cost]") {
  const scratch folder;
  const std::string to = folder.path("sweep");
  bool was_refused = false;
  run_sweep(small(), {to, {}, 1}, [&](double) {
    if (was_refused) return;
    CHECK_THROWS_WITH(run_sweep(small(), {to, {}, 1}, {}), Contains("is in use by another run"));
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
  CHECK_THROWS_WITH(merge_shards({parts[0], parts[2]}, to), Contains("shard 2/3 is missing"));
  CHECK_THROWS_WITH(merge_shards({parts[0], parts[0]}, to), Contains("is shard 1/3 once more"));
  CHECK_THROWS_WITH(merge_shards({folder.path("none")}, to), Contains("has no sweep.json"));
  CHECK(!fs::exists(to));
  CHECK(json_of(merge_shards(parts, to).second) == whole);
  // The whole is a sweep's folder like any other.
  CHECK(json_of(run_sweep(small(), {to, {}, 1}, {})) == whole);

  const std::string lost = parts[1] + "/" + name_of(points_of(small()).first[1].bits) + ".json";
  REQUIRE(fs::remove(lost));
  CHECK_THROWS_WITH(merge_shards(parts, folder.path("again")), Contains("is in no shard"));
  sweep other = small();
  other.widths["cos"] = {4, 4};
  run_sweep(other, {folder.path("other"), {2, 3}, 1}, {});
  CHECK_THROWS_WITH(merge_shards({parts[0], folder.path("other"), parts[2]}, folder.path("again")),
                    Contains("is of another sweep"));
}
