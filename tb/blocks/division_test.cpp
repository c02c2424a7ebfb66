// SPDX-License-Identifier: Apache-2.0
// Both forms of the divider, the row of subtractors and the one that takes a digit each clock cycle, against division of
// integers; the sign that a quotient gets.
#include <random>

#include "rtl_sysc/blocks/divide.h"
#include "rtl_sysc/blocks/divide_steps.h"
#include "rtl_sysc/blocks/with_sign.h"
#include "tb/catch.h"

// SystemC's own objects, compiled by g++, refer to parts of this class that clang leaves out at -O3 otherwise.
template class sc_core::sc_signal<bool>;

namespace {

using namespace blysk;

/// The dividers of one set of formats.
template <class A, class B, class Q>
struct dividers {
  using row_type = divide<A, B, Q>;
  using steps_type = divide_steps<A, B, Q>;

  explicit dividers(const std::string& name)
      : row((name + "_row").c_str()), steps((name + "_steps").c_str()) {
    row.a_i(a), row.b_i(b), row.q_o(at_once);
    steps.clk(clk), steps.rst_n(rst_n), steps.load_i(load), steps.step_i(step);
    steps.a_i(a), steps.b_i(b), steps.q_o(digits);
  }

  void clock() {
    sc_core::sc_start(1, sc_core::SC_NS);
    clk.write(true);
    sc_core::sc_start(1, sc_core::SC_NS);
    clk.write(false);
    sc_core::sc_start(1, sc_core::SC_NS);
  }

  void put(std::int64_t dividend, std::int64_t divisor) {
    a.write(static_cast<std::uint64_t>(dividend));
    b.write(static_cast<std::uint64_t>(divisor));
  }

  /// The quotient of both, after the clock edges that the steps need.
  std::int64_t divided(std::int64_t dividend, std::int64_t divisor) {
    rst_n.write(true);
    put(dividend, divisor);
    load.write(true);
    step.write(false);
    clock();
    load.write(false);
    step.write(true);
    const std::int64_t quotient = at_once.read().to_int64();
    put(0, 1);  // the inputs need not stay
    for (int i = 0; i < steps_type::steps; ++i) clock();
    step.write(false);
    REQUIRE(digits.read().to_int64() == quotient);
    clock();  // and without a step it stays
    REQUIRE(digits.read().to_int64() == quotient);
    return quotient;
  }

  /// a / b of the numbers that the codes stand for, rounded down to Q.
  static std::int64_t expected(std::int64_t dividend, std::int64_t divisor) {
    const int up = Q::frac + B::frac - A::frac;
    return up >= 0 ? (dividend << up) / divisor : dividend / (divisor << -up);
  }

  row_type row;
  steps_type steps;
  sc_core::sc_signal<bool> clk, rst_n, load, step;
  sc_core::sc_signal<typename A::raw_t> a;
  sc_core::sc_signal<typename B::raw_t> b;
  sc_core::sc_signal<typename Q::raw_t> at_once, digits;
};

struct benches {
  dividers<unit<8>, uq<10, 8>, unit<9>> same{"same"};             // Schlick's lobe, q8
  dividers<uq<1, 4>, uq<3, 6>, uq<1, 7>> finer_divisor{"finer"};  // the dividend moves up
  dividers<uq<0, 8>, uq<10, 0>, uq<1, 16>> whole{"whole"};  // the restoring divider, q8: the divisor does
} bench;

template <class Dividers>
void check(Dividers& dividers, std::int64_t a, std::int64_t b) {
  CAPTURE(a, b);
  REQUIRE(dividers.divided(a, b) == Dividers::expected(a, b));
}

}  // namespace

TEST_CASE("both dividers round the quotient down", "[unit][division]") {
  for (std::int64_t n : {1, 2, 7, 1000}) {  // the codes that Schlick's lobe brings
    for (std::int64_t c = 0; c <= 256; ++c) check(bench.same, c, n * (256 - c) + c);
  }
  for (std::int64_t b = 1; b < 512; b += 3) {
    for (std::int64_t a = 0; a < 32 && 4 * a <= b; ++a) check(bench.finer_divisor, a, b);
  }
  std::mt19937 random(11);
  for (std::int64_t k = 1; k <= 1023; ++k) {
    check(bench.whole, 255, k);
    check(bench.whole, static_cast<std::int64_t>(random() % 256), k);
  }
}

TEST_CASE("a division by zero gives all ones", "[unit][division]") {
  CHECK(bench.same.divided(0, 0) == 1023);
  CHECK(bench.whole.divided(0, 0) == (1 << 17) - 1);
}

TEST_CASE("a load in the midst begins anew, a reset clears", "[unit][division]") {
  auto& of = bench.whole;
  of.rst_n.write(true);
  of.put(200, 3);
  of.load.write(true);
  of.clock();
  of.load.write(false);
  of.step.write(true);
  for (int i = 0; i < 5; ++i) of.clock();
  CHECK(of.divided(100, 7) == (100 << 8) / 7);
  of.rst_n.write(false);
  of.clock();
  CHECK(of.digits.read().to_int64() == 0);
  of.rst_n.write(true);
}

TEST_CASE("a quotient gets its sign", "[unit][division]") {
  using signed_quotient = with_sign<uq<9, 2>, sq<8, 2>>;
  CHECK(signed_quotient::law(std::int64_t(0), std::int64_t(1020)) == 1020);
  CHECK(signed_quotient::law(std::int64_t(1), std::int64_t(1020)) == -1020);
  CHECK(signed_quotient::law(std::int64_t(1), std::int64_t(0)) == 0);
}
