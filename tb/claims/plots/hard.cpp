// SPDX-License-Identifier: Apache-2.0
// Errors of literal and stable forms.
#include <algorithm>
#include <cmath>

#include "tb/claims/plots/figure.h"
#include "tb/golden/hard_forms.h"
#include "tb/golden/running_error.h"

namespace blysk::claims::plots {

using namespace golden;
namespace {

/// At most this many points of a hard form: more would only blacken the plot.
constexpr std::size_t kHardPoints = 128;

/// Error of the two forms of a formula in both types, and what the stable one is sure to keep in float.
figure hard_figure(const hard_form& form) {
  // What is exact lies on the lower edge.
  const auto shown = [](double ulp) { return std::max(ulp, 0.01); };
  figure result{"hard_" + form.name,
                form.name == "shadowing" ? "G/(N.V), whole and term by term: errors in ulp"
                                         : form.literal + " beside " + form.stable + ": errors in ulp",
                form.argument,
                "error, ulp",
                form.name == "versine" || form.name == "shadowing" ? "xy" : "y",
                {},
                {{"literal, float", [=](double x) { return shown(form.in_float(x).literal); }},
                 {"literal, double", [=](double x) { return shown(form.in_double(x).literal); }},
                 {"stable, float", [=](double x) { return shown(form.in_float(x).stable); }},
                 {"stable, double", [=](double x) { return shown(form.in_double(x).stable); }}},
                "[0.01:*]",
                "points pt 7 ps 0.5"};
  const std::size_t stride = form.points.size() / kHardPoints + 1;
  for (std::size_t i = 0; i < form.points.size(); i += stride) {
    // Those of the shadowing below the least double are beyond gnuplot's axes; float shows the same.
    if (form.points[i] > 1e-50) result.x.push_back(form.points[i]);
  }
  return result;
}

}  // namespace

std::vector<figure> hard_figures() {
  std::vector<figure> result;
  for (const char* name : {"coefficient", "level", "angle", "schlick", "schlick_modified_d", "gx", "parabola",
                           "versine", "fresnel", "beckmann", "shadowing", "power"})
    result.push_back(hard_figure(*std::ranges::find(hard_forms(), name, &hard_form::name)));

  const auto near_root = [](double distance) {
    return bounded<float>(static_cast<float>(1 - 3.0 / 101 + distance));
  };
  const auto in_ulp = [](const referee& error, const referee& exact) {
    return std::max(0.01, static_cast<double>(error / ulp_of<float>(exact)));
  };
  result.push_back(
      {"hard_root",
       "The cosine-quadratic beside its root: ulp grow with the condition number: n = 100, float",
       "c - root",
       "error, ulp",
       "xy",
       steps(-6, -1.3, 120),
       {{"error",
         [=](double x) {
           const auto exact = cosine_quadratic(bounded<float>(100), near_root(std::pow(10, x)));
           const float value =
               cosine_quadratic(100.0F, static_cast<float>(near_root(std::pow(10, x)).value()));
           return in_ulp(abs(referee(value) - exact.value()), exact.value());
         }},
        {"bound",
         [=](double x) {
           const auto exact = cosine_quadratic(bounded<float>(100), near_root(std::pow(10, x)));
           return in_ulp(exact.error(), exact.value());
         }}},
       "[0.01:*]",
       "points pt 7 ps 0.5",
       [](double x) { return std::pow(10, x); }});
  result.push_back(
      {"hard_underflow",
       "c^n at n = 1000 in float leaves the normal numbers at c = 0.9164: half their spacing is what is lost",
       "c",
       "value, relative error",
       "y",
       steps(0.9, 0.93, 240),
       {{"c^{1000}", [](double c) { return std::pow(static_cast<float>(c), 1000.0); }},
        {"relative error in float",
         [](double c) {
           const auto single = static_cast<float>(c);
           const referee exact = blinn(referee(1000), referee(single));
           return static_cast<double>(abs(referee(blinn(1000.0F, single)) / exact - 1));
         }}},
       "[1e-46:10]",
       "points pt 7 ps 0.5"});
  result.push_back({"hard_cosine_bits",
                    "Fraction bits of the cosine with which cos^n is off by no more than half an 8-bit step",
                    "n",
                    "bits",
                    "x",
                    exponents(1, 1000),
                    {{"measured", [](double n) { return cosine_bits(static_cast<int>(n)); }},
                     {"log_2(510 n) - 1", [](double n) { return std::log2(510 * n) - 1; }}},
                    "[7:19]"});
  return result;
}

}  // namespace blysk::claims::plots
