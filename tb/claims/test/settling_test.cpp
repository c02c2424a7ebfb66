// SPDX-License-Identifier: Apache-2.0
// The gaps of the strobe, looked up in the table's text.
#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "tb/catch.h"
#include "tb/claims/test/second.h"

using namespace blysk::claims;

TEST_CASE("the gaps of the strobe in the text of their table", "[claims]") {
  std::ifstream file(BLYSK_DOCS "/tables/settling.csv");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto gap = [&](const std::string& start) {
    std::smatch found;
    REQUIRE(std::regex_search(text, found, std::regex("\n" + start + ",([0-9.]+),")));
    return std::stod(found[1]);
  };
  // A code got and the same code expected, at the end of a line.
  const std::regex same(",(-?[0-9]+),\\1\n");
  const auto equal =
      std::distance(std::sregex_iterator(text.begin(), text.end(), same), std::sregex_iterator());
  const double lines = static_cast<double>(std::count(text.begin(), text.end(), '\n'));
  check_rows("the gaps of the strobe in the text of their table",
             {{"P9",
               {{"rows", lines - 1},
                {"right", static_cast<double>(equal)},
                {"q8", gap("quadratic,q8")},
                {"q12", gap("quadratic,q12")},
                {"q16", gap("quadratic,q16")},
                {"rom_q8", gap("quadratic-rom,q8")},
                {"rom_q12", gap("quadratic-rom,q12")}}}});
}
