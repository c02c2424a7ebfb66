// SPDX-License-Identifier: Apache-2.0
// The reference functions in a program of one's own: the quadratic beside Blinn's cos^n.
#include <cstdio>

#include "tb/golden/lobe.h"

int main() {
  using namespace blysk::golden;
  for (const double cos : {0.9, 0.95, 0.99, 1.0})
    std::printf("%g %.6f %.6f\n", cos, evaluate(lobe::quadratic_derived, 10.0, cos),
                evaluate(lobe::blinn, 10.0, cos));
}
