// SPDX-License-Identifier: Apache-2.0
/// Figures derived a second time. Nothing here calls what the page is measured with, but for the way numbers are
/// printed.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "tb/claims/figure.h"

namespace blysk::claims {

/// Every test that a row can name under "held by".
inline constexpr std::array<std::string_view, 11> kHolders{
    "relative errors by a dense search",
    "the form of table 3.2 by a golden-section search",
    "absolute errors by a dense search",
    "points of the curves have closed forms",
    "reflectance by polynomials and direct sums",
    "table 1 of the article by the literal formula",
    "the article's coefficient by sums of cosines",
    "pictures by the literal listing",
    "whole numbers by hand",
    "what no model takes is refused",
    "the gaps of the strobe in the text of their table",
};

/// Whether a figure of docs/tables/measured.json is what the second derivation prints: they differ by no more than half
/// a unit of the last digit of the format, and no digit of the figure can be another.
bool agrees(const std::string& printed, const figure& second, const std::string& spec);

/// Expects second values for every figure of every row that names this test, and of no other row; that each agrees; and
/// that with any one digit changed it would not.
void check_rows(std::string_view test, const std::map<std::string, figures>& second);

}  // namespace blysk::claims
