// SPDX-License-Identifier: Apache-2.0
#include "tb/devices/quadratic_rom/kernel.h"

#include "tb/vector_clones.h"

namespace blysk::quadratic_rom_device {
namespace {

template <class Shape, class Columns>
[[gnu::always_inline]] inline void shade_words(const Shape& shape, const memory& words, const Columns& io) {
  const std::int32_t* const word = words.data();
  specular::shade(
      shape,
      [word](std::uint16_t n)
          __attribute__((always_inline)) { return static_cast<typename Shape::a_t>(word[n & 1023u]); },
      io);
}

}  // namespace

// A template cannot have clones, so every format gets a plain function of its own.
#define BLYSK_KERNEL(Q, Lobe)                                                                \
  using Q##_##Lobe##_formats = quadratic_rom_formats<Q, negative_lobe::Lobe>;                \
  using Q##_##Lobe##_columns = specular::columns_of<Q##_##Lobe##_formats>;                   \
  void Q##_##Lobe(const memory& words, const Q##_##Lobe##_columns& io);                      \
  BLYSK_VECTOR_CLONES void Q##_##Lobe(const memory& words, const Q##_##Lobe##_columns& io) { \
    shade_words(specular::fixed_shape<Q##_##Lobe##_formats>{}, words, io);                   \
  }                                                                                          \
  template <>                                                                                \
  void compute<Q##_##Lobe##_formats>(const memory& words, const Q##_##Lobe##_columns& io) {  \
    Q##_##Lobe(words, io);                                                                   \
  }
#define BLYSK_NAMED_FORMAT(name) \
  BLYSK_KERNEL(name, clamped)    \
  BLYSK_KERNEL(name, as_published)
#include "tb/formats.def"
#undef BLYSK_NAMED_FORMAT
#undef BLYSK_KERNEL

BLYSK_VECTOR_CLONES void compute(const specular::free_shape& shape, const memory& words,
                                 const specular::free_columns& io) {
  specular::with_known(
      shape, [&](const auto& known) __attribute__((always_inline)) { shade_words(known, words, io); });
}

}  // namespace blysk::quadratic_rom_device
