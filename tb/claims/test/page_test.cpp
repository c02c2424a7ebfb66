// SPDX-License-Identifier: Apache-2.0
// The page, its rows and its list of figures agree.
#include "tb/claims/page.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "tb/catch_text.h"
#include "tb/claims/test/second.h"
#include "tb/claims/words.h"

namespace blysk::claims {
namespace {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  REQUIRE(in);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

/// What load_claims says of a file with one row, of which `row` are the keys after its identifier.
std::string complaint(const std::string& row) {
  const auto path = std::filesystem::path(BLYSK_TEST_DIRECTORY) / "broken_claims.json";
  std::ofstream(path) << R"([{"section": "s", "rows": [{"id": "X1", "where": "w", "says": "s")" << row
                      << "}]}]";
  try {
    load_claims(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the page is what its rows and its figures give", "[claims]") {
  // Any changed figure, verdict or miss of the page differs from these.
  const auto docs = std::filesystem::path(BLYSK_DOCS);
  const auto page = verification_page(all_claims(), load_figures(docs / "tables" / "measured.json"));
  CHECK(page == text_of(docs / "verification.md"));
}

TEST_CASE("the list has the figures of the rows and no others", "[claims]") {
  const auto list = load_figures(BLYSK_MEASURED_JSON);
  std::size_t rows = 0;
  for (const auto& section : all_claims()) {
    for (const claim& c : section.rows) {
      CAPTURE(c.id);
      std::set<std::string> keys;
      for (const auto& p : placeholders(c.measured)) keys.insert(p.key);
      CHECK(all_measurements().contains(c.id) == !keys.empty());
      if (keys.empty()) {
        CHECK_FALSE(list.contains(c.id));
        continue;
      }
      ++rows;
      REQUIRE(list.contains(c.id));
      std::set<std::string> listed;
      for (const auto& entry : list.at(c.id)) listed.insert(entry.first);
      CHECK(listed == keys);
    }
  }
  CHECK(list.size() == rows);
  CHECK(all_measurements().size() == rows);
}

TEST_CASE("every test that a row names exists, and holds a row", "[claims]") {
  std::set<std::string_view> named;
  for (const auto& section : all_claims()) {
    for (const claim& c : section.rows) {
      CAPTURE(c.id);
      if (!c.held_by.empty()) named.insert(c.held_by);
      // Speeds, which are one machine's, and what programs of other rooms measured have no second derivation.
      const bool has_figures = !placeholders(c.measured).empty();
      CHECK((c.held_by.empty() && has_figures) == (c.id == "P7" || c.id == "P8" || c.id == "T20" ||
                                                   c.id == "T21" || c.id == "T38" || c.id == "T54"));
    }
  }
  CHECK(named == std::set<std::string_view>(kHolders.begin(), kHolders.end()));
}

TEST_CASE("a row that is not as it has to be is named", "[claims]") {
  CHECK(complaint(R"(, "measured": "{a}", "open": "o")").empty());
  CHECK_THAT(complaint(R"(, "measured": "{a}")"),
             ContainsSubstring("row X1: needs either stated figures or 'open'"));
  CHECK_THAT(complaint(R"(, "measured": "{a", "open": "o")"),
             ContainsSubstring("a brace without its partner"));
  CHECK_THAT(complaint(R"(, "measured": "{a} {a}", "open": "o")"), ContainsSubstring("{a} comes twice"));
  CHECK_THAT(complaint(R"(, "measured": "m", "open": "o", "held_by": "t")"),
             ContainsSubstring("has no figure"));
  CHECK_THAT(complaint(R"(, "measured": "{a}", "open": "o", "note": "n")"),
             ContainsSubstring("'note' is unknown"));
  CHECK_THAT(complaint(R"(, "measured": "{a}", "stated": [{"figure": "b", "is": "1"}])"),
             ContainsSubstring("{b} is not in its text"));
  CHECK_THAT(complaint(R"(, "measured": "{a}", "stated": [{"figure": "a"}])"),
             ContainsSubstring("needs one of is"));
  CHECK_THAT(complaint(R"(, "measured": "{a}", "stated": [{"figure": "a", "is": "3.2"}])"),
             ContainsSubstring("does not state the value of a"));
  CHECK_THAT(complaint(R"(, "measured": "{a}", "stated": [{"figure": "a", "is": "1,5"}])"),
             ContainsSubstring("'1,5' is no number"));
  CHECK_THAT(complaint(R"(, "measured": "{a}", "stated": [{"figure": "a", "of": 3}])"),
             ContainsSubstring("needs both of and largest_miss"));
  CHECK_THAT(complaint(", \"measured\": "), ContainsSubstring("parse error"));
}

TEST_CASE("a text takes its figures by key", "[claims]") {
  CHECK(fill("{a:.3g} of {b}, {{c}}", {{"a", "1.5"}, {"b", "2"}}) == "1.5 of 2, {c}");
  CHECK_THROWS_AS(fill("{a}", {}), std::out_of_range);
}

TEST_CASE("numbers of mere rounding are zero", "[claims]") {
  CHECK(number(kRounding / 2) == "0");
  CHECK(number(2 * kRounding, 2) == "1.4e-14");
  CHECK(percent(0.03157) == "3.16 %");
}

TEST_CASE("members of a range are written shortly", "[claims]") {
  CHECK(ranges({false, false}) == "none");
  CHECK(ranges({true}) == "1");
  CHECK(ranges({true, true, true, false, true, false, true, true}) == "1..3, 5, 7..8");
}

TEST_CASE("a cell cannot break its table", "[claims]") {
  CHECK(markdown({{"a", "b"}, {"|x|", "1"}}) == "| a | b |\n| --- | --- |\n| \\|x\\| | 1 |\n");
}

TEST_CASE("one digit changed is noticed", "[claims]") {
  CHECK(agrees("10.3", 10.32, ".3g"));
  CHECK_FALSE(agrees("10.3", 10.36, ".3g"));
  CHECK_FALSE(agrees("10.4", 10.32, ".3g"));
  CHECK_FALSE(agrees("13", 13.04, ".4g"));
  CHECK(agrees("n in 1..39", figure("n in 1..39"), ""));
  CHECK_FALSE(agrees("n in 1..38", figure("n in 1..39"), ""));
}

}  // namespace blysk::claims
