// SPDX-License-Identifier: Apache-2.0
// The blocks of devices that take several cycles, against next-state tables written anew here, under random inputs.
#include <random>

#include "rtl_sysc/blocks/digit_control.h"
#include "rtl_sysc/blocks/digit_register.h"
#include "rtl_sysc/blocks/line_control.h"
#include "rtl_sysc/blocks/pixel_counter.h"
#include "rtl_sysc/blocks/sequencer.h"
#include "rtl_sysc/blocks/shift_register.h"
#include "rtl_sysc/blocks/start_register.h"
#include "rtl_sysc/blocks/sum_register.h"
#include "tb/catch.h"

// SystemC's own objects, compiled by g++, refer to parts of this class that clang leaves out at -O3 otherwise.
template class sc_core::sc_signal<bool>;

namespace {

using namespace blysk;

using data = sq<3, 0>;    // -8..7
using wide = sq<4, 3>;    // -16..15.875
using half = sq<2, 3>;    // of the shift register: half of data
using digits = uq<1, 3>;  // four digits
using length = uq<2, 0>;  // 0..3
constexpr int kSteps = 3;

struct blocks {
  template <class Block>
  void clocked(Block& block) {
    block.clk(clk);
    block.rst_n(rst_n);
  }

  blocks() {
    clocked(shift), shift.load_i(load), shift.step_i(step), shift.d_i(d), shift.q_o(shifted);
    clocked(digit), digit.load_i(load), digit.step_i(step), digit.d_i(word), digit.digit_o(digit_now);
    clocked(sum), sum.load_i(load), sum.step_i(step), sum.add_i(add), sum.d_i(d), sum.sum_i(next),
        sum.q_o(summed);
    clocked(start), start.load_i(load), start.step_i(step), start.d_i(d), start.sum_i(next),
        start.q_o(started);
    clocked(control), control.start_i(load), control.load_o(loads), control.step_o(steps);
    control.ready_o(is_ready), control.done_o(is_done);
    clocked(taking), taking.start_i(load), taking.take_o(takes), taking.first_o(is_first);
    taking.step_o(digit_steps), taking.ready_o(digits_ready), taking.done_o(digits_done);
    clocked(line), line.start_i(load), line.length_i(pixels), line.load_o(line_loads),
        line.step_o(line_steps);
    line.draw_o(draws), line.ready_o(line_ready);
    clocked(counter), counter.start_i(load), counter.length_i(pixels), counter.load_o(counter_loads);
    counter.draw_o(counter_draws), counter.ready_o(counter_ready);
  }

  void clock() {
    sc_core::sc_start(1, sc_core::SC_NS);
    clk.write(true);
    sc_core::sc_start(1, sc_core::SC_NS);
    clk.write(false);
    sc_core::sc_start(1, sc_core::SC_NS);
  }

  shift_register<data, half> shift{"shift"};
  digit_register<digits> digit{"digit"};
  sum_register<data, wide> sum{"sum"};
  start_register<data, wide> start{"start"};
  sequencer<kSteps> control{"control"};
  digit_control<kSteps> taking{"taking"};
  line_control<length, kSteps> line{"line"};
  pixel_counter<length> counter{"counter"};

  sc_core::sc_signal<bool> clk, rst_n, load, step, add, digit_now;
  sc_core::sc_signal<bool> loads, steps, is_ready, is_done, line_loads, line_steps, draws, line_ready;
  sc_core::sc_signal<bool> takes, is_first, digit_steps, digits_ready, digits_done;
  sc_core::sc_signal<bool> counter_loads, counter_draws, counter_ready;
  sc_core::sc_signal<data::raw_t> d;
  sc_core::sc_signal<half::raw_t> shifted;
  sc_core::sc_signal<digits::raw_t> word;
  sc_core::sc_signal<wide::raw_t> next, summed, started;
  sc_core::sc_signal<length::raw_t> pixels;
} bench;

/// What the registers hold.
struct state {
  int shifted = 0;  // in eighths
  int digits = 0;
  int summed = 0;  // in eighths
  int started = 0;
  int steps = 0;
  bool done = false;
  bool is_first = false;
  int line_steps = 0;
  int pixels = 0;
  int counted = 0;
};

struct inputs {
  bool reset, load, step, add;
  int d, word, next, length;
};

int floor_half(int x) {
  return (x - (x < 0 ? 1 : 0)) / 2;
}

state after(const state& now, const inputs& in) {
  state then = now;
  if (in.reset) return {};
  if (in.load || in.step) {
    then.shifted = in.load ? 4 * in.d : floor_half(now.shifted);
    then.digits = (in.load ? in.word : now.digits) * 2 % 16;
  }
  if (in.load) {
    then.summed = in.add ? 8 * in.d : 0;
    then.started = 8 * in.d;
  } else if (in.step) {
    if (in.add) then.summed = in.next;
    then.started = in.next;
  }
  then.steps = now.steps > 0 ? now.steps - 1 : in.load ? kSteps : 0;
  then.done = now.steps == 1;
  then.is_first = in.load && now.steps == 0;  // the control of digits counts as that of steps does
  then.counted = now.counted > 0 ? now.counted - 1 : in.load ? in.length + 1 : 0;
  if (now.pixels == 0) {
    then.line_steps = in.load ? kSteps : 0;
    then.pixels = in.load ? in.length + 1 : 0;
  } else if (now.line_steps > 0) {
    then.line_steps = now.line_steps - 1;
  } else {
    then.pixels = now.pixels - 1;
  }
  return then;
}

}  // namespace

TEST_CASE("blocks of several cycles follow their next-state tables", "[unit][sequence]") {
  std::mt19937 random(7);
  const auto below = [&](unsigned limit) { return static_cast<int>(random() % limit); };
  bench.rst_n.write(false);
  bench.clock();
  state now;
  int ends = 0;
  for (int cycle = 0; cycle < 20'000; ++cycle) {
    const inputs in{below(64) == 0, below(3) == 0, below(2) == 0,    below(2) == 0,
                    below(16) - 8,  below(16),     below(256) - 128, below(4)};
    CAPTURE(cycle, in.reset, in.load, in.step, in.add, in.d, in.word, in.next, in.length);
    bench.rst_n.write(!in.reset);
    bench.load.write(in.load);
    bench.step.write(in.step);
    bench.add.write(in.add);
    bench.d.write(in.d);
    bench.word.write(static_cast<unsigned>(in.word));
    bench.next.write(in.next);
    bench.pixels.write(static_cast<unsigned>(in.length));
    sc_core::sc_start(1, sc_core::SC_NS);
    REQUIRE(bench.digit_now.read() == ((in.load ? in.word : now.digits) >= 8));
    REQUIRE(bench.loads.read() == (in.load && now.steps == 0));
    REQUIRE(bench.takes.read() == (in.load && now.steps == 0));
    REQUIRE(bench.line_loads.read() == (in.load && now.pixels == 0));
    REQUIRE(bench.counter_loads.read() == (in.load && now.counted == 0));
    bench.clock();
    now = after(now, in);
    REQUIRE(bench.shifted.read().to_int() == now.shifted);
    REQUIRE(bench.summed.read().to_int() == now.summed);
    REQUIRE(bench.started.read().to_int() == now.started);
    REQUIRE(bench.steps.read() == (now.steps > 0));
    REQUIRE(bench.is_ready.read() == (now.steps == 0));
    REQUIRE(bench.is_done.read() == now.done);
    REQUIRE(bench.digit_steps.read() == (now.steps > 0));
    REQUIRE(bench.digits_ready.read() == (now.steps == 0));
    REQUIRE(bench.digits_done.read() == now.done);
    REQUIRE(bench.is_first.read() == now.is_first);
    REQUIRE(bench.line_steps.read() == (now.line_steps > 0));
    REQUIRE(bench.draws.read() == (now.line_steps == 0 && now.pixels > 0));
    REQUIRE(bench.line_ready.read() == (now.pixels == 0));
    REQUIRE(bench.counter_draws.read() == (now.counted > 0));
    REQUIRE(bench.counter_ready.read() == (now.counted == 0));
    ends += now.done ? 1 : 0;
  }
  CHECK(ends > 100);
}
