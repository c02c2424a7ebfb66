// SPDX-License-Identifier: Apache-2.0
/// The Q-format of a wire, as text.
#pragma once

#include <cstdint>
#include <string>

namespace blysk {

/// How the integer on a bundle of wires stands for a number, and the codes that are legal there.
struct wire_format {
  int integer;
  int frac;
  bool is_signed;
  std::int64_t min;
  std::int64_t max;

  friend bool operator==(const wire_format&, const wire_format&) = default;

  int width() const { return integer + frac + (is_signed ? 1 : 0); }

  /// "UQ1.12"
  std::string text() const;

  /// "UQ1.12, codes 0..4096", the codes only if they are not all that the wires can carry.
  std::string note() const;

  /// "uq1_12", "sqm2_24" for SQ-2.24: for names of modules.
  std::string name() const;

  /// What a code stands for, six digits of it.
  std::string value(std::int64_t raw) const;
};

/// The format of a type of rtl_sysc/qformat.h.
template <class Q>
wire_format format_of(Q) {
  return {Q::width - Q::frac - (Q::is_signed ? 1 : 0), Q::frac, Q::is_signed, Q::min, Q::max};
}

}  // namespace blysk
