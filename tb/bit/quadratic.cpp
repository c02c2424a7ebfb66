// SPDX-License-Identifier: Apache-2.0
#include "tb/bit/quadratic.h"

#include <algorithm>
#include <array>

#include "tb/vector_clones.h"

namespace blysk::bit {

// A template cannot have clones, so every format gets a plain function of its own.
#define BLYSK_KERNEL(Q, Lobe)                                                                         \
  using Q##_##Lobe##_formats = quadratic_formats<Q, lobe::Lobe>;                                      \
  using Q##_##Lobe##_columns = columns<machine_int<Q##_##Lobe##_formats::out>>;                       \
  void Q##_##Lobe(const wired_constants& wired, const Q##_##Lobe##_columns& io);                      \
  BLYSK_VECTOR_CLONES void Q##_##Lobe(const wired_constants& wired, const Q##_##Lobe##_columns& io) { \
    quadratic<Q##_##Lobe##_formats>(wired, io);                                                       \
  }                                                                                                   \
  template <>                                                                                         \
  void quadratic_vector<Q##_##Lobe##_formats>(const wired_constants& wired,                           \
                                              const Q##_##Lobe##_columns& io) {                       \
    Q##_##Lobe(wired, io);                                                                            \
  }
#define BLYSK_NAMED_FORMAT(name) \
  BLYSK_KERNEL(name, clamped)    \
  BLYSK_KERNEL(name, as_published)
#include "tb/formats.def"
#undef BLYSK_NAMED_FORMAT
#undef BLYSK_KERNEL

namespace {

template <class F>
class quadratic_engine final : public engine {
 public:
  explicit quadratic_engine(const wired_constants& wired) : wired_(wired) {}

  void run(const batch& in, results& out) override {
    out.resize(in.size());
    for (std::size_t first = 0; first < in.size(); first += kBlock) {
      const std::size_t size = std::min(kBlock, in.size() - first);
      quadratic_vector<F>(wired_, {in.n.data() + first, in.cos_delta.data() + first, in.red_ks.data() + first,
                                   in.green_ks.data() + first, in.blue_ks.data() + first, brdf_.data(),
                                   red_.data(), green_.data(), blue_.data(), size});
      std::copy_n(brdf_.begin(), size, out.brdf.data() + first);
      std::copy_n(red_.begin(), size, out.red.data() + first);
      std::copy_n(green_.begin(), size, out.green.data() + first);
      std::copy_n(blue_.begin(), size, out.blue.data() + first);
    }
  }

 private:
  static constexpr std::size_t kBlock = 512;  // its columns stay in the first-level cache
  using column = std::array<machine_int<typename F::out>, kBlock>;

  wired_constants wired_;
  column brdf_, red_, green_, blue_;
};

}  // namespace

std::unique_ptr<engine> make_quadratic(const device_options& options) {
  const wired_constants wired = wire_constants(options);
  return visit_formats(options, [&]<class Q, lobe Lobe>() -> std::unique_ptr<engine> {
    return std::make_unique<quadratic_engine<quadratic_formats<Q, Lobe>>>(wired);
  });
}

}  // namespace blysk::bit
