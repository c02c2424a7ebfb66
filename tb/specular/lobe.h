// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "tb/specular/point_engines.h"
#include "tb/specular/specular.h"

namespace blysk::specular {

/// A device whose one open word length is that of the cosine.
/// \tparam Law  in_formats(asked, use) calls use.operator()<Formats>() with the formats of what is asked for;
///              brdf<Formats>(n, cos_delta) composes the blocks' laws on codes
template <class Law>
class device_of_lobe : public device_of_points {
 public:
  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    return Law::in_formats(asked, []<class Formats>() {
      return make_kernel_engine<Formats>([](const columns_of<Formats>& io) { compute<Formats>(io); });
    });
  }

  word_lengths widths(const selection& asked) const override { return {{"cos", asked.fraction()}}; }

  std::unique_ptr<engine> make_bit(const selection& asked, const word_lengths& bits) const override {
    check_only_cosine(asked, bits);
    return Law::in_formats(asked, []<class Formats>() {
      return make_free_engine([](const free_columns& io) { compute<Formats>(io); });
    });
  }

 private:
  template <class Formats, class Columns>
  static void compute(const Columns& io) {
    shade_points<std::int64_t>(
        [](std::uint16_t n, auto cos_delta) __attribute__((always_inline)) {
          return Law::template brdf<Formats>(n, static_cast<std::int64_t>(cos_delta));
        },
        io);
  }
};

}  // namespace blysk::specular
