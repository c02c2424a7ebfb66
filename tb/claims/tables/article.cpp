// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/article.h"

#include "tb/claims/judge.h"
#include "tb/claims/tables/tables.h"
#include "tb/claims/words.h"
#include "tb/golden/angle.h"

namespace blysk::claims {

using namespace golden;
namespace {

std::string cell_table(const cells& measured, const by_level_and_power<demand>& printed) {
  std::vector<std::vector<std::string>> rows{{"Q \\ k", "1", "2", "3", "4", "5"}};
  for (std::size_t row = 0; row < measured.size(); ++row) {
    rows.push_back({number(kLevels[row])});
    for (std::size_t k = 0; k < kPowers; ++k) {
      const std::string figure = number(measured[row][k], 4);
      rows.back().push_back(printed[row][k].value + " / " + figure +
                            (met(printed[row][k], figure) ? "" : " **no**"));
    }
  }
  return markdown(rows);
}

}  // namespace

std::vector<table> article_tables() {
  std::vector<table> result;
  std::string text =
      "# [A] table 1: printed / measured\n\nLargest relative error, %, of the angle-based lobe against cos^n "
      "over n in [k + 1; 1000]. **no** marks a measurement that does not round to the printed number.\n";
  for (const epicentre where : kEpicentres)
    text += "\n## Epicentre: " + std::string(name_of(where)) + "\n\n" +
            cell_table(table1(where), printed_cells(1));
  result.push_back({"article_table1.md", text});
  result.push_back(
      {"article_table2.md",
       "# [A] table 2: printed / measured\n\nLargest |coef 2 pi Int - 1|, 10^-3, with the fitted coef, "
       "over n in [k + 1; 1000]. **no** marks a measurement that does not round to the printed "
       "number.\n\n" +
           cell_table(table2(), printed_cells(2))});
  std::vector<std::vector<std::string>> rows{{"Q", "n", "printed", "exact coef", ""}};
  for (const auto& [id, q] : {std::pair{"A-F4-0.5", 0.5}, {"A-F4-0.1", 0.1}}) {
    for (const demand& d : claim_of(id).stated) {
      const double n = number_of(std::string_view(d.figure).substr(1));  // "n10"
      const std::string exact = number(angle_coefficient_exact<double>(n, 1, q), 7);
      rows.push_back({number(q), number(n, 4), d.value, exact, met(d, exact) ? "reproduced" : "**no**"});
    }
  }
  result.push_back({"article_fig4.md", "# [A] fig. 4: training values, k = 1\n\n" + markdown(rows)});
  return result;
}

}  // namespace blysk::claims
