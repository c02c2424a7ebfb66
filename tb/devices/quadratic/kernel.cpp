// SPDX-License-Identifier: Apache-2.0
#include "tb/devices/quadratic/kernel.h"

#include "tb/vector_clones.h"

namespace blysk::quadratic_device {
namespace {

template <class Shape, class Columns>
[[gnu::always_inline]] inline void shade_line(const Shape& shape, const wired_constants& wired,
                                              const Columns& io) {
  using a_t = typename Shape::a_t;
  const auto slope = static_cast<a_t>(wired.slope);
  const auto offset = static_cast<a_t>(wired.offset);
  constexpr a_t carry30 = 0;
  specular::shade(
      shape,
      [&](std::uint16_t n) __attribute__((always_inline)) {
        const a_t slope_n = law::mul<a_t>(n, slope, 0);
        return law::add<a_t>(slope_n, 0, offset, shape.coefficient_bits - 1, carry30);
      },
      io);
}

}  // namespace

// A template cannot have clones, so every format gets a plain function of its own.
#define BLYSK_KERNEL(Q, Lobe)                                                                         \
  using Q##_##Lobe##_formats = quadratic_formats<Q, negative_lobe::Lobe>;                             \
  using Q##_##Lobe##_columns = specular::columns_of<Q##_##Lobe##_formats>;                            \
  void Q##_##Lobe(const wired_constants& wired, const Q##_##Lobe##_columns& io);                      \
  BLYSK_VECTOR_CLONES void Q##_##Lobe(const wired_constants& wired, const Q##_##Lobe##_columns& io) { \
    shade_line(specular::fixed_shape<Q##_##Lobe##_formats>{}, wired, io);                             \
  }                                                                                                   \
  template <>                                                                                         \
  void compute<Q##_##Lobe##_formats>(const wired_constants& wired, const Q##_##Lobe##_columns& io) {  \
    Q##_##Lobe(wired, io);                                                                            \
  }
#define BLYSK_NAMED_FORMAT(name) \
  BLYSK_KERNEL(name, clamped)    \
  BLYSK_KERNEL(name, as_published)
#include "tb/formats.def"
#undef BLYSK_NAMED_FORMAT
#undef BLYSK_KERNEL

BLYSK_VECTOR_CLONES void compute(const specular::free_shape& shape, const wired_constants& wired,
                                 const specular::free_columns& io) {
  specular::with_known(
      shape, [&](const auto& known) __attribute__((always_inline)) { shade_line(known, wired, io); });
}

}  // namespace blysk::quadratic_device
