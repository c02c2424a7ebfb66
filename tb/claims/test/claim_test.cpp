// SPDX-License-Identifier: Apache-2.0
// What turns measurements into verdicts.
#include "tb/claims/claim.h"

#include <algorithm>

#include "tb/catch.h"

using namespace blysk::golden;

TEST_CASE("a measurement reproduces what it rounds to", "[golden][claims]") {
  CHECK(rounds_to(0.4427, 0.4427, 4));
  CHECK(rounds_to(0.44265, 0.4427, 4));
  CHECK_FALSE(rounds_to(0.44264, 0.4427, 4));
  CHECK(rounds_to(26.5, 27, 0));
  CHECK_FALSE(rounds_to(27.6, 27, 0));
}

TEST_CASE("a verdict names what holds", "[golden][claims]") {
  using readings = std::vector<reading>;
  CHECK(verdict_of(readings{{"a", true}, {"b", true}}) == "holds");
  CHECK(verdict_of(readings{{"a", false}, {"b", false}}) == "does not hold");
  CHECK(verdict_of(readings{{"a", true}, {"b", false}, {"c", true}}) == "ambiguous: holds for a, c");
  CHECK(verdict_of_parts(readings{{"a", true}, {"b", false}}) == "holds in part: a");
}

TEST_CASE("members of a range are written shortly", "[golden][claims]") {
  CHECK(ranges({false, false}) == "none");
  CHECK(ranges({true}) == "1");
  CHECK(ranges({true, true, true, false, true, false, true, true}) == "1..3, 5, 7..8");
}

TEST_CASE("a cell cannot break its table", "[golden][claims]") {
  CHECK(markdown({{"a", "b"}, {"|x|", "1"}}) == "| a | b |\n| --- | --- |\n| \\|x\\| | 1 |\n");
}

TEST_CASE("numbers of mere rounding are zero", "[golden][claims]") {
  CHECK(number(kRounding / 2) == "0");
  CHECK(number(2 * kRounding, 2) == "1.4e-14");
  CHECK(percent(0.03157) == "3.16 %");
}

TEST_CASE("every row has its own name and a verdict of the list", "[golden][claims]") {
  // The patent's rows; the other sections take longer and are all written, hence read, by docs.verification.
  std::vector<std::string> ids;
  for (const claim& c : patent_claims()) {
    CAPTURE(c.id);
    CHECK(std::find(ids.begin(), ids.end(), c.id) == ids.end());
    ids.push_back(c.id);
    CHECK_FALSE(c.measured.empty());
    CHECK((c.verdict == kHolds || c.verdict == kFails || c.verdict.starts_with(kPartly) ||
           c.verdict.starts_with(kAmbiguous) || c.verdict == kUncheckable));
  }
}
