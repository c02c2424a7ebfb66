// SPDX-License-Identifier: Apache-2.0
/// R(L) of the named lobes, of the angle-based lobe and of Cook-Torrance.   [T] (2.22), [A]
#pragma once

#include "tb/golden/energy.h"
#include "tb/golden/lobe.h"
#include "tb/golden/scene.h"

namespace blysk::golden {

/// Cosine at which a lobe ends or has a kink, 0 if nowhere in [0, 1]; negative where its formula has the root there.
double root_cosine(lobe which, double n);

/// R of a lobe, negative values set to zero; beyond 90 degrees from the mirror direction it is dark.
/// \param n          specular exponent, [1, 1000]
/// \param incidence_degrees  [0, 90)
double lobe_reflectance(lobe which, double n, lobe_axis axis, double incidence_degrees);

/// The same around the mirror direction, with what lies beyond 90 degrees as stated.
double lobe_reflectance(lobe which, double n, beyond_right_angle beyond, double incidence_degrees);

/// R of the angle-based lobe times `coefficient`; what passes 90 degrees from the lobe's axis is cut off.
double angle_reflectance(double n, double k, double q, double coefficient, lobe_axis axis,
                         double incidence_degrees);

/// R of R_s = F D G/(N.V), relative error about 1e-7: R = integral of F D G d omega_o, as R_s has N.V in its divisor
/// and R the cosine of the outgoing ray; by half vectors, d omega_o = 4 (o.h) d omega_h.
/// \param m      root mean square slope of the facets, (0, 1]
/// \param index  relative index of refraction, > 1
double cook_torrance_reflectance(facet_distribution distribution, double m, double index,
                                 double incidence_degrees);

}  // namespace blysk::golden
