// SPDX-License-Identifier: Apache-2.0
/// Named formats, and the formats that several devices share.
#pragma once

#include "rtl_sysc/qformat.h"

namespace blysk {

/// Named formats, what a user picks: q8 .. q24 are the fraction bits of cos(delta).
template <int Frac>
struct named_format {
  static constexpr int frac = Frac;
};

struct q8 : named_format<8> {};
struct q10 : named_format<10> {};
struct q12 : named_format<12> {};
struct q14 : named_format<14> {};
struct q16 : named_format<16> {};
struct q18 : named_format<18> {};
struct q20 : named_format<20> {};
struct q22 : named_format<22> {};
struct q24 : named_format<24> {};

constexpr int min_of(int a, int b) {
  return a < b ? a : b;
}

/// Specular exponent n, 1..1000.
struct exponent : uq<10, 0> {
  static constexpr std::int64_t min = 1;
  static constexpr std::int64_t max = 1000;
};

using colour = uq<8, 0>;  ///< R, G or B times k_s, 0..255
using carry = uq<1, 0>;

}  // namespace blysk
