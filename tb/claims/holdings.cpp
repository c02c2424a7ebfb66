// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "tb/claims/claim.h"

namespace blysk::golden {

const std::vector<holding>& holdings() {
  static const std::vector<holding> result{
      {"relative errors are those at the edge or at the stationary point",
       {"T1", "T2", "T4", "T8", "T10", "T11", "T12", "T17", "T42", "T44", "T6", "T9", "P5", "E7"}},
      {"the form of table 3.2 errs by what a search over a finds", {"T5", "T7"}},
      {"absolute errors are those of a dense search", {"T13", "T16", "T18", "T19", "T43", "E1"}},
      {"points of the curves have closed forms",
       {"P1", "P2", "P3", "P4", "T3", "T14", "T15", "E3", "E4", "E12"}},
      {"reflectance at normal incidence is a polynomial's integral",
       {"T28", "T29", "T30", "T31", "T32", "E8", "A6"}},
      {"table 1 of the article by the literal formula",
       {"A-T1-0.1", "A-T1-0.2", "A-T1-0.3", "A-T1-0.4", "A-T1-0.5", "A-T1-0.6", "A-T1-0.7", "A-T1-0.8",
        "A-T1-0.9", "A1", "A4"}},
      {"the article's coefficient by sums of cosines",
       {"A-T2-0.1", "A-T2-0.2", "A-T2-0.3", "A-T2-0.4", "A-T2-0.5", "A-T2-0.6", "A-T2-0.7", "A-T2-0.8",
        "A-T2-0.9", "A2",       "A3",       "A-F4-0.5", "A-F4-0.1", "A-F7",     "A-T2",     "A5",
        "A-F8",     "A7",       "A8",       "E9",       "E10",      "E11"}},
      {"whole numbers by hand",
       {"P6", "P10", "T22", "T23", "T24", "T25", "T26", "T27", "T40", "T46", "T47", "T48", "T49", "T50",
        "T51", "E2", "E5", "E6", "E14"}},
      {"what no model takes is refused", {"E16", "E17"}},
  };
  return result;
}

std::string held_by(std::string_view id) {
  for (const auto& h : holdings()) {
    if (std::ranges::find(h.rows, id) != h.rows.end()) return "golden.claims: " + std::string(h.test);
  }
  return "docs.verification";
}

}  // namespace blysk::golden
