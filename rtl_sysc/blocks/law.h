// SPDX-License-Identifier: Apache-2.0
/// The arithmetic of the blocks, each law once, for any value type T with the operators of a C++ integer: std::int64_t in
/// the processes, narrower integers in the bit-accurate models, a symbolic value in the Verilog export.
///
/// Shifts are arguments: a block passes the constants of its formats, which fold, and a model of any word length passes
/// those of the moment.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace blysk::law {

/// condition ? a : b. A symbolic type brings its own overload.
template <class T>
constexpr T select(bool condition, T a, T b) {
  return condition ? a : b;
}

/// table[index], and 0 beyond its end. A symbolic type brings its own overload.
template <std::size_t Words, class T>
constexpr T lookup(const std::array<std::int64_t, Words>& table, T index) {
  return 0 <= index && static_cast<std::uint64_t>(index) < Words
             ? static_cast<T>(table[static_cast<std::size_t>(index)])
             : static_cast<T>(0);
}

/// Drops `bits` fraction bits, rounds to nearest, ties towards +infinity: floor(x / 2^bits + 1/2).
/// |error| <= 1/2 ulp of the result. The bits below the half go first, so that the sum needs no headroom above x, unless
/// bits is 1: see rounds_within().
/// \tparam To  of the result; it holds x / 2^(bits-1) too
template <class To, class T>
constexpr To round_off_to(T x, int bits) {
  const int half = bits > 0 ? 1 : 0;  // without bits to drop, nothing is added
  return (static_cast<To>(x >> (bits - half)) + static_cast<To>(half)) >> half;
}

/// The same in the operand's type.
template <class T>
constexpr T round_off(T x, int bits) {
  return round_off_to<T>(x, bits);
}

/// True if rounding a number of `width` bits off by `bits` overflows no 64-bit integer.
constexpr bool rounds_within(int width, int bits) {
  return bits >= 0 && width - (bits > 1 ? bits - 1 : 0) + (bits > 0 ? 1 : 0) <= 64;
}

/// a * b without its `dropped` lowest fraction bits.
template <class T>
constexpr T mul(T a, T b, int dropped) {
  return round_off(static_cast<T>(a * b), dropped);
}

/// a + b + carry, the operands moved up to the fraction bits of the sum.
template <class T>
constexpr T add(T a, int a_shift, T b, int b_shift, T carry) {
  return (a << a_shift) + (b << b_shift) + carry;
}

/// x moved up by `shift` places, as wiring does.
template <class T>
constexpr T move_up(T x, int shift) {
  return static_cast<T>(x << shift);
}

/// Ones' complement of a, moved up to the fraction bits of the result: -a - 1 ulp.
template <class T>
constexpr T ones_complement(T a, int shift) {
  return ~(a << shift);
}

/// a limited to low..high.
template <class T>
constexpr T clamp(T a, T low, T high) {
  return select(a < low, low, select(a > high, high, a));
}

/// True if a < b, the operands moved up to the fraction bits of the finer one.
template <class T>
constexpr T below(T a, int a_shift, T b, int b_shift) {
  return static_cast<T>((a << a_shift) < (b << b_shift));
}

/// 1 if a < 0.
template <class T>
constexpr T is_negative(T a) {
  return static_cast<T>(a < static_cast<T>(0));
}

/// a, or 0 where `off` is one: each bit through an AND gate.
template <class T>
constexpr T gate(T a, T off) {
  return select(off, static_cast<T>(0), a);
}

/// True at the clock edge that ends a strobe: it was at one, it is at zero.
template <class T>
constexpr T trailing_edge(T now, T before) {
  return before && !now;
}

}  // namespace blysk::law
