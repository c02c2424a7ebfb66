// SPDX-License-Identifier: Apache-2.0
/// What the options ask for, as types and numbers.
#pragma once

#include "rtl_sysc/devices/cosine_quadratic/formats.h"
#include "tb/device.h"

namespace blysk::cosine_quadratic_device {

inline bool gates_by_limit(const selection& asked) {
  return asked.value("gating") == "published";
}
inline bool weighs_an_lsb(const selection& asked) {
  return asked.value("constants") == "published";
}
inline bool has_factor(const selection& asked) {
  return asked.value("energy") != "none";
}

/// Which of the energy factors: 0 (n + 6)/24.55, 1 the safe one.
inline int factor_of(const selection& asked) {
  return asked.value("energy") == "safe" ? 1 : 0;
}

/// Calls use.operator()<Formats>() with the formats that the options ask for in format Q.
template <class Q, class Use>
auto with_formats(const selection& asked, Use use) {
  using enum root_gate;
  using enum constant_weight;
  if (has_factor(asked)) return use.template operator()<cosine_quadratic_formats<Q, sign, unity, true>>();
  if (gates_by_limit(asked)) {
    return weighs_an_lsb(asked) ? use.template operator()<cosine_quadratic_formats<Q, limit, lsb, false>>()
                                : use.template operator()<cosine_quadratic_formats<Q, limit, unity, false>>();
  }
  return weighs_an_lsb(asked) ? use.template operator()<cosine_quadratic_formats<Q, sign, lsb, false>>()
                              : use.template operator()<cosine_quadratic_formats<Q, sign, unity, false>>();
}

}  // namespace blysk::cosine_quadratic_device
