// SPDX-License-Identifier: Apache-2.0
// The literal form of each formula beside the stable one: by how much it fails, and that the stable one does not.
#include <cmath>
#include <cstdio>

#include "tb/catch.h"
#include "tb/golden/hard_forms.h"

using namespace blysk::golden;

TEST_CASE("each literal form loses what its cancellation predicts, the stable one keeps its bound",
          "[stability][naive]") {
  std::printf("%-20s %-7s %15s %12s %12s %12s\n", "form", "type", "literal, ulp", "stable, ulp", "bound, ulp",
              "factor");
  for (const hard_form& form : hard_forms()) {
    for (const bool single : {true, false}) {
      const auto& at = single ? form.in_float : form.in_double;
      const double predicted = single ? form.predicted_float : form.predicted_double;
      const loss worst = worst_of(form, at);
      std::printf("%-20s %-7s %15.6g %12.3g %12.3g %12.3g\n", form.name.c_str(), single ? "float" : "double",
                  worst.literal, worst.stable, worst.bound, worst.factor());
      CAPTURE(form.name, single);
      for (const double x : form.points) {
        const loss here = at(x);
        CAPTURE(x);
        REQUIRE(here.stable <= here.bound);
      }
      if (predicted == 0) {
        CHECK(worst.factor() <= 1);
        continue;
      }
      CHECK(worst.factor() > 1);
      // 2 roundoffs are 1 to 2 ulp of the result; a quarter of the prediction is asked for.
      CHECK(worst.literal >= predicted / 4 / 2);
    }
  }
}

TEST_CASE("the fraction bits that cos^n asks of its cosine", "[stability]") {
  CHECK(cosine_bits(10) == 12);
  CHECK(cosine_bits(100) == 15);
  CHECK(cosine_bits(1000) == 18);
}
