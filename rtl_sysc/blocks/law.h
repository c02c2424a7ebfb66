// SPDX-License-Identifier: Apache-2.0
/// The arithmetic that several blocks share, for any value type T with the operators of a C++ integer:
/// std::int64_t in the processes and in the bit-accurate model, a symbolic value in the Verilog export.
#pragma once

namespace blysk::law {

/// condition ? a : b. A symbolic type brings its own overload.
template <class T>
constexpr T select(bool condition, T a, T b) {
  return condition ? a : b;
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
