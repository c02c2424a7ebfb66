// SPDX-License-Identifier: Apache-2.0
// Delays behind wires: a pulse shorter than a delay is not seen, and a bit waits for the latest of what changed.
#include "tb/harness/delay_lines.h"

#include "rtl_sysc/blocks/buffer.h"
#include "rtl_sysc/blocks/mul.h"
#include "tb/catch.h"

// SystemC's own objects, compiled by g++, refer to parts of this class that clang leaves out at -O3 otherwise.
template class sc_core::sc_signal<bool>;

namespace {

using namespace blysk;
using netlist::wire;
using product = mul<uq<2, 0>, uq<2, 0>, uq<4, 0>>;

void run(double ps) {
  sc_core::sc_start(sc_core::sc_time(ps, sc_core::SC_PS));
}

}  // namespace

// One case: SystemC elaborates once in a process.
TEST_CASE("delays are inertial, and each bit has its own", "[harness][delays]") {
  constexpr int no = block_delays::kNoPath;
  wire<bool> a, y, other;
  buffer wired("wired");
  wired.a_i(a);
  wired.y_o(y);
  wire<uq<2, 0>::raw_t> left, right;
  wire<uq<4, 0>::raw_t> result;
  product times("times");
  times.a_i(left);
  times.b_i(right);
  times.p_o(result);
  harness::delay_lines lines("lines");
  lines.delay(y, {{&a, 1}}, {{200}});
  // From both bits of the left operand, then of the right one.
  lines.delay(result, {{&left, 2}, {&right, 2}},
              {{500, no, 100, no}, {500, 500, 100, 100}, {500, 500, 100, 100}, {600, 600, 150, 150}});
  run(1000);

  // A pulse of 0.1 ns through 0.2 ns leaves nothing; one of 0.3 ns passes, 0.2 ns later.
  a.write(true);
  run(100);
  a.write(false);
  run(1000);
  CHECK_FALSE(y.read());
  CHECK(lines.history(y).changed_at == 0);
  a.write(true);
  run(199);
  CHECK_FALSE(y.read());
  run(2);
  CHECK(y.read());
  run(99);
  a.write(false);
  run(199);
  CHECK(y.read());
  run(2);
  CHECK_FALSE(y.read());

  // 3 * 1: each bit after its own delay; 3 * 3 = 9 while the left operand's change is under way waits for that.
  left.write(3);
  right.write(1);
  run(499);
  CHECK(result.read() == 0);
  run(2);
  CHECK(result.read() == 3);
  run(1000);
  right.write(3);
  run(101);
  CHECK(result.read() == 1);  // bits 0 to 2 are those of 9, bit 3 takes longer
  run(50);
  CHECK(result.read() == 9);
  run(1000);
  left.write(2);  // 6
  run(200);
  right.write(2);  // 4: pending bits are taken back and come anew
  run(299);
  CHECK(result.read() == 9);
  run(2);
  CHECK(result.read() == 12);  // the highest bit's 600 ps are not over
  run(100);
  CHECK(result.read() == 4);
  CHECK(lines.history(result).changed_bits == 8);
  CHECK(lines.next() == std::numeric_limits<harness::picoseconds>::max());

  CHECK_THROWS_AS(lines.history(other), std::invalid_argument);
}
