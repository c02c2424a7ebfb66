// SPDX-License-Identifier: Apache-2.0
// The bit-accurate model of a device against its formula, over every input, within the bound that the device derives.
#include "tb/specular/test/bound.h"

#include "tb/devices/test/asked.h"

using namespace blysk;

TEST_CASE("the bit-accurate model is within its bound for all inputs", "[bound][variants]") {
  const selection asked = test::asked_for();
  specular::test::bounded of(asked);
  for_all_inputs(asked, [&](const columns& writes) { of.check(writes); });
  CHECK(of.inputs() == 1000 * ((std::uint64_t{1} << asked.fraction()) + 1));
  // Rounding alone reaches half an ulp somewhere among so many inputs.
  WARN("largest error / bound: " << of.tightness());
  CHECK(of.tightness() > 0.9);
}
