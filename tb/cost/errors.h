// SPDX-License-Identifier: Apache-2.0
/// How far a device's BRDF is from cos^n, at every input of a domain.
///
/// The reference is cos^n as a product of two doubles each (error below 1000 2^-104), at the cosine of the code; on sphere
/// and teapot at the cosine of the pixel, so that its quantisation counts too. Below 1e-200 it is taken for 0. Values do not
/// depend on the processor nor on the number of threads.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tb/device.h"
#include "tb/specular/rounding.h"

namespace blysk::cost {

/// Sets of inputs (n, cos), n in 1..1000 each.
enum class domain : std::uint8_t {
  whole,                 ///< every code of the cosine
  lobe,                  ///< where |BRDF| or cos^n is half an 8-bit step, 0.5/255, or more
  epicentre,             ///< in any of the next three: the widest of them at each n
  epicentre_060,         ///< cos^n >= 0.6
  epicentre_056,         ///< cos^n >= 0.56
  epicentre_inflection,  ///< up to the inflection point of cos^n
  sphere,                ///< pixels of a lit sphere of 512 x 512, tb/golden/sphere.h
  teapot,                ///< pixels of a lit mesh of 512 x 512, tb/golden/teapot.h
};

struct named_domain {
  domain which;
  std::string_view name;
  std::string_view what;
};

inline constexpr std::array kDomains{
    named_domain{domain::whole, "whole", "every code of the cosine"},
    named_domain{domain::lobe, "lobe", "|BRDF| or cos^n at least 0.5/255"},
    named_domain{domain::epicentre, "epicentre", "the widest of the three epicentres at each n"},
    named_domain{domain::epicentre_060, "epicentre-0.60", "cos^n >= 0.6"},
    named_domain{domain::epicentre_056, "epicentre-0.56", "cos^n >= 0.56"},
    named_domain{domain::epicentre_inflection, "epicentre-inflection", "up to the inflection point of cos^n"},
    named_domain{domain::sphere, "sphere", "pixels of a lit sphere, 512 x 512"},
    named_domain{domain::teapot, "teapot", "pixels of the lit teapot, 512 x 512"},
};

/// \throws std::invalid_argument for a domain that does not exist
domain find_domain(const std::string& name);

/// Errors over the inputs of a domain. e = BRDF - cos^n, dimensionless; an ulp is the last place of the BRDF.
struct errors {
  std::uint64_t points = 0;
  double max_abs_err = 0;  ///< max |e|, and an input that has it
  int max_abs_n = 0;
  double max_abs_cos = 0;
  double mean_abs_err = 0;
  double bias = 0;  ///< mean of e
  double rms_err = 0;
  double error_probability = 0;  ///< share of inputs where the BRDF is not cos^n rounded to nearest, ties up
  double max_rel_err = 0;        ///< max |e| / cos^n over inputs where cos^n is half an ulp or more
  double mean_rel_err = 0;       ///< over the same
  std::uint64_t relative_points = 0;
  std::array<std::uint64_t, 4> ulps{};  ///< inputs that are 0, 1, 2, 3 or more ulp off cos^n rounded
  std::uint64_t falls = 0;              ///< times the BRDF falls where the next larger cosine is taken
  double nmse = 0;                      ///< sum e^2 / sum cos^2n
  int max_step = 0;                     ///< largest difference of both, times 255 and rounded
};

using error_table = std::array<errors, kDomains.size()>;

/// What is measured.
struct judged {
  std::function<std::unique_ptr<engine>()> make;  ///< a model for each thread
  std::vector<storage> stimulus;                  ///< its columns n, cos, r, g, b
  int cos_bits = 0;                               ///< fraction bits of cos and of the BRDF
  int first_n = 1, last_n = 1000;
};

/// The bit-accurate model in its format.
/// \throws std::invalid_argument if the device computes no BRDF of n and cos
judged judge(const selection& asked);

/// Whether judge() takes the device: it shades points, or computes as one that does.
bool is_judged(const selection& asked);

/// The same at word lengths of one's own; `cos` names those of the cosine.
/// \throws std::invalid_argument also for word lengths that the laws refuse, and for a rounding that the model does not have
judged judge(const selection& asked, const word_lengths& bits,
             specular::rounding how = specular::rounding::nearest);

/// \param threads   at work
/// \param advanced  called with the share of the work that is done, in [0, 1], from any thread, one at a time
error_table measure_errors(const judged& of, int threads, const std::function<void(double)>& advanced = {});

/// The same of sphere or teapot alone.
errors measure_on_pixels(const judged& of, domain where, int threads,
                         const std::function<void(double)>& advanced = {});

/// The table as it is stored, by names of domains; reals have six digits.
nlohmann::ordered_json json_of(const error_table& table);
nlohmann::ordered_json json_of(const errors& of);

/// \throws usage_error for a file that is no table
error_table parse_errors(const std::string& path, const nlohmann::ordered_json& domains);

}  // namespace blysk::cost
