// SPDX-License-Identifier: Apache-2.0
/// Bit-accurate model of the quadratic device: the blocks' laws composed on plain integers.
#pragma once

#include <memory>
#include <type_traits>

#include "rtl_sysc/formats.h"
#include "tb/device.h"
#include "tb/engine.h"

namespace blysk::bit {

/// The first of int32_t, uint32_t and int64_t that holds all raw values of format Q.
template <class Q>
using machine_int =
    std::conditional_t<(Q::width + (Q::is_signed ? 0 : 1) <= 32), std::int32_t,
                       std::conditional_t<(Q::width <= 32 && !Q::is_signed), std::uint32_t, std::int64_t>>;

/// Columns of writes and of their results, all of the same length and none overlapping another.
/// Raw holds F::out: 32 bits with the clamp.
template <class Raw>
struct columns {
  const std::uint16_t* n;
  const std::uint32_t* cos_delta;
  const std::uint8_t* red_ks;
  const std::uint8_t* green_ks;
  const std::uint8_t* blue_ks;
  Raw* brdf;
  Raw* red;
  Raw* green;
  Raw* blue;
  std::size_t size;
};

/// [P] fig. 1 from register outputs to 25, 26, 27, the laws in the netlist's order, for every write of the columns.
/// Inputs beyond the formats' legal ranges give unspecified results.
template <class F>
[[gnu::always_inline]] inline void quadratic(const wired_constants& wired,
                                             const columns<machine_int<typename F::out>>& io) {
  using a_t = machine_int<typename F::a>;
  using cos_t = machine_int<typename F::cos_inv>;
  using square_t = machine_int<typename F::mul7::exact>;
  using product_t = machine_int<typename F::a_diff>;
  using out_t = machine_int<typename F::out>;
  constexpr int carry28 = 1;
  constexpr int carry30 = 0;
  const auto slope = static_cast<a_t>(wired.slope);
  const auto offset = static_cast<a_t>(wired.offset);
#pragma omp simd
  for (std::size_t i = 0; i < io.size; ++i) {
    const auto cos_delta = static_cast<cos_t>(io.cos_delta[i]);
    const a_t a = F::add15::template law<a_t>(F::mul6::template law<a_t>(io.n[i], slope), offset, carry30);
    const auto cos2 = static_cast<cos_t>(F::mul7::template law<square_t>(cos_delta, cos_delta));
    const cos_t diff = F::add9::template law<cos_t>(cos2, F::inv8::template law<cos_t>(cos_delta), carry28);
    const product_t a_diff = F::mul10::template law<product_t>(a, diff);
    const product_t parabola = F::add11::template law<product_t>(a_diff, cos_delta, carry30);
    const auto brdf = static_cast<out_t>(F::quant11::template law<product_t>(parabola));
    io.brdf[i] = brdf;
    io.red[i] = F::mul_colour::template law<out_t>(brdf, io.red_ks[i]);
    io.green[i] = F::mul_colour::template law<out_t>(brdf, io.green_ks[i]);
    io.blue[i] = F::mul_colour::template law<out_t>(brdf, io.blue_ks[i]);
  }
}

/// The same, compiled for several vector widths in one binary; the loader takes the widest that the processor has.
/// Defined for every named format and both lobes.
template <class F>
void quadratic_vector(const wired_constants& wired, const columns<machine_int<typename F::out>>& io);

/// Engine over whole batches.
/// \throws std::invalid_argument for options that no device has
std::unique_ptr<engine> make_quadratic(const device_options& options);

}  // namespace blysk::bit
