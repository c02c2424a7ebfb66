// SPDX-License-Identifier: Apache-2.0
/// Engines on kernels of devices that shade a point.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "tb/device.h"
#include "tb/specular/point_columns.h"

namespace blysk::specular {

/// The kernel of a named format on whole columns.
/// \tparam Kernel  called with columns_of<Formats>
template <class Formats, class Kernel>
class kernel_engine final : public engine {
 public:
  explicit kernel_engine(Kernel kernel)
      : engine(
            {storage_of(format_of(typename Formats::brdf{})), storage_of(format_of(typename Formats::out{})),
             storage_of(format_of(typename Formats::out{})), storage_of(format_of(typename Formats::out{}))}),
        kernel_(std::move(kernel)) {}

 private:
  void compute(const columns& in, columns& out) override { kernel_(pointers<Formats>(in, out)); }

  Kernel kernel_;
};

template <class Formats, class Kernel>
std::unique_ptr<engine> make_kernel_engine(Kernel kernel) {
  return std::make_unique<kernel_engine<Formats, Kernel>>(std::move(kernel));
}

using free_columns = point_columns<std::uint32_t, std::int64_t, std::int64_t>;

/// A kernel of any word lengths. Cosines of every storage are accepted.
/// \tparam Kernel  called with free_columns
template <class Kernel>
class free_engine final : public engine {
 public:
  explicit free_engine(Kernel kernel)
      : engine({storage::i64, storage::i64, storage::i64, storage::i64}), kernel_(std::move(kernel)) {}

 private:
  static constexpr std::size_t kBlock = 512;  // in the first-level cache

  void compute(const columns& in, columns& out) override {
    std::array<std::uint32_t, kBlock> cosines;
    for (std::size_t first = 0; first < in.size(); first += kBlock) {
      const std::size_t size = std::min(kBlock, in.size() - first);
      in[1].visit([&](const auto& codes) {
        for (std::size_t i = 0; i < size; ++i) cosines[i] = static_cast<std::uint32_t>(codes[first + i]);
      });
      const auto result = [&](std::size_t index) { return out[index].template data<std::int64_t>() + first; };
      kernel_(free_columns{in[0].data<std::uint16_t>() + first, cosines.data(),
                           in[2].data<std::uint8_t>() + first, in[3].data<std::uint8_t>() + first,
                           in[4].data<std::uint8_t>() + first, result(0), result(1), result(2), result(3),
                           size});
    }
  }

  Kernel kernel_;
};

template <class Kernel>
std::unique_ptr<engine> make_free_engine(Kernel kernel) {
  return std::make_unique<free_engine<Kernel>>(std::move(kernel));
}

}  // namespace blysk::specular
