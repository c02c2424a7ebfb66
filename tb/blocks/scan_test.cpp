// SPDX-License-Identifier: Apache-2.0
// The blocks of UA 71489 and of the arc-cosine unit: each against its formula or next-state table, written anew here.
#include <cmath>
#include <random>

#include "rtl_sysc/blocks/down_counter.h"
#include "rtl_sysc/blocks/filled_rom.h"
#include "rtl_sysc/blocks/line_table.h"
#include "rtl_sysc/blocks/magnitude.h"
#include "rtl_sysc/blocks/multiplexer.h"
#include "rtl_sysc/blocks/one_minus.h"
#include "rtl_sysc/blocks/part_decoder.h"
#include "rtl_sysc/blocks/parted_rom.h"
#include "rtl_sysc/blocks/scan_control.h"
#include "rtl_sysc/blocks/square_root.h"
#include "tb/catch.h"

// SystemC's own objects, compiled by g++, refer to parts of this class that clang leaves out at -O3 otherwise.
template class sc_core::sc_signal<bool>;

namespace {

using namespace blysk;

template <class Q>
using wire = sc_core::sc_signal<typename Q::raw_t>;

using signed_number = sq<3, 2>;
using unsigned_number = uq<3, 2>;
using number = uq<4, 0>;  // 0..15
using part = uq<2, 0>;
using place = unit<2>;  // 0..4
using word = uq<6, 0>;
using pixels = uq<3, 0>;

constexpr int kFirst = 3;
constexpr std::array<std::int64_t, 11> kWords{5, 4, 3, 2, 1, 0, 63, 62, 61, 60, 59};
constexpr std::array<std::int64_t, 16> kParts{16, 15, 14, 13, 26, 25, 24, 23, 36, 35, 34, 33, 46, 45, 44, 43};
constexpr std::size_t kPresent = 12;  // three of four parts

/// x^2 at 0, 1/4, ..., 1.
struct squares {
  static constexpr int segment_bits = 2;
  static constexpr std::array<std::int64_t, 5> values{0, 16, 64, 144, 256};
  static constexpr std::array<std::int64_t, 5> slopes{16, 48, 80, 112, 0};
};
using square = uq<1, 8>;

constexpr int kRadicand = 6;
constexpr int kRoot = 5;
using root_of = square_root_steps<kRadicand, kRoot>;

struct blocks {
  blocks() {
    mag.a_i(a), mag.y_o(magnitude_of_a);
    mux.a_i(a), mux.b_i(b), mux.select_b_i(selects), mux.y_o(taken);
    dec.n_i(n), dec.part_o(decoded);
    rom.a_i(n), rom.y_o(word_at_n);
    parts.part_i(asked_part), parts.a_i(asked_place), parts.y_o(word_at_place);
    sub.a_i(v), sub.y_o(rest_of_v);
    line.a_i(v), line.y_o(square_of_v);
    counter.clk(clk), counter.rst_n(rst_n), counter.load_i(load), counter.count_i(step), counter.d_i(d);
    counter.carry_o(carry);
    control.clk(clk), control.rst_n(rst_n), control.start_i(load), control.carry_i(ends);
    control.load_o(loads), control.first_o(first), control.step_o(steps), control.draw_o(draws);
    control.ready_o(is_ready);
    root.clk(clk), root.rst_n(rst_n), root.load_i(load), root.step_i(step), root.d_i(v), root.root_o(found);
  }

  void settle() { sc_core::sc_start(1, sc_core::SC_NS); }
  void clock() {
    settle();
    clk.write(true);
    settle();
    clk.write(false);
    settle();
  }

  magnitude<signed_number, unsigned_number> mag{"mag"};
  multiplexer<signed_number, uq<2, 2>, signed_number> mux{"mux"};
  part_decoder<number, part> dec{"dec", kFirst};
  filled_rom<number, word, kWords.size()> rom{"rom", kWords};
  parted_rom<part, place, word, kParts.size()> parts{"parts", kParts, kPresent};
  one_minus<kRadicand> sub{"sub"};
  line_table<kRadicand, square, squares> line{"line"};
  down_counter<pixels> counter{"counter"};
  scan_control control{"control"};
  root_of root{"root"};

  sc_core::sc_signal<bool> clk, rst_n, load, step, ends, selects, carry, loads, first, steps, draws, is_ready;
  wire<signed_number> a, taken;
  wire<unsigned_number> magnitude_of_a;
  wire<uq<2, 2>> b;
  wire<number> n;
  wire<part> decoded, asked_part;
  wire<word> word_at_n, word_at_place;
  wire<place> asked_place;
  wire<unit<kRadicand>> v, rest_of_v;
  wire<square> square_of_v;
  wire<pixels> d;
  wire<uq<1, kRoot>> found;
} bench;

}  // namespace

TEST_CASE("magnitude and multiplexer, for all operands", "[unit][magnitude][multiplexer]") {
  for (std::int64_t a = signed_number::min; a <= signed_number::max; ++a) {
    for (const bool takes_b : {false, true}) {
      bench.a.write(a);
      bench.b.write(a & 15);
      bench.selects.write(takes_b);
      bench.settle();
      CAPTURE(a, takes_b);
      if (a > signed_number::min) CHECK(bench.magnitude_of_a.read().to_int64() == std::abs(a));
      CHECK(bench.taken.read().to_int64() == (takes_b ? a & 15 : a));
    }
  }
}

TEST_CASE("decoder and memories, at all addresses", "[unit][part_decoder][filled_rom][parted_rom]") {
  for (int n = 0; n < 16; ++n) {
    bench.n.write(n);
    bench.settle();
    CAPTURE(n);
    CHECK(bench.decoded.read().to_int64() == (n == 1 || n == 2 ? n : 0));
    CHECK(bench.word_at_n.read().to_int64() == (n > 10 ? 0 : n < 6 ? 5 - n : 69 - n));
  }
  for (int which = 0; which < 4; ++which) {
    for (int at = 0; at < 8; ++at) {
      bench.asked_part.write(which);
      bench.asked_place.write(at);
      bench.settle();
      CAPTURE(which, at);
      CHECK(bench.word_at_place.read().to_int64() == (which < 3 && at < 4 ? 16 + 10 * which - at : 0));
    }
  }
}

TEST_CASE("one_minus and line_table, for all operands", "[unit][one_minus][line_table]") {
  for (int v = 0; v <= 64; ++v) {
    bench.v.write(v);
    bench.settle();
    CAPTURE(v);
    CHECK(bench.rest_of_v.read().to_int64() == 64 - v);
    const int segment = v / 16;  // x^2 is 256 (segment/4)^2 at its beginning
    const double chord = 16.0 * segment * segment + (2 * segment + 1) * (v - 16 * segment);
    CHECK(bench.square_of_v.read().to_int64() == static_cast<int>(std::floor(chord + 0.5)));
  }
}

TEST_CASE("a root is found digit by digit, for all radicands", "[unit][square_root]") {
  bench.rst_n.write(true);
  for (int v = 0; v <= 64; ++v) {
    bench.v.write(v);
    bench.load.write(true);
    bench.step.write(false);
    bench.clock();
    bench.load.write(false);
    bench.step.write(true);
    bench.v.write(21);  // taken no more
    for (int digit = 0; digit < root_of::steps; ++digit) bench.clock();
    CAPTURE(v);
    CHECK(bench.found.read().to_int64() == static_cast<int>(32 * std::sqrt(v / 64.0)));
    bench.step.write(false);
    bench.clock();
    CHECK(bench.found.read().to_int64() == static_cast<int>(32 * std::sqrt(v / 64.0)));
  }
}

TEST_CASE("counter and control follow their next-state tables", "[unit][down_counter][scan_control]") {
  std::mt19937 random(71489);
  int left = 0;
  enum { idle, preparing, drawing } state = idle;
  for (int cycle = 0; cycle < 4000; ++cycle) {
    const bool rst_n = cycle > 0 && random() % 32 != 0;
    const bool load = random() % 4 == 0;
    const bool step = random() % 2 == 0;
    const bool ends = random() % 4 == 0;
    const int d = static_cast<int>(random() % 8);
    bench.rst_n.write(rst_n);
    bench.load.write(load);
    bench.step.write(step);
    bench.ends.write(ends);
    bench.d.write(d);
    bench.settle();
    REQUIRE(bench.loads.read() == (load && (cycle == 0 ? bench.is_ready.read() : state == idle)));
    bench.clock();
    if (!rst_n) {
      left = 0;
      state = idle;
    } else {
      if (load) {
        left = d;
      } else if (step && left > 0) {
        --left;
      }
      if (state == idle) {
        state = load ? preparing : idle;
      } else if (state == preparing) {
        state = drawing;
      } else {
        state = ends ? idle : drawing;
      }
    }
    CAPTURE(cycle);
    REQUIRE(bench.carry.read() == (left < 2));
    REQUIRE(bench.is_ready.read() == (state == idle));
    REQUIRE(bench.first.read() == (state == preparing));
    REQUIRE(bench.draws.read() == (state == drawing));
    REQUIRE(bench.steps.read() == (state != idle));
  }
}
