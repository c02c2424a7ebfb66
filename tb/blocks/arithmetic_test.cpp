// SPDX-License-Identifier: Apache-2.0
// Blocks without a clock, at widths small enough to try every input against real arithmetic in double, which is exact
// for them (all values have less than 53 bits).
#include <cmath>

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/buffer.h"
#include "rtl_sysc/blocks/compare.h"
#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/blocks/divide.h"
#include "rtl_sysc/blocks/either.h"
#include "rtl_sysc/blocks/field.h"
#include "rtl_sysc/blocks/inverter_bank.h"
#include "rtl_sysc/blocks/key.h"
#include "rtl_sysc/blocks/move_point.h"
#include "rtl_sysc/blocks/mul.h"
#include "rtl_sysc/blocks/normalise.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/blocks/rescale.h"
#include "rtl_sysc/blocks/shift_right.h"
#include "rtl_sysc/blocks/sign.h"
#include "tb/catch.h"

// SystemC's own objects, compiled by g++, refer to parts of this class that clang leaves out at -O3 otherwise.
template class sc_core::sc_signal<bool>;

namespace {

using namespace blysk;

/// SystemC elaborates once, so every bench is a static object; this lets the delta cycles that writes cause run.
void settle() {
  sc_core::sc_start(1, sc_core::SC_NS);
}

template <class Q>
double real(std::int64_t raw) {
  return std::ldexp(static_cast<double>(raw), -Q::frac);
}

/// x rounded to Q's fraction bits, to nearest, ties towards +infinity; raw.
template <class Q>
std::int64_t rounded(double x) {
  return static_cast<std::int64_t>(std::floor(std::ldexp(x, Q::frac) + 0.5));
}

template <class Q>
using wire = sc_core::sc_signal<typename Q::raw_t>;

template <class A, class B, class P>
struct mul_bench {
  explicit mul_bench(const char* name) : block(name) { block.a_i(a), block.b_i(b), block.p_o(p); }
  mul<A, B, P> block;
  wire<A> a;
  wire<B> b;
  wire<P> p;

  void check_all() {
    for (std::int64_t x = A::min; x <= A::max; ++x) {
      for (std::int64_t y = B::min; y <= B::max; ++y) {
        a.write(x);
        b.write(y);
        settle();
        const std::int64_t expected = rounded<P>(real<A>(x) * real<B>(y));
        if (p.read().to_int64() != expected) {
          CAPTURE(x, y, p.read().to_int64(), expected);
          FAIL("mul");
        }
      }
    }
  }
};

mul_bench<uq<3, 2>, sq<0, 4>, sq<3, 6>> mixed_mul("mixed_mul");      // signs mixed, exact, as mul10
mul_bench<uq<4, 0>, uq<0, 5>, uq<4, 5>> integer_mul("integer_mul");  // as mul6
mul_bench<unit<5>, unit<5>, uq<1, 7>> rounding_mul("rounding_mul");  // rounds, as mul7 from q14 on
mul_bench<sq<3, 2>, uq<4, 0>, sq<7, 2>> signed_mul("signed_mul");    // as mul12 as published
mul_bench<sq<1, 3>, sq<1, 3>, sq<3, 4>> rounding_signed_mul("rounding_signed_mul");

TEST_CASE("mul is exact, or rounds to nearest, for all operands", "[unit][mul]") {
  SECTION("unsigned by signed") {
    mixed_mul.check_all();
  }
  SECTION("integer by fraction") {
    integer_mul.check_all();
  }
  SECTION("rounded unsigned") {
    rounding_mul.check_all();
  }
  SECTION("signed by unsigned") {
    signed_mul.check_all();
  }
  SECTION("rounded signed") {
    rounding_signed_mul.check_all();
  }
}

TEST_CASE("mul10 is exact at the ends of q24's formats", "[unit][mul]") {
  using a = uq<10, 20>;
  using diff = sq<-2, 35>;
  STATIC_REQUIRE(product_of<a, diff>::width == 64);
  // diff::min is a power of two, so the product is a shift and -2^63 <= product.
  STATIC_REQUIRE(diff::min == -(std::int64_t{1} << 33));
  CHECK(mul<a, diff, product_of<a, diff>>::law(a::max, diff::min) == -(a::max << 33));
}

/// \tparam CarryFrac  the carry weighs 2^-CarryFrac
template <class A, class B, class S, int CarryFrac = S::frac>
struct add_bench {
  explicit add_bench(const char* name) : block(name) {
    block.a_i(a), block.b_i(b), block.carry_i(carry), block.s_o(s);
  }
  add<A, B, S, CarryFrac> block;
  wire<A> a;
  wire<B> b;
  wire<uq<1, 0>> carry;
  wire<S> s;

  void check_all() {
    for (std::int64_t x = A::min; x <= A::max; ++x) {
      for (std::int64_t y = B::min; y <= B::max; ++y) {
        for (int c = 0; c <= 1; ++c) {
          a.write(x);
          b.write(y);
          carry.write(static_cast<unsigned>(c));
          settle();
          const std::int64_t expected = rounded<S>(real<A>(x) + real<B>(y) + std::ldexp(c, -CarryFrac));
          if (s.read().to_int64() != expected) {
            CAPTURE(x, y, c, s.read().to_int64(), expected);
            FAIL("add");
          }
        }
      }
    }
  }
};

add_bench<uq<1, 6>, sq<1, 6>, sq<2, 6>> aligned_add("aligned_add");             // as add9
add_bench<sq<3, 5>, unit<3>, sq<4, 5>> shifted_add("shifted_add");              // as add11
add_bench<uq<3, 4>, sq<0, 1>, sq<4, 4>> offset_add("offset_add");               // as add15
add_bench<unit<5>, sq<0, 0>, sq<0, 5>> minus_one_add("minus_one_add");          // as add6 of [T] fig. 3.1
add_bench<sq<3, 4>, uq<1, 0>, sq<4, 4>, 0> unity_carry_add("unity_carry_add");  // as its add8

TEST_CASE("add is exact for all operands and both carries", "[unit][add]") {
  SECTION("same fraction bits") {
    aligned_add.check_all();
  }
  SECTION("second operand aligned") {
    shifted_add.check_all();
  }
  SECTION("half a unit") {
    offset_add.check_all();
  }
  SECTION("a carry of unity") {
    unity_carry_add.check_all();
  }
}

TEST_CASE("all ones of weight 1 subtract 1", "[unit][add]") {
  for (std::int64_t code = 0; code <= unit<5>::max; ++code) {
    minus_one_add.a.write(code);
    minus_one_add.b.write(-1);
    minus_one_add.carry.write(0);
    settle();
    CAPTURE(code);
    REQUIRE(minus_one_add.s.read().to_int64() == code - 32);
  }
}

template <class A, class Y>
struct inverter_bench {
  explicit inverter_bench(const char* name) : block(name) { block.a_i(a), block.y_o(y); }
  inverter_bank<A, Y> block;
  wire<A> a;
  wire<Y> y;
};

inverter_bench<unit<8>, sq<1, 8>> inverter("inverter");
inverter_bench<unit<8>, sq<1, 16>> wide_inverter("wide_inverter");

TEST_CASE("inverter_bank with a carry of one ulp negates every code", "[unit][inverter_bank]") {
  for (unsigned code = 0; code <= 256; ++code) {
    inverter.a.write(code);
    wide_inverter.a.write(code);
    settle();
    CAPTURE(code);
    REQUIRE(inverter.y.read().to_int64() + 1 == -static_cast<std::int64_t>(code));
    REQUIRE(wide_inverter.y.read().to_int64() + 1 == -256 * static_cast<std::int64_t>(code));
    for (int bit = 0; bit <= 8; ++bit) REQUIRE(inverter.y.read()[bit] == !inverter.a.read()[bit]);
  }
}

template <class A, class Y, overflow Overflow>
struct quantise_bench {
  explicit quantise_bench(const char* name) : block(name) { block.a_i(a), block.y_o(y); }
  quantise<A, Y, Overflow> block;
  wire<A> a;
  wire<Y> y;
};

quantise_bench<sq<4, 8>, unit<4>, overflow::clamp> clamping("clamping");
quantise_bench<sq<4, 8>, sq<5, 4>, overflow::excluded> rounding("rounding");
quantise_bench<sq<4, 4>, unit<4>, overflow::clamp> clamping_only("clamping_only");

TEST_CASE("quantise rounds to nearest and clamps to [0, 1] for all operands", "[unit][quantise]") {
  for (std::int64_t x = sq<4, 8>::min; x <= sq<4, 8>::max; ++x) {
    clamping.a.write(x);
    rounding.a.write(x);
    settle();
    const std::int64_t nearest = rounded<unit<4>>(real<sq<4, 8>>(x));
    CAPTURE(x);
    REQUIRE(clamping.y.read().to_int64() == (nearest < 0 ? 0 : nearest > 16 ? 16 : nearest));
    REQUIRE(rounding.y.read().to_int64() == nearest);
  }
  for (std::int64_t x = sq<4, 4>::min; x <= sq<4, 4>::max; ++x) {
    clamping_only.a.write(x);
    settle();
    CAPTURE(x);
    REQUIRE(clamping_only.y.read().to_int64() == (x < 0 ? 0 : x > 16 ? 16 : x));
  }
}

template <class A, class Y>
struct rescale_bench {
  explicit rescale_bench(const char* name) : block(name) { block.a_i(a), block.y_o(y); }
  rescale<A, Y> block;
  wire<A> a;
  wire<Y> y;
};

rescale_bench<sq<4, 4>, sq<4, 8>> finer("finer");
rescale_bench<sq<4, 8>, sq<5, 4>> coarser("coarser");

TEST_CASE("rescale is exact or rounds to nearest for all operands", "[unit][rescale]") {
  for (std::int64_t x = sq<4, 8>::min; x <= sq<4, 8>::max; ++x) {
    coarser.a.write(x);
    settle();
    CAPTURE(x);
    const std::int64_t nearest = rounded<sq<5, 4>>(real<sq<4, 8>>(x));
    REQUIRE(coarser.y.read().to_int64() == nearest);
  }
  for (std::int64_t x = sq<4, 4>::min; x <= sq<4, 4>::max; ++x) {
    finer.a.write(x);
    settle();
    CAPTURE(x);
    const double same = real<sq<4, 8>>(finer.y.read().to_int64());
    REQUIRE(same == real<sq<4, 4>>(x));
  }
}

struct constant_bench {
  explicit constant_bench(const char* name) : block(name, -1) { block.y_o(y); }
  constant<sq<0, 1>> block;
  wire<sq<0, 1>> y;
};

struct buffer_bench {
  explicit buffer_bench(const char* name) : block(name) { block.a_i(a), block.y_o(y); }
  buffer block;
  sc_core::sc_signal<bool> a, y;
};

constant_bench minus_half("minus_half");
buffer_bench strobe("strobe");

TEST_CASE("constant drives its bits, buffer follows its input", "[unit][constant][buffer]") {
  settle();
  CHECK(real<sq<0, 1>>(minus_half.y.read().to_int64()) == -0.5);
  for (const bool level : {true, false, true}) {
    strobe.a.write(level);
    settle();
    CHECK(strobe.y.read() == level);
  }
}

template <class A, class B>
struct compare_bench {
  explicit compare_bench(const char* name) : block(name) { block.a_i(a), block.b_i(b), block.below_o(below); }
  compare<A, B> block;
  wire<A> a;
  wire<B> b;
  sc_core::sc_signal<bool> below;

  void check_all() {
    for (std::int64_t x = A::min; x <= A::max; ++x) {
      for (std::int64_t y = B::min; y <= B::max; ++y) {
        a.write(x);
        b.write(y);
        settle();
        if (below.read() != (real<A>(x) < real<B>(y))) {
          CAPTURE(x, y);
          FAIL("compare");
        }
      }
    }
  }
};

compare_bench<uq<3, 4>, uq<-1, 4>> limit_compare("limit_compare");  // as cmp11 of [T] fig. 3.1
compare_bench<sq<2, 2>, uq<2, 4>> signed_compare("signed_compare");

TEST_CASE("compare says which number is less, for all operands", "[unit][compare]") {
  SECTION("same fraction bits") {
    limit_compare.check_all();
  }
  SECTION("aligned, signs mixed") {
    signed_compare.check_all();
  }
}

struct sign_bench {
  explicit sign_bench(const char* name) : block(name) { block.a_i(a), block.negative_o(negative); }
  sign<sq<3, 4>> block;
  wire<sq<3, 4>> a;
  sc_core::sc_signal<bool> negative;
};

struct key_bench {
  explicit key_bench(const char* name) : block(name) { block.a_i(a), block.off_i(off), block.y_o(y); }
  key<unit<6>> block;
  wire<unit<6>> a, y;
  sc_core::sc_signal<bool> off;
};

sign_bench sign_of_line("sign_of_line");
key_bench key_block("key_block");

TEST_CASE("sign tells negative numbers, for all of them", "[unit][sign]") {
  for (std::int64_t x = sq<3, 4>::min; x <= sq<3, 4>::max; ++x) {
    sign_of_line.a.write(x);
    settle();
    CAPTURE(x);
    REQUIRE(sign_of_line.negative.read() == (x < 0));
  }
}

TEST_CASE("a key block passes all bits or none", "[unit][key]") {
  for (std::int64_t x = 0; x < 128; ++x) {
    for (const bool off : {false, true}) {
      key_block.a.write(x);
      key_block.off.write(off);
      settle();
      CAPTURE(x, off);
      REQUIRE(key_block.y.read().to_int64() == (off ? 0 : x));
    }
  }
}

struct field_bench {
  explicit field_bench(const char* name) : middle(name), top("top_field") {
    middle.a_i(a), middle.y_o(y);
    top.a_i(a), top.y_o(high);
  }
  field<uq<4, 4>, uq<3, 0>, 2> middle;
  field<uq<4, 4>, uq<5, 0>, 3> top;
  wire<uq<4, 4>> a;
  wire<uq<3, 0>> y;
  wire<uq<5, 0>> high;
};

struct either_bench {
  explicit either_bench(const char* name) : block(name) { block.a_i(a), block.b_i(b), block.y_o(y); }
  either<uq<4, 0>> block;
  wire<uq<4, 0>> a;
  sc_core::sc_signal<bool> b, y;
};

template <int F, class Count>
struct normalise_bench {
  explicit normalise_bench(const char* name) : block(name) {
    block.a_i(a), block.m_o(m), block.zeros_o(zeros), block.zero_o(zero);
  }
  normalise<F, Count> block;
  wire<unit<F>> a;
  wire<uq<2, F - 1>> m;
  wire<Count> zeros;
  sc_core::sc_signal<bool> zero;

  void check_all() {
    for (unsigned code = 0; code <= (1u << F); ++code) {
      a.write(code);
      settle();
      CAPTURE(code);
      REQUIRE(zero.read() == (code == 0));
      const double mantissa = real<uq<2, F - 1>>(m.read().to_int64());
      REQUIRE(mantissa >= 1);
      REQUIRE((mantissa < 2 || code == 1u << F));
      if (code == 0) {
        REQUIRE(mantissa == 1);
        REQUIRE(zeros.read().to_int64() == Count::max);
      } else {
        REQUIRE(std::ldexp(mantissa, -1 - zeros.read().to_int()) == real<unit<F>>(code));
      }
    }
  }
};

struct shift_right_bench {
  explicit shift_right_bench(const char* name) : block(name) {
    block.a_i(a), block.places_i(places), block.y_o(y);
  }
  shift_right<uq<1, 6>, uq<4, 0>> block;
  wire<uq<1, 6>> a, y;
  wire<uq<4, 0>> places;
};

field_bench middle_field("middle_field");
either_bench either_gate("either_gate");
normalise_bench<8, uq<3, 0>> normalise_8("normalise_8");
normalise_bench<10, uq<4, 0>> normalise_10("normalise_10");
shift_right_bench shifter("shifter");

struct move_point_bench {
  explicit move_point_bench(const char* name) : block(name) { block.a_i(a), block.y_o(y); }
  move_point<uq<6, 0>, uq<4, 2>> block;
  wire<uq<6, 0>> a;
  wire<uq<4, 2>> y;
};

move_point_bench quarter("quarter");

TEST_CASE("move_point divides by a power of two", "[unit][move_point]") {
  for (unsigned x = 0; x < 64; ++x) {
    quarter.a.write(x);
    settle();
    CAPTURE(x);
    REQUIRE(real<uq<4, 2>>(quarter.y.read().to_int64()) == x / 4.0);
  }
}

TEST_CASE("field takes bits out of every number", "[unit][field]") {
  for (unsigned x = 0; x < 256; ++x) {
    middle_field.a.write(x);
    settle();
    CAPTURE(x);
    REQUIRE(middle_field.y.read().to_uint() == x / 4 % 8);
    REQUIRE(middle_field.high.read().to_uint() == x / 8);
  }
}

TEST_CASE("either is one for any bit", "[unit][either]") {
  for (unsigned x = 0; x < 16; ++x) {
    for (const bool b : {false, true}) {
      either_gate.a.write(x);
      either_gate.b.write(b);
      settle();
      CAPTURE(x, b);
      REQUIRE(either_gate.y.read() == (x > 0 || b));
    }
  }
}

TEST_CASE("normalise finds exponent and mantissa of every code", "[unit][normalise]") {
  SECTION("as many zeros as counts") {
    normalise_8.check_all();
  }
  SECTION("fewer") {
    normalise_10.check_all();
  }
}

TEST_CASE("shift_right divides by powers of two, rounding down", "[unit][shift_right]") {
  for (unsigned x = 0; x < 128; ++x) {
    for (unsigned places = 0; places < 16; ++places) {
      shifter.a.write(x);
      shifter.places.write(places);
      settle();
      CAPTURE(x, places);
      REQUIRE(shifter.y.read().to_int64() ==
              static_cast<std::int64_t>(std::floor(std::ldexp(x, -static_cast<int>(places)))));
    }
  }
}

template <class A, class B>
struct divide_bench {
  explicit divide_bench(const char* name) : block(name) { block.a_i(a), block.b_i(b), block.q_o(q); }
  divide<A, B, unit<6>> block;
  wire<A> a;
  wire<B> b;
  wire<unit<6>> q;
};

divide_bench<unit<4>, uq<3, 4>> divider("divider");
divide_bench<unit<4>, uq<3, 6>> moved_divider("moved_divider");

TEST_CASE("divide rounds the quotient down, for all operands whose quotient is at most 1", "[unit][divide]") {
  for (unsigned b = 1; b < 128; ++b) {
    for (unsigned a = 0; a <= b && a < 32; ++a) {
      divider.a.write(a);
      divider.b.write(b);
      settle();
      CAPTURE(a, b);
      REQUIRE(divider.q.read().to_uint() == a * 64 / b);
    }
  }
  // 0 / 0: every difference is 0, none is negative.
  divider.a.write(0);
  divider.b.write(0);
  settle();
  CHECK(divider.q.read().to_uint() == 127);
}

TEST_CASE("divide moves up a dividend with fewer fraction bits", "[unit][divide]") {
  for (unsigned b = 1; b < 512; ++b) {
    for (unsigned a = 0; 4 * a <= b && a < 32; ++a) {
      moved_divider.a.write(a);
      moved_divider.b.write(b);
      settle();
      CAPTURE(a, b);
      REQUIRE(moved_divider.q.read().to_uint() == 4 * a * 64 / b);
    }
  }
}

}  // namespace
