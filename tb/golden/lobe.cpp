// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/lobe.h"

#include <stdexcept>

#if defined(__x86_64__) && defined(__ELF__)
#define BLYSK_VECTOR_CLONES __attribute__((target_clones("default", "avx2", "avx512f")))
#else
#define BLYSK_VECTOR_CLONES
#endif

namespace blysk::golden {
namespace {

template <class Real>
void check(Real n, std::span<const Real> cosines, std::span<Real> out) {
  if (!(n >= 1 && n <= 1000)) throw std::domain_error("n is outside [1, 1000]");
  if (cosines.size() != out.size()) throw std::domain_error("results and cosines differ in number");
}

// Inlined into each clone, and with it the loops, or they would be compiled for the default target alone.
template <class Real>
[[gnu::always_inline]] inline void evaluate_each(lobe which, Real n, const Real* __restrict cosines,
                                                 Real* __restrict out, std::size_t count) {
  with_lobe(
      which, n, [=](const auto& f) __attribute__((always_inline)) {
        for (std::size_t i = 0; i < count; ++i) out[i] = f(cosines[i]);
      });
}

BLYSK_VECTOR_CLONES void evaluate_clones(lobe which, double n, const double* cosines, double* out,
                                         std::size_t count) {
  evaluate_each(which, n, cosines, out, count);
}

BLYSK_VECTOR_CLONES void evaluate_clones(lobe which, float n, const float* cosines, float* out,
                                         std::size_t count) {
  evaluate_each(which, n, cosines, out, count);
}

}  // namespace

void evaluate(lobe which, double n, std::span<const double> cosines, std::span<double> out) {
  check(n, cosines, out);
  evaluate_clones(which, n, cosines.data(), out.data(), out.size());
}

void evaluate(lobe which, float n, std::span<const float> cosines, std::span<float> out) {
  check(n, cosines, out);
  evaluate_clones(which, n, cosines.data(), out.data(), out.size());
}

}  // namespace blysk::golden
