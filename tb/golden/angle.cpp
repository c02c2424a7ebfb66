// SPDX-License-Identifier: Apache-2.0
#include "tb/golden/angle.h"

#include <stdexcept>

namespace blysk::golden {
namespace {

template <class Real>
void evaluate_each(Real n, Real k, Real q, std::span<const Real> angles, std::span<Real> out) {
  if (!(n >= 1 && n <= 1000)) throw std::domain_error("n is outside [1, 1000]");
  if (!(k >= 1)) throw std::domain_error("k is below 1");
  if (!(q > 0 && q < 1)) {  // NOLINT(misc-redundant-expression): it sees no NaN
    throw std::domain_error("q is outside (0, 1)");
  }
  if (angles.size() != out.size()) throw std::domain_error("results and angles differ in number");
  const Real scale = angle_scale(n, k, q);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = angle_lobe_scaled(k, Real(scale * angles[i]));
}

}  // namespace

void angle_lobe(double n, double k, double q, std::span<const double> angles, std::span<double> out) {
  evaluate_each(n, k, q, angles, out);
}

void angle_lobe(float n, float k, float q, std::span<const float> angles, std::span<float> out) {
  evaluate_each(n, k, q, angles, out);
}

}  // namespace blysk::golden
