// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Square root, a digit with each step, as it is done by hand: the next two bits of the radicand come to the remainder, and
/// the next digit is one if the root with a one behind it can be taken off.
///
/// Instances  root of the arc cosine.
/// Formats    d_i: unit<Frac>, Frac even; root_o: UQ1.RootFrac, 2 RootFrac >= Frac.
/// Timing     at a rising edge of clk: while load_i is one it takes d_i; else, while step_i is one, it finds a digit. After
///            RootFrac + 1 steps root_o is the root, rounded down.
/// Reset      rst_n low at a rising edge of clk: 0.
template <int Frac, int RootFrac>
struct square_root_steps : sc_core::sc_module {
  static_assert(Frac % 2 == 0 && 2 * RootFrac >= Frac);
  using radicand = unit<Frac>;
  using root_number = uq<1, RootFrac>;
  using rest_number = uq<2, Frac>;               // bits of the radicand that are left
  using remainder_number = uq<2 + RootFrac, 0>;  // at most twice the digits found
  static constexpr int steps = RootFrac + 1;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(load_i);
  sc_core::sc_in<bool> SC_NAMED(step_i);
  sc_core::sc_in<typename radicand::raw_t> SC_NAMED(d_i);
  sc_core::sc_out<typename root_number::raw_t> SC_NAMED(root_o);

  SC_CTOR(square_root_steps) {
    BLYSK_CLOCKED(find_digit);
    SC_METHOD(show);
    sensitive << digits;
  }

  template <class T>
  static constexpr T next_rest(T load, T d, T rest) {
    using law::select;
    return select(load, d, law::after_two_bits(rest, Frac));
  }
  template <class T>
  static constexpr T next_remainder(T load, T rest, T remainder, T root) {
    using law::select;
    return select(load, static_cast<T>(0), law::root_remainder(law::two_bits(rest, Frac), remainder, root));
  }
  template <class T>
  static constexpr T next_root(T load, T rest, T remainder, T root) {
    using law::select;
    return select(load, static_cast<T>(0), law::root_digits(law::two_bits(rest, Frac), remainder, root));
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("square_root_steps", "Square root: takes d_i while load_i is one, else finds a digit.");
    const auto load = reader.read(load_i);
    const auto d = reader.read(d_i, radicand{});
    const auto bits = reader.read(rest);
    const auto left = reader.read(remainder);
    const auto found = reader.read(digits);
    const auto goes_on = load || reader.read(step_i);
    reader.reg(clk, rst_n, goes_on, next_rest(load, d, bits), rest, rest_number{});
    reader.reg(clk, rst_n, goes_on, next_remainder(load, bits, left, found), remainder, remainder_number{});
    reader.reg(clk, rst_n, goes_on, next_root(load, bits, left, found), digits, root_number{});
    reader.drive(root_o, found, root_number{});
  }

 private:
  BLYSK_CLOCKED_BODY(find_digit)
  void find_digit() {
    if (!rst_n.read()) {
      rest.write(0);
      remainder.write(0);
      digits.write(0);
    } else if (load_i.read() || step_i.read()) {
      const std::int64_t load = load_i.read() ? 1 : 0;
      const std::int64_t bits = rest.read().to_int64();
      const std::int64_t left = remainder.read().to_int64();
      const std::int64_t found = digits.read().to_int64();
      rest.write(next_rest<std::int64_t>(load, d_i.read().to_int64(), bits));
      remainder.write(next_remainder<std::int64_t>(load, bits, left, found));
      digits.write(next_root<std::int64_t>(load, bits, left, found));
    }
  }
  void show() { root_o.write(digits.read()); }

  sc_core::sc_signal<typename rest_number::raw_t> SC_NAMED(rest);
  sc_core::sc_signal<typename remainder_number::raw_t> SC_NAMED(remainder);
  sc_core::sc_signal<typename root_number::raw_t> SC_NAMED(digits);
};

}  // namespace blysk
