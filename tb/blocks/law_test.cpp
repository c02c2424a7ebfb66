// SPDX-License-Identifier: Apache-2.0
// The laws with shifts of the moment, at both ends of their integers.
#include <array>
#include <limits>
#include <utility>

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"
#include "tb/catch.h"

namespace {

using namespace blysk;
__extension__ typedef __int128 wide;  // NOLINT(modernize-use-using): __extension__ takes no alias

/// floor(x / 2^bits + 1/2)
constexpr wide rounded(wide x, int bits) {
  return bits == 0 ? x : (x + (wide{1} << (bits - 1))) >> bits;
}

/// Rounds at both ends of a range that leaves as much headroom as asked, and around 0.
template <class T>
constexpr bool rounds_at_ends(int bits, bool with_headroom) {
  // Rounding off one bit always needs one more above.
  const wide reserve = with_headroom ? (wide{1} << bits >> 1) : bits == 1 ? 1 : 0;
  const T low = std::numeric_limits<T>::min();
  const T high = static_cast<T>(std::numeric_limits<T>::max() - reserve);
  for (int i = 0; i < 1024; ++i) {
    for (const T x : {static_cast<T>(low + i), static_cast<T>(i - 512), static_cast<T>(high - i)}) {
      if (wide{law::round_off<T>(x, bits, with_headroom)} != rounded(x, bits)) return false;
    }
  }
  return true;
}

/// At compile time an overflow is an error.
template <class T, int... Bits>
constexpr bool rounds_without_overflow(std::integer_sequence<int, Bits...>) {
  return ((rounds_at_ends<T>(Bits, false) && rounds_at_ends<T>(Bits, true)) && ...);
}
static_assert(rounds_without_overflow<std::int64_t>(std::make_integer_sequence<int, 9>{}));
static_assert(rounds_without_overflow<std::int32_t>(std::make_integer_sequence<int, 9>{}));

}  // namespace

TEST_CASE("round_off is floor(x / 2^bits + 1/2), ties up, whatever the bits", "[law]") {
  for (int bits = 0; bits <= 62; ++bits) {
    CAPTURE(bits);
    for (const bool with_headroom : {false, true}) {
      CHECK(rounds_at_ends<std::int64_t>(bits, with_headroom));
      if (bits <= 30) CHECK(rounds_at_ends<std::int32_t>(bits, with_headroom));
    }
  }
  CHECK(law::round_off<std::int64_t>(-3, 1) == -1);
  CHECK(law::round_off<std::int64_t>(3, 1) == 2);
  CHECK(law::round_off<std::int64_t>(2, 2) == 1);
  CHECK(law::round_off<std::int64_t>(-2, 2) == 0);
}

TEST_CASE("has_headroom and rounds_within say where rounding overflows 64 bits", "[law]") {
  constexpr wide limit = std::numeric_limits<std::int64_t>::max();
  for (int width = 1; width <= 70; ++width) {
    const wide largest = (wide{1} << (width - 1)) - 1;
    CAPTURE(width);
    // The half is at most as large as the number: more is never rounded away.
    CHECK(law::has_headroom(width) == (largest + (wide{1} << (width - 1) >> 1) <= limit));
    for (int bits = 0; bits <= 10; ++bits) {
      CAPTURE(bits);
      const wide sum = bits == 0 ? largest : (largest >> (bits - 1)) + 1;
      CHECK(law::rounds_within(width, bits) == (largest <= limit && sum <= limit));
    }
  }
  CHECK_FALSE(law::rounds_within(8, -1));
}

TEST_CASE("rescale is exact upwards and rounds downwards", "[law]") {
  for (int from = 0; from <= 12; ++from) {
    for (int to = 0; to <= 12; ++to) {
      for (int x = -600; x <= 600; ++x) {
        CAPTURE(from, to, x);
        const wide expected = to >= from ? wide{x} * (1 << (to - from)) : rounded(x, from - to);
        REQUIRE(law::rescale<std::int64_t>(x, from, to) == static_cast<std::int64_t>(expected));
        REQUIRE(law::rescale<std::int64_t>(x, from, to, false) == static_cast<std::int64_t>(expected));
      }
    }
  }
}

TEST_CASE("mul drops what it is told, whatever the integer", "[law]") {
  for (int dropped = 0; dropped <= 8; ++dropped) {
    for (int a = -40; a <= 40; ++a) {
      for (int b = -40; b <= 40; ++b) {
        CAPTURE(dropped, a, b);
        REQUIRE(law::mul<std::int64_t>(a, b, dropped) == static_cast<std::int64_t>(rounded(a * b, dropped)));
        REQUIRE(law::mul<std::int32_t>(a, b, dropped) == static_cast<std::int32_t>(rounded(a * b, dropped)));
      }
    }
  }
}

TEST_CASE("add and ones_complement move their operands up", "[law]") {
  for (int shift = 0; shift <= 8; ++shift) {
    for (int a = -40; a <= 40; ++a) {
      CAPTURE(shift, a);
      REQUIRE(law::add<std::int64_t>(a, shift, 3, 0, 1) == (std::int64_t{a} << shift) + 4);
      REQUIRE(law::add<std::int64_t>(3, 0, a, shift, 0) == (std::int64_t{a} << shift) + 3);
      REQUIRE(law::ones_complement<std::int64_t>(a, shift) == -(std::int64_t{a} << shift) - 1);
    }
  }
}

TEST_CASE("clamp, select, lookup and trailing_edge", "[law]") {
  for (int x = -5; x <= 5; ++x) CHECK(law::clamp(x, -2, 3) == (x < -2 ? -2 : x > 3 ? 3 : x));
  CHECK(law::select(true, 1, 2) == 1);
  CHECK(law::select(false, 1, 2) == 2);
  constexpr std::array<std::int64_t, 3> table{7, -8, 9};
  for (int index = 0; index < 3; ++index)
    CHECK(law::lookup(table, index) == table.at(static_cast<std::size_t>(index)));
  CHECK(law::lookup(table, 3) == 0);
  CHECK(law::lookup(table, -1) == 0);
  for (const bool now : {false, true}) {
    for (const bool before : {false, true}) CHECK(law::trailing_edge(now, before) == (before && !now));
  }
}

TEST_CASE("move_up, below, is_negative and gate", "[law]") {
  for (int a = -40; a <= 40; ++a) {
    for (int shift = 0; shift <= 8; ++shift) {
      CAPTURE(a, shift);
      REQUIRE(law::move_up<std::int64_t>(a, shift) == std::int64_t{a} * (1 << shift));
      for (int b = -40; b <= 40; ++b) {
        REQUIRE(law::below<std::int64_t>(a, shift, b, 0) == (a * (1 << shift) < b ? 1 : 0));
        REQUIRE(law::below<std::int32_t>(b, 0, a, shift) == (b < a * (1 << shift) ? 1 : 0));
      }
    }
    REQUIRE(law::is_negative<std::int32_t>(a) == (a < 0 ? 1 : 0));
    REQUIRE(law::gate<std::int64_t>(a, 0) == a);
    REQUIRE(law::gate<std::int64_t>(a, 1) == 0);
  }
}
