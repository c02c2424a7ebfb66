// SPDX-License-Identifier: Apache-2.0
/// Bit-accurate model of the cosine-quadratic device on columns.
#pragma once

#include <array>
#include <cstdint>

#include "rtl_sysc/devices/cosine_quadratic/formats.h"
#include "tb/specular/point_engines.h"
#include "tb/specular/rounding.h"

namespace blysk::cosine_quadratic_device {

/// A word for each code of the register of n; beyond the memory's end, 0.
using memory = std::array<std::int64_t, 1024>;

struct memories {
  memory slope{};   ///< ROM 33
  memory limit{};   ///< ROM 9, where comparator 11 reads it
  memory factor{};  ///< of energy, if there is one
};

/// Word lengths that are chosen at run time, everything in 64 bits.
struct free_shape {
  int cos_bits, slope_bits, line_bits, square_bits, limit_bits, factor_bits, weight_bits;
  bool is_limited, gates_by_limit, has_factor;
  specular::rounding how = specular::rounding::nearest;

  using product_t = std::int64_t;
  using rounded_t = std::int64_t;
  using square_t = std::int64_t;
  using scaled_t = std::int64_t;
  using out_t = std::int64_t;
};

/// [T] fig. 3.1 from register outputs to the colours, the laws in the netlist's order, for every write of the columns.
/// Compiled for several vector widths in one binary; the loader takes the widest that the processor has.
/// \tparam Formats  a cosine_quadratic_formats
template <class Formats>
void compute(const memories& words, const specular::columns_of<Formats>& io);

/// The same at word lengths of the moment.
void compute(const free_shape& shape, const memories& words, const specular::free_columns& io);

/// Formats of every kind that the options can ask for, in format Q.
template <class Q>
struct formats_in {
  using lobe = cosine_quadratic_formats<Q, root_gate::sign, constant_weight::unity, false>;
  using energy = cosine_quadratic_formats<Q, root_gate::sign, constant_weight::unity, true>;
  using by_limit = cosine_quadratic_formats<Q, root_gate::limit, constant_weight::unity, false>;
  using of_lsb = cosine_quadratic_formats<Q, root_gate::sign, constant_weight::lsb, false>;
  using published = cosine_quadratic_formats<Q, root_gate::limit, constant_weight::lsb, false>;
};

}  // namespace blysk::cosine_quadratic_device
