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

/// The same of a table's first `words` words, and 0 beyond them.
template <std::size_t Most, class T>
constexpr T lookup(const std::array<std::int64_t, Most>& table, std::size_t words, T index) {
  return 0 <= index && static_cast<std::uint64_t>(index) < words
             ? static_cast<T>(table[static_cast<std::size_t>(index)])
             : static_cast<T>(0);
}

/// True if half a unit can be added to any number of `width` bits in 64 bits.
constexpr bool has_headroom(int width) {
  return width < 64;
}

/// True if round_off() overflows no 64-bit integer, for a number of `width` bits without its `bits` lowest ones.
constexpr bool rounds_within(int width, int bits) {
  return bits >= 0 && width <= 64 && (bits != 1 || has_headroom(width));
}

/// Drops `bits` fraction bits, rounds to nearest, ties towards +infinity: floor(x / 2^bits + 1/2).
/// |error| <= 1/2 ulp of the result.
/// \param with_headroom  x + 2^(bits-1) fits T; if not, the bits below the half are dropped before the sum, which takes
///                       longer
template <class T>
constexpr T round_off(T x, int bits, bool with_headroom = true) {
  if (with_headroom) return (x + static_cast<T>(std::int64_t{1} << bits >> 1)) >> bits;
  const int half = bits > 0 ? 1 : 0;  // without bits to drop, nothing is added
  return ((x >> (bits - half)) + static_cast<T>(half)) >> half;
}

/// a * b without its `dropped` lowest fraction bits.
/// \param with_headroom  of the product: see round_off()
template <class T>
constexpr T mul(T a, T b, int dropped, bool with_headroom = true) {
  return round_off(static_cast<T>(a * b), dropped, with_headroom);
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

/// x with `to` fraction bits in place of `from`: exact if they are no fewer, else rounded as by round_off().
template <class T>
constexpr T rescale(T x, int from, int to, bool with_headroom = true) {
  return to >= from ? move_up(x, to - from) : round_off(x, from - to, with_headroom);
}

/// Ones' complement of a, moved up to the fraction bits of the result: -a - 1 ulp.
template <class T>
constexpr T ones_complement(T a, int shift) {
  return ~(a << shift);
}

/// a limited to low..high.
template <class T>
constexpr T clamp(T a, T low, T high) {
  return select(a < low, low, select(a < high, a, high));
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

/// a without its sign.
template <class T>
constexpr T magnitude(T a) {
  return select(a < static_cast<T>(0), static_cast<T>(-a), a);
}

/// The smaller one.
template <class T>
constexpr T smaller(T a, T b) {
  return select(a < b, a, b);
}

/// a, or 0 where `off` is one: each bit through an AND gate.
template <class T>
constexpr T gate(T a, T off) {
  return select(off, static_cast<T>(0), a);
}

/// a - b.
template <class T>
constexpr T subtract(T a, T b) {
  return static_cast<T>(a - b);
}

/// The bits of an unsigned number from `low` on.
template <class T>
constexpr T upper_bits(T a, int low) {
  return static_cast<T>(a >> low);
}

/// The lowest `width` bits of an unsigned number.
template <class T>
constexpr T lower_bits(T a, int width) {
  return static_cast<T>(a & static_cast<T>((std::int64_t{1} << width) - 1));
}

/// 1 if a < 2^place. \param a  not negative
template <class T>
constexpr T is_below_power(T a, int place) {
  return static_cast<T>(a < static_cast<T>(std::int64_t{1} << place));
}

/// a, moved up by `places` within `width` bits where `moves` is one.
template <class T>
constexpr T move_up_within(T moves, T a, int places, int width) {
  return select(moves, lower_bits(move_up(a, places), width), a);
}

/// 1 if b is one, or a is not 0.
template <class T>
constexpr T either(T a, T b) {
  return static_cast<T>(!(a == static_cast<T>(0)) || b);
}

/// a / 2 without the last bit, towards -infinity.
template <class T>
constexpr T halve(T a) {
  return static_cast<T>(a >> 1);
}

/// The first bit of an unsigned number of `width` bits.
template <class T>
constexpr T first_bit(T a, int width) {
  return static_cast<T>(a >> (width - 1));
}

/// The other bits, moved up by one place.
template <class T>
constexpr T other_bits(T a, int width) {
  return static_cast<T>((a << 1) & static_cast<T>((std::int64_t{1} << width) - 1));
}

/// A square root digit by digit. The two bits above the `place` lowest ones of what is left of the radicand, and what is left
/// after them.
template <class T>
constexpr T two_bits(T rest, int place) {
  return upper_bits(rest, place);
}
template <class T>
constexpr T after_two_bits(T rest, int place) {
  return move_up(lower_bits(rest, place), 2);
}
/// The remainder with two more bits of the radicand.
template <class T>
constexpr T longer_remainder(T bits, T remainder) {
  return static_cast<T>((remainder << 2) + bits);
}
/// What a digit of one takes off it: 4 root + 1.
template <class T>
constexpr T root_trial(T root) {
  return static_cast<T>((root << 2) + static_cast<T>(1));
}
/// Remainder and root after a digit.
template <class T>
constexpr T root_remainder(T bits, T remainder, T root) {
  const T longer = longer_remainder(bits, remainder);
  const T trial = root_trial(root);
  return select(longer < trial, longer, static_cast<T>(longer - trial));
}
template <class T>
constexpr T root_digits(T bits, T remainder, T root) {
  const T is_zero = static_cast<T>(longer_remainder(bits, remainder) < root_trial(root));
  return select(is_zero, static_cast<T>(root << 1), static_cast<T>((root << 1) + static_cast<T>(1)));
}

/// Of two bits.
template <class T>
constexpr T both(T a, T b) {
  return static_cast<T>(a && b);
}

/// A counter of steps: an operation starts while none is left.
template <class T>
constexpr T starts(T start, T left) {
  return static_cast<T>(start && left == static_cast<T>(0));
}
template <class T>
constexpr T is_idle(T left) {
  return static_cast<T>(left == static_cast<T>(0));
}
template <class T>
constexpr T is_active(T left) {
  return static_cast<T>(!(left == static_cast<T>(0)));
}
template <class T>
constexpr T is_last(T left) {
  return static_cast<T>(left == static_cast<T>(1));
}
/// left - 1, and 0 after 0.
template <class T>
constexpr T one_less(T left) {
  return select(is_idle(left), left, static_cast<T>(left - static_cast<T>(1)));
}

/// Steps left after a clock edge: `steps` if an operation starts, else one less than before, down to 0.
template <class T>
constexpr T count_down(T start, T steps, T left) {
  return select(starts(start, left), steps, one_less(left));
}

/// True at the clock edge that ends a strobe: it was at one, it is at zero.
template <class T>
constexpr T trailing_edge(T now, T before) {
  return before && !now;
}

}  // namespace blysk::law
