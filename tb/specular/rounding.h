// SPDX-License-Identifier: Apache-2.0
/// How a model of any word length drops fraction bits. The devices that are built round to nearest, ties up; the others are
/// there to be compared.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

#include "rtl_sysc/blocks/law.h"
#include "tb/device.h"

namespace blysk::specular {

enum class rounding : std::uint8_t { nearest, even, truncate, jam };

struct named_rounding {
  rounding which;
  std::string_view name;
  std::string_view what;
};

inline constexpr std::array kRoundings{
    named_rounding{rounding::nearest, "nearest", "to nearest, ties up, as the devices are built"},
    named_rounding{rounding::even, "even", "to nearest, ties to even"},
    named_rounding{rounding::truncate, "truncate", "cut off, towards -infinity"},
    named_rounding{rounding::jam, "jam", "cut off, and the last bit set where a one was cut off"},
};

constexpr std::string_view name_of(rounding how) {
  return kRoundings[static_cast<std::size_t>(how)].name;
}

/// Drops `bits` fraction bits. In ulp of the result the error is within [-1/2, 1/2] for nearest and even, within (-1, 0]
/// for truncate, and within (-1, 1) for jam (A. W. Burks, H. H. Goldstine, J. von Neumann 1946, 5.12).
/// \param with_headroom  see law::round_off()
template <rounding How, class T>
[[gnu::always_inline]] constexpr T drop_bits(T x, int bits, bool with_headroom = true) {
  if constexpr (How == rounding::nearest) {
    return law::round_off(x, bits, with_headroom);
  } else {
    const T whole = static_cast<T>(x >> bits);
    const T rest = static_cast<T>(x - static_cast<T>(whole << bits));
    if constexpr (How == rounding::even) {
      // Of a tie the last bit makes more than a half where it is one. Without bits to drop it has to stay below.
      const T half = static_cast<T>(std::int64_t{1} << (bits > 0 ? bits - 1 : 0));
      return static_cast<T>(whole + static_cast<T>(rest + static_cast<T>(whole & 1) > half));
    } else if constexpr (How == rounding::jam) {
      return static_cast<T>(whole | static_cast<T>(rest != 0));
    } else {
      return whole;
    }
  }
}

/// A device whose model of any word length can drop bits in every way.
class rounded_in_any_way {
 public:
  virtual ~rounded_in_any_way() = default;

  /// device::make_bit() at these word lengths, with this rounding in place of the built one.
  /// \throws std::invalid_argument for word lengths at which a net needs more than 64 bits
  virtual std::unique_ptr<engine> make_rounded(const selection& asked, const word_lengths& bits,
                                               rounding how) const = 0;
};

}  // namespace blysk::specular
