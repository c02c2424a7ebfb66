// SPDX-License-Identifier: Apache-2.0
#include "tb/devices/power/kernel.h"

#include "tb/vector_clones.h"

namespace blysk::power_device {
namespace {

/// What the lines of a memory make of an argument.
template <class Lines>
[[gnu::always_inline]] inline std::int64_t value_at(std::int64_t index, std::int64_t place) {
  using std::int64_t;
  const auto product = Lines::mul_place::law(Lines::rom_change::law(1, index), place);
  const auto line = Lines::add_line::law(Lines::rom_begin::law(0, index), product, int64_t{0});
  return Lines::cut_line::law(line);
}

/// From registers 1 and 2 to the BRDF.
/// \param n          code of register 1
/// \param cos_delta  raw, 0..2^F; beyond, the result is unspecified
/// \return           BRDF, raw
template <class Formats>
[[gnu::always_inline]] inline std::int64_t brdf(std::int64_t n, std::int64_t cos_delta) {
  using std::int64_t;
  int64_t zeros = 0;
  int64_t is_zero = 0;
  const int64_t normalised = Formats::norm::law(cos_delta, zeros, is_zero);
  const int64_t distance = Formats::add_f::law(int64_t{2}, Formats::inv_f::law(normalised), int64_t{1});
  const int64_t ratio = value_at<typename Formats::ratios>(Formats::index_ratio::law(normalised),
                                                           Formats::place_ratio::law(normalised));
  const int64_t log_fraction = Formats::cut_log::law(Formats::mul_log::law(distance, ratio));
  const int64_t log = Formats::add_log::law(zeros, log_fraction, int64_t{0});
  const int64_t power_log = Formats::mul_n::law(n, log);
  const int64_t power = value_at<typename Formats::powers>(Formats::index_power::law(power_log),
                                                           Formats::place_power::law(power_log));
  const int64_t shifted = Formats::shift::law(power, Formats::cut_places::law(power_log));
  const int64_t off = Formats::off::law(Formats::cut_above::law(power_log), is_zero);
  return Formats::key_brdf::law(Formats::quant::law(shifted), off);
}

template <class Formats, class Columns>
[[gnu::always_inline]] inline void shade(const Columns& io) {
  specular::shade_points<std::int64_t>(
      [](std::uint16_t n, auto cos_delta)
          __attribute__((always_inline)) { return brdf<Formats>(n, static_cast<std::int64_t>(cos_delta)); },
      io);
}

}  // namespace

// A template cannot have clones, so every format gets plain functions of its own.
#define BLYSK_KERNEL(Q, Columns, Name)                     \
  void Q##_##Name(const Columns& io);                      \
  BLYSK_VECTOR_CLONES void Q##_##Name(const Columns& io) { \
    shade<power_formats<Q>>(io);                           \
  }                                                        \
  template <>                                              \
  void compute<power_formats<Q>>(const Columns& io) {      \
    Q##_##Name(io);                                        \
  }
#define BLYSK_NAMED_FORMAT(Q)                                 \
  using Q##_columns = specular::columns_of<power_formats<Q>>; \
  BLYSK_KERNEL(Q, Q##_columns, points)                        \
  BLYSK_KERNEL(Q, specular::free_columns, free_points)
#include "tb/formats.def"
#undef BLYSK_NAMED_FORMAT
#undef BLYSK_KERNEL

}  // namespace blysk::power_device
