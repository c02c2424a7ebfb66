// SPDX-License-Identifier: Apache-2.0
/// The arithmetic that several blocks share, for any value type T with the operators of a C++ integer:
/// std::int64_t in the processes and in the bit-accurate model, a symbolic value in the Verilog export.
#pragma once

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
constexpr T lookup(const std::int64_t (&table)[Words], T index) {
  return 0 <= index && static_cast<std::uint64_t>(index) < Words ? T{table[index]} : T{0};
}

/// Drops `Bits` fraction bits, rounds to nearest, ties towards +infinity: floor(x / 2^Bits + 1/2).
/// |error| <= 1/2 ulp of the result.
template <int Bits, class T>
constexpr T round_off(T x) {
  static_assert(Bits >= 0, "the result cannot have more fraction bits than the operand");
  if constexpr (Bits == 0) {
    return x;
  } else {
    return (x + (T{1} << (Bits - 1))) >> Bits;
  }
}

}  // namespace blysk::law
