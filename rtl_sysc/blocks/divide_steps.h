// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/divide.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Restoring divider, a digit with each clock cycle: q_o = a_i / b_i, rounded down, for a_i <= b_i. It is the row of divide
/// in time: one subtractor, whose difference is kept if it is not negative.
///
/// Instances  div of the restoring divider and of iterative devices.
/// Formats    those of divide, whose quotient this is.
/// Timing     at a rising edge of clk: while load_i is one it takes a_i and b_i and finds the first digit; else, while step_i
///            is one, it finds the next one. After the load and Q::frac steps q_o is the quotient.
/// Reset      rst_n low at a rising edge of clk: 0.
template <class A, class B, class Q>
struct divide_steps : sc_core::sc_module {
  using row = divide<A, B, Q>;
  using rest_number = uq<row::width + 1, 0>;  // what is left of the dividend, moved up by a place
  using divisor_number = uq<row::width, 0>;
  static constexpr int steps = Q::frac;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(load_i);
  sc_core::sc_in<bool> SC_NAMED(step_i);
  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<typename B::raw_t> SC_NAMED(b_i);
  sc_core::sc_out<typename Q::raw_t> SC_NAMED(q_o);

  SC_CTOR(divide_steps) {
    BLYSK_CLOCKED(find_digit);
    SC_METHOD(show);
    sensitive << digits;
  }

  template <class T>
  static constexpr T rest_now(T load, T a, T rest) {
    using law::select;
    return select(load, law::move_up(a, row::a_shift), rest);
  }
  template <class T>
  static constexpr T divisor_now(T load, T b, T divisor) {
    using law::select;
    return select(load, row::aligned(b), divisor);
  }
  /// The digits after one more, from the remainder and the divisor of now.
  template <class T>
  static constexpr T next_digits(T load, T is_less, T digits) {
    using law::select;
    const T before = select(load, static_cast<T>(0), law::other_bits(digits, Q::width));
    return before | law::is_idle(is_less);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("divide_steps",
                    "Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.");
    const auto load = reader.read(load_i);
    const auto now = rest_now(load, reader.read(a_i, A{}), reader.read(rest));
    const auto by = divisor_now(load, reader.read(b_i, B{}), reader.read(divisor));
    const auto found = reader.read(digits);
    const auto is_less = now < by;
    const auto goes_on = load || reader.read(step_i);
    reader.reg(clk, rst_n, goes_on, law::rest_after_digit(is_less, now, by, row::width), rest, rest_number{});
    reader.reg(clk, rst_n, goes_on, by, divisor, divisor_number{});
    reader.reg(clk, rst_n, goes_on, next_digits(load, is_less, found), digits, Q{});
    reader.drive(q_o, found, Q{});
  }

 private:
  BLYSK_CLOCKED_BODY(find_digit)
  void find_digit() {
    if (!rst_n.read()) {
      rest.write(0);
      divisor.write(0);
      digits.write(0);
    } else if (load_i.read() || step_i.read()) {
      const std::int64_t load = load_i.read() ? 1 : 0;
      const std::int64_t now = rest_now<std::int64_t>(load, a_i.read().to_int64(), rest.read().to_int64());
      const std::int64_t by =
          divisor_now<std::int64_t>(load, b_i.read().to_int64(), divisor.read().to_int64());
      const std::int64_t is_less = now < by ? 1 : 0;
      rest.write(law::rest_after_digit(is_less, now, by, row::width));
      divisor.write(by);
      digits.write(next_digits<std::int64_t>(load, is_less, digits.read().to_int64()));
    }
  }
  void show() { q_o.write(digits.read()); }

  sc_core::sc_signal<typename rest_number::raw_t> SC_NAMED(rest);
  sc_core::sc_signal<typename divisor_number::raw_t> SC_NAMED(divisor);
  sc_core::sc_signal<typename Q::raw_t> SC_NAMED(digits);
};

/// The divider that is a row in time.
/// \tparam Row  a divide
template <class Row>
struct in_steps;
template <class A, class B, class Q>
struct in_steps<divide<A, B, Q>> {
  using type = divide_steps<A, B, Q>;
};

}  // namespace blysk
