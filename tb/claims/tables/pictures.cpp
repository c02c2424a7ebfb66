// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/pictures.h"

#include "tb/claims/tables/tables.h"
#include "tb/claims/words.h"

namespace blysk::claims {

using namespace golden;

std::vector<table> picture_tables() {
  constexpr std::array kListed{1, 2, 3, 5, 10, 20, 50, 100, 169, 170, 200, 500, 1000};
  std::string text =
      "# NMSE on the sphere against Blinn's lobe\n\n512 x 512 pixels, orthographic view (0, 0, 1), one light "
      "along (0.4, 0.5, 0.75), radius 0.9 of half the side; 8-bit colours as calcColor of [T] listing A "
      "makes "
      "them: the object's colour scaled by N.L, white scaled by the lobe, saturated; negative lobes set to "
      "zero. "
      "[T] reads up to 1e-4 as no visible difference, to 2.5e-4 slight, to 1e-3 visible, above strong. The "
      "last "
      "column is the largest over every n in 1..1000. schlick-modified-e is the form of [T] table 3.2, a "
      "fitted to "
      "the error where c^n >= 0.6.\n";
  for (std::size_t s = 0; s < kPictureScenes.size(); ++s) {
    std::vector<std::vector<std::string>> rows{{"lobe \\ n"}};
    for (const int n : kListed) rows.front().push_back(std::to_string(n));
    rows.front().emplace_back("largest, at n");
    for (const std::string_view name : pictured_lobes()) {
      rows.push_back({std::string(name)});
      const auto value = [&](int n) { return sphere_nmse(name, s, n); };
      for (const int n : kListed) rows.back().push_back(number(value(n), 2));
      const worst w = worst_over(1, kMaxExponent, value);
      rows.back().push_back("**" + number(w.value, 2) + "**, " + std::to_string(w.n));
    }
    text += "\n## " + std::string(kPictureScenes[s].name) + "\n\n" + markdown(rows);
  }
  return {{"nmse.md", text}};
}

}  // namespace blysk::claims
