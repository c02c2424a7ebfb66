// SPDX-License-Identifier: Apache-2.0
/// What the kernels of devices that shade a point have in common: pointers into columns, and the colour multipliers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "rtl_sysc/blocks/law.h"
#include "tb/columns.h"

namespace blysk::specular {

/// int32_t or int64_t, for computing with numbers of format Q.
template <class Q>
using machine_int = std::conditional_t<(Q::width + (Q::is_signed ? 0 : 1) <= 32), std::int32_t, std::int64_t>;

/// Columns of writes and of their results, all of the same length and none overlapping another.
template <class Cos, class Brdf, class Out>
struct point_columns {
  const std::uint16_t* n;
  const Cos* cos_delta;
  const std::uint8_t* red_ks;
  const std::uint8_t* green_ks;
  const std::uint8_t* blue_ks;
  Brdf* brdf;
  Out* red;
  Out* green;
  Out* blue;
  std::size_t size;
};

/// The columns of a named format.
template <class Formats>
using columns_of = point_columns<stored<typename Formats::cos_delta>, stored<typename Formats::brdf>,
                                 stored<typename Formats::out>>;

/// From the BRDF to 25, 26, 27 for every write.
/// \tparam Out      integer that holds the colours
/// \param brdf_of  BRDF of n and cos(delta), all of them codes
template <class Out, class Brdf, class Columns>
[[gnu::always_inline]] inline void shade_points(Brdf brdf_of, const Columns& io) {
  using brdf_column = std::remove_pointer_t<decltype(io.brdf)>;
  using out_column = std::remove_pointer_t<decltype(io.red)>;
#pragma omp simd
  for (std::size_t i = 0; i < io.size; ++i) {
    const auto brdf = brdf_of(io.n[i], io.cos_delta[i]);
    const auto factor = static_cast<Out>(brdf);
    io.brdf[i] = static_cast<brdf_column>(brdf);
    io.red[i] = static_cast<out_column>(law::mul<Out>(factor, io.red_ks[i], 0));
    io.green[i] = static_cast<out_column>(law::mul<Out>(factor, io.green_ks[i], 0));
    io.blue[i] = static_cast<out_column>(law::mul<Out>(factor, io.blue_ks[i], 0));
  }
}

/// The pointers that a kernel takes, from an engine's columns.
template <class Formats>
columns_of<Formats> pointers(const columns& in, columns& out) {
  using cos_t = stored<typename Formats::cos_delta>;
  using brdf_t = stored<typename Formats::brdf>;
  using out_t = stored<typename Formats::out>;
  return {in[0].data<std::uint16_t>(), in[1].data<cos_t>(),
          in[2].data<std::uint8_t>(),  in[3].data<std::uint8_t>(),
          in[4].data<std::uint8_t>(),  out[0].data<brdf_t>(),
          out[1].data<out_t>(),        out[2].data<out_t>(),
          out[3].data<out_t>(),        in.size()};
}

}  // namespace blysk::specular
