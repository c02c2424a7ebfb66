// SPDX-License-Identifier: Apache-2.0
// [T] table 3.2: T33 to T36.
#include "tb/claims/pictures.h"

#include <fmt/format.h>

#include "tb/claims/figure.h"
#include "tb/claims/measure/over_exponents.h"
#include "tb/claims/table_form.h"

namespace blysk::claims {

using namespace golden;
namespace {

using named = std::vector<std::pair<std::string, std::string_view>>;

figures nmse_figures(const named& lobes, double limit, int first, int last) {
  figures result;
  for (const auto& [key, which] : lobes) {
    for (std::size_t s = 0; s < kPictureScenes.size(); ++s) {
      const auto nmse = [&, name = which](int n) { return sphere_nmse(name, s, n); };
      const auto prefix = fmt::format("{}_{}", key, kPictureScenes[s].key);
      add_worst(result, prefix, worst_over(first, last, nmse));
      result[prefix + "_met"] = exponents_where(first, last, [&](int n) { return nmse(n) <= limit; });
    }
  }
  return result;
}

}  // namespace

void measure_pictures(measurements& into) {
  const named quadratics{{"exact", name_of(lobe::quadratic_exact)},
                         {"published", name_of(lobe::quadratic_published)},
                         {"derived", name_of(lobe::quadratic_derived)}};
  into["T33"] = [] {
    return nmse_figures({{"cq", name_of(lobe::cosine_quadratic)}}, 0.00008, 1, kMaxExponent);
  };
  into["T34"] = [] {
    return nmse_figures({{"A", name_of(lobe::schlick_modified_a)},
                         {"B", name_of(lobe::schlick_modified_b)},
                         {"C", name_of(lobe::schlick_modified_c)},
                         {"D", name_of(lobe::schlick_modified)},
                         {"E", table_form::kName}},
                        0.00011, 1, kMaxExponent);
  };
  into["T35"] = [=] { return nmse_figures(quadratics, 0.00026, 1, 169); };
  into["T36"] = [=] { return nmse_figures(quadratics, 0.0002, 170, kMaxExponent); };
}

}  // namespace blysk::claims
