// SPDX-License-Identifier: Apache-2.0
// docs/tables/stability.md: literal and stable forms.
#include <cmath>

#include "tb/claims/tables/tables.h"
#include "tb/claims/words.h"
#include "tb/golden/hard_forms.h"

namespace blysk::claims {

using namespace golden;

namespace {

/// Power of ten that a loss reaches: further digits depend on the version of the mathematical library.
std::string at_least(double ulp) {
  if (!std::isfinite(ulp)) return "not finite";
  return ulp < 1 ? "< 1" : "10^" + std::to_string(static_cast<int>(std::log10(ulp)));
}

}  // namespace

std::vector<table> stability_tables() {
  std::vector<std::vector<std::string>> rows{{"literal form", "stable form", "of", "float: literal",
                                              "stable within", "double: literal", "stable within"}};
  for (const hard_form& form : hard_forms()) {
    const loss single = worst_of(form, form.in_float);
    const loss twice = worst_of(form, form.in_double);
    rows.push_back({form.literal, form.stable, form.argument, at_least(single.literal),
                    number(single.bound, 2), at_least(twice.literal), number(twice.bound, 2)});
  }
  std::vector<std::vector<std::string>> bits{{"n", "n 2^-(f+1) <= 1/510 asks for", "measured"}};
  for (const int n : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000}) {
    bits.push_back(
        {std::to_string(n), number(std::ceil(std::log2(n * 510.0) - 1)), std::to_string(cosine_bits(n))});
  }
  return {{"stability.md",
           "# Literal and stable forms: errors in ulp\n\nEach row goes through the points that its plot in "
           "[numerics.md](../numerics.md) shows and stands at the one where the literal form is furthest "
           "outside the "
           "stable form's bound: the literal error there, as the power of ten that it reaches, and the "
           "bound, which "
           "running error analysis gives for the stable form's own steps. The exact value is the stable form "
           "in 50 "
           "digits at the point as float or double holds it. An ulp is the spacing of the numbers at the "
           "exact value; "
           "2 roundoffs, each 2^-24 or 2^-53, make an ulp of 1. `ctest -R golden.stability` holds every "
           "stable form to "
           "its bound at every point and prints all digits.\n\n" +
               markdown(rows) +
               "\n## Fraction bits of the cosine\n\nThe slope of cos^n near cos = 1 is n: f fraction bits, "
               "rounded, "
               "move the result by n 2^-(f+1) at most. Measured: the cosines halfway between the codes are "
               "rounded "
               "either way, and half an 8-bit step is allowed.\n\n" +
               markdown(bits)}};
}

}  // namespace blysk::claims
