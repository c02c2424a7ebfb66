// SPDX-License-Identifier: Apache-2.0
// The bit-accurate model of a device with strobes, between whose registers nothing is repeated, against its netlist without
// a simulation.
#include "tb/devices/test/asked.h"
#include "tb/devices/test/comparison.h"
#include "tb/netlist/interpreter.h"

namespace {

using namespace blysk;

constexpr std::uint64_t kComputed = 5'000'000;  // all inputs of q12

}  // namespace

TEST_CASE("netlist = bit", "[variants]") {
  const selection asked = test::asked_for();
  test::comparison compared(asked, netlist::make_interpreter(asked), asked.of().make_bit(asked));
  test::compare(compared, asked, kComputed);
}
