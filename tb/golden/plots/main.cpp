// SPDX-License-Identifier: Apache-2.0
/// Writes the data of every figure, the gnuplot calls that draw it, and the page of captions.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include "tb/golden/angle.h"
#include "tb/golden/claims/claim.h"
#include "tb/golden/claims/slopes.h"
#include "tb/golden/claims/sweep.h"
#include "tb/golden/hard_forms.h"
#include "tb/golden/running_error.h"
#include "tb/golden/shift_division.h"

namespace {

using namespace blysk::golden;

struct curve {
  std::string title;
  std::function<double(double)> y;
};

struct figure {
  std::string name;
  std::string caption;  ///< one line
  std::string x_label, y_label;
  std::string log_axes;  ///< "", "x", "y" or "xy"
  std::vector<double> x;
  std::vector<curve> curves;
  std::string y_range = "[*:*]";
  std::string style = "lines lw 2";
  std::function<double(double)> abscissa = std::identity();  ///< of a curve with a parameter
};

std::vector<double> steps(double first, double last, int count) {
  std::vector<double> result;
  for (int i = 0; i <= count; ++i) result.push_back(first + (last - first) * i / count);
  return result;
}

/// Whole exponents, in even steps of their logarithm.
std::vector<double> exponents(int first, int last) {
  std::vector<double> result;
  for (const double logarithm : steps(std::log(first), std::log(last), 160)) {
    const double n = std::round(std::exp(logarithm));
    if (result.empty() || n > result.back()) result.push_back(n);
  }
  return result;
}

constexpr double kDegree = boost::math::constants::degree<double>();

/// A lobe over the angle in degrees.
curve over_angle(std::string title, lobe which, double n) {
  return {std::move(title), [=](double degrees) { return evaluate(which, n, std::cos(degrees * kDegree)); }};
}

curve over_exponents(std::string title, lobe which,
                     const std::function<double(const error_summary&)>& metric) {
  return {std::move(title),
          [=](double n) { return metric(errors_of(which)[static_cast<std::size_t>(n) - 1]); }};
}

curve relative(std::string title, lobe which, epicentre where) {
  return over_exponents(std::move(title), which, [=](const error_summary& e) {
    return 100 * e.relative[static_cast<std::size_t>(where)].value;
  });
}

curve energy(std::string title, lobe which, lobe_axis axis, double degrees) {
  return {std::move(title), [=](double n) { return lobe_reflectance(which, n, axis, degrees); }};
}

/// Largest relative error, in per cent, of the angle-based lobe (k = 5, Q = 0.5) up to the inflection point.
double angle_error(double n) {
  const double edge = std::atan(1 / std::sqrt(n - 1));
  double result = 0;
  for (const double x : steps(0, edge, 200))
    result = std::max(result, 100 * std::abs(angle_lobe(n, 5.0, 0.5, x) / std::pow(std::cos(x), n) - 1));
  return result;
}

std::vector<figure> article_figures() {
  const std::vector<double> from6 = exponents(6, 1000);
  return {
      {"article_fig2",
       "[A] fig. 2: angle-based lobe (Q = 0.5, k = 5), Blinn's and Schlick's lobe at n = 50",
       "angle, degrees",
       "value",
       "",
       steps(0, 45, 180),
       {{"angle-based", [](double x) { return angle_lobe(50.0, 5.0, 0.5, x * kDegree); }},
        over_angle("Blinn", lobe::blinn, 50),
        over_angle("Schlick", lobe::schlick, 50)}},
      {"article_fig3",
       "[A] fig. 3: largest relative error up to the inflection point, k = 5, Q = 0.5, and Schlick's",
       "n",
       "error, %",
       "xy",
       from6,
       {{"angle-based", angle_error}, relative("Schlick", lobe::schlick, epicentre::inflection)},
       "[0.1:100]"},
      {"article_fig9",
       "[A] fig. 9: deviation of fitted coef 2 pi Int from 1, k = 5, Q = 0.5",
       "n",
       "deviation",
       "x",
       from6,
       {{"|coef 2 pi Int - 1|",
         [](double n) {
           return std::abs(angle_coefficient_fitted(n, 5.0, 0.5) / angle_coefficient_exact(n, 5.0, 0.5) - 1);
         }}}},
  };
}

std::vector<figure> thesis_figures() {
  const std::vector<double> all = exponents(1, 1000);
  const auto shifts = [](int places) {
    return curve{std::to_string(places) + " shifts", [=](double k) {
                   return 100 * std::abs(shifted_quotient(k, static_cast<uint32_t>(k), places) - 1);
                 }};
  };
  return {
      {"thesis_fig2_2",
       "[T] fig. 2.2: Blinn's lobe and Schlick's at n = 20",
       "angle, degrees",
       "value",
       "",
       steps(0, 90, 180),
       {over_angle("Blinn", lobe::blinn, 20), over_angle("Schlick", lobe::schlick, 20)}},
      {"thesis_fig2_3",
       "[T] fig. 2.3: Schlick's largest relative error where cos^n >= 0.6",
       "n",
       "error, %",
       "x",
       all,
       {relative("Schlick", lobe::schlick, epicentre::level_060)}},
      {"thesis_fig2_4",
       "[T] fig. 2.4: Schlick, Blinn, and the four readings of the modified Schlick at n = 20",
       "angle, degrees",
       "value",
       "",
       steps(0, 60, 180),
       {over_angle("Schlick", lobe::schlick, 20), over_angle("Blinn", lobe::blinn, 20),
        over_angle("reading A", lobe::schlick_modified_a, 20),
        over_angle("reading B", lobe::schlick_modified_b, 20),
        over_angle("reading C", lobe::schlick_modified_c, 20),
        over_angle("reading D", lobe::schlick_modified, 20)}},
      {"thesis_fig2_5",
       "[T] fig. 2.5, [P] (3): quadratic with exact a and Blinn's lobe at n = 20, negative lobe and all",
       "angle, degrees",
       "value",
       "",
       steps(0, 90, 180),
       {over_angle("Blinn", lobe::blinn, 20), over_angle("quadratic, exact a", lobe::quadratic_exact, 20)}},
      {"thesis_fig2_6",
       "[T] fig. 2.6: relative error of the quadratic with exact a at n = 20 down to its root",
       "angle, degrees",
       "error, %",
       "",
       steps(0, std::acos(1 - 1 / exact_coefficient(20.0)) / kDegree, 160),
       {{"quadratic, exact a",
         [](double degrees) {
           const double c = std::cos(degrees * kDegree);
           return 100 * (evaluate(lobe::quadratic_exact, 20.0, c) / blinn(20.0, c) - 1);
         }}}},
      {"thesis_fig2_7",
       "[T] fig. 2.7: the quadratic's largest relative error where cos^n >= 0.56, by line of a",
       "n",
       "error, %",
       "xy",
       exponents(2, 512),
       {relative("exact a", lobe::quadratic_exact, epicentre::level_056),
        relative("derived line", lobe::quadratic_derived, epicentre::level_056),
        relative("published line", lobe::quadratic_published, epicentre::level_056)}},
      {"thesis_fig2_10",
       "[T] fig. 2.10: the cosine-quadratic's largest relative error, by epicentre",
       "n",
       "error, %",
       "x",
       exponents(2, 1000),
       {relative("cos^n >= 0.6", lobe::cosine_quadratic, epicentre::level_060),
        relative("cos^n >= 0.56", lobe::cosine_quadratic, epicentre::level_056),
        relative("up to the inflection point", lobe::cosine_quadratic, epicentre::inflection)}},
      {"thesis_fig2_12",
       "[T] fig. 2.12: relative error of division by shifts",
       "k, pixels",
       "error, %",
       "",
       steps(2, 16, 14),
       {shifts(6), shifts(7), shifts(8)}},
      {"thesis_fig2_15",
       "[T] fig. 2.15: reflectance of the cosine-quadratic at normal incidence; energy is kept below 1",
       "n",
       "R",
       "x",
       all,
       {energy("cosine-quadratic", lobe::cosine_quadratic, lobe_axis::half_vector, 0)}},
      {"thesis_fig2_16",
       "[T] fig. 2.16: reflectance of the normalised lobes at normal incidence, and of the safe ones",
       "n",
       "R",
       "x",
       all,
       {energy("(n+6)/24.55 cosine-quadratic", lobe::cosine_quadratic_energy, lobe_axis::half_vector, 0),
        energy("(n+6)/(8 pi) Blinn", lobe::blinn_normalised, lobe_axis::half_vector, 0),
        energy("(n+1)/(8 pi) cosine-quadratic", lobe::cosine_quadratic_energy_safe, lobe_axis::half_vector,
               0),
        energy("safe quadratic", lobe::quadratic_energy_safe, lobe_axis::half_vector, 0)}},
  };
}

std::vector<figure> own_figures() {
  const std::vector<double> all = exponents(1, 1000);
  const std::vector<double> from2 = exponents(2, 1000);
  figure whole{"errors_whole",
               "Largest absolute error against cos^n over the whole range, lobes limited to [0, 1]",
               "n",
               "error",
               "x",
               all,
               {}};
  figure inside{"errors_epicentre",
                "Largest relative error against cos^n where cos^n >= 0.56",
                "n",
                "error, %",
                "xy",
                from2,
                {}};
  for (const auto& [title, which] : {std::pair{"Schlick", lobe::schlick},
                                     {"Schlick modified", lobe::schlick_modified},
                                     {"quadratic, derived", lobe::quadratic_derived},
                                     {"cosine-quadratic", lobe::cosine_quadratic},
                                     {"Lyon 2", lobe::lyon_2},
                                     {"Lyon 8", lobe::lyon_8},
                                     {"GX", lobe::gx},
                                     {"rational", lobe::rational}}) {
    whole.curves.push_back(
        over_exponents(title, which, [](const error_summary& e) { return e.whole.value; }));
    inside.curves.push_back(relative(title, which, epicentre::level_056));
  }
  return {
      whole,
      inside,
      {"slope_front",
       "Line a = slope n - 1/2: epicentre against whole-range error, a mark each 0.05",
       "largest absolute error, whole range",
       "largest relative error, epicentre",
       "",
       steps(0.3, 1, 14),
       {{"cos^n >= 0.56, slope from 0.3 (top right) to 1",
         [](double s) { return slope_error(s, slope_axis::epicentre, 1); }},
        {"the same without n = 1", [](double s) { return slope_error(s, slope_axis::epicentre, 2); }},
        {"up to the inflection point, from n = 2",
         [](double s) { return slope_error(s, slope_axis::inflection, 2); }}},
       "[0:*]",
       "linespoints lw 2 pt 7 ps 0.7",
       [](double s) { return slope_error(s, slope_axis::whole, 1); }},
      {"slope_errors",
       "Slope of the line a = slope n - 1/2: whole range against epicentre",
       "slope",
       "error",
       "",
       steps(0.2, 1.1, 90),
       {{"largest absolute, whole range", [](double s) { return slope_error(s, slope_axis::whole, 1); }},
        {"largest relative, cos^n >= 0.56",
         [](double s) { return slope_error(s, slope_axis::epicentre, 1); }},
        {"the same without n = 1", [](double s) { return slope_error(s, slope_axis::epicentre, 2); }},
        {"largest relative, to the inflection point",
         [](double s) { return slope_error(s, slope_axis::inflection, 2); }}}},
      {"line_of_a",
       "[P] (10): distance of three lines from (9)",
       "n",
       "line - (9)",
       "x",
       from2,
       {{"0.786 n + 0.5", [](double n) { return 0.786 * n + 0.5 - exact_coefficient(n); }},
        {"0.786 n - 0.5", [](double n) { return 0.786 * n - 0.5 - exact_coefficient(n); }},
        {"2 (1 - e^{-1/2}) n - 0.5",
         [](double n) { return coefficient(coefficient_line::derived, n) - exact_coefficient(n); }}}},
      {"energy_oblique",
       "Reflectance of the published and the safe cosine-quadratic by incidence, n = 17",
       "incidence, degrees",
       "R",
       "",
       steps(0, 88, 88),
       {{"(n+6)/24.55",
         [](double d) {
           return lobe_reflectance(lobe::cosine_quadratic_energy, 17, lobe_axis::half_vector, d);
         }},
        {"(n+1)/(8 pi)",
         [](double d) {
           return lobe_reflectance(lobe::cosine_quadratic_energy_safe, 17, lobe_axis::half_vector, d);
         }}}},
  };
}

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
       "c^{1000} in float leaves the normal numbers at c = 0.9164: half their spacing is what is lost",
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

void write_data(const std::filesystem::path& directory, const figure& f) {
  std::ofstream out(directory / (f.name + ".csv"));
  out.precision(9);
  out << f.x_label;
  for (const auto& c : f.curves) out << ';' << c.title;
  out << '\n';
  for (const double x : f.x) {
    out << f.abscissa(x);
    for (const auto& c : f.curves) {
      const double y = c.y(x);
      // Nothing but rounding, also in per cent, has no place on a logarithmic axis that starts by itself.
      if (f.log_axes.ends_with('y') && f.y_range == "[*:*]" && y < 100 * kRounding) {
        out << ";nan";
      } else {
        out << ';' << y;
      }
    }
    out << '\n';
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: golden_plots DATA CAPTIONS\n"
                 "  DATA      directory for NAME.csv of every figure and figures.gp, which calls curves.gp "
                 "for each\n"
                 "  CAPTIONS  the page that shows them, for example docs/figures/README.md\n";
    return 2;
  }
  const std::filesystem::path data(argv[1]);
  std::filesystem::create_directories(data);
  std::ofstream calls(data / "figures.gp");
  std::ofstream captions(argv[2]);
  captions << "<!-- generated by golden_plots; do not edit -->\n# Figures\n\n"
              "Curves of the seeds measured again, and the project's own. `ninja plots` draws them all.\n\n"
              "[T] fig. 3.13 draws time against n. It is not drawn here: no lobe but reading C of the "
              "modified Schlick and "
              "those that contain cos^n does anything that depends on n, so a curve would show the machine. "
              "Ratios at n = "
              "50 are in [speed.csv](../tables/speed.csv).\n";
  for (const auto& figures : {article_figures(), thesis_figures(), own_figures(), hard_figures()}) {
    for (const auto& f : figures) {
      write_data(data, f);
      calls << "call script";
      for (const std::string& argument : {f.name, f.caption, f.x_label, f.y_label, f.log_axes, f.y_range,
                                          f.style, std::to_string(f.curves.size() + 1)})
        calls << " \"" << argument << '"';
      calls << '\n';
      captions << "\n![" << f.name << "](" << f.name << ".svg)\n\n" << f.caption << "\n";
    }
  }
  if (!calls.flush() || !captions.flush()) {
    std::cerr << "golden_plots: cannot write " << argv[1] << " or " << argv[2] << "\n";
    return 2;
  }
}
