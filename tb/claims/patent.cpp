// SPDX-License-Identifier: Apache-2.0
// [P]: patent UA 60553.
#include <cmath>

#include "tb/claims/claim.h"
#include "tb/claims/sweep.h"

namespace blysk::golden {

std::vector<claim> patent_claims() {
  std::vector<claim> rows;

  const auto end_error = worst_over(1, kMaxExponent, [](int n) {
    return std::max(std::abs(quadratic(coefficient_line::exact, 1.0 * n, 1.0) - 1),
                    std::abs(quadratic(coefficient_line::exact, 1.0 * n, 0.0)));
  });
  rows.push_back({"P1", "(4) (5) (6)", "b = 1 - a, c = 0 make the quadratic 1 at cos = 1 and 0 at cos = 0",
                  "largest deviation at either end over n = 1..1000: " + number(end_error.value),
                  verdict_of(end_error.value == 0)});

  // d2/dx2 cos^n x = n cos^(n-2) x ((n-1) sin^2 x - cos^2 x)
  const auto inflection = worst_over(2, kMaxExponent, [](int n) {
    const double gamma = std::atan(1 / std::sqrt(n - 1.0));
    return std::abs((n - 1) * std::pow(std::sin(gamma), 2) - std::pow(std::cos(gamma), 2));
  });
  rows.push_back({"P2", "before (7)", "cos^n x has its inflection point at gamma = arctg(1/sqrt(n-1))",
                  "(n-1) sin^2 gamma - cos^2 gamma, the second derivative's factor, is at most " +
                      number(inflection.value, 2) + " over n = 2..1000",
                  verdict_of(inflection.value < kRounding)});

  // t carries a roundoff or two, which t^n multiplies by n.
  const auto interpolation = worst_over(2, kMaxExponent, [](int n) {
    const double t = std::sqrt((n - 1.0) / n);
    return std::abs(quadratic(coefficient_line::exact, 1.0 * n, t) - std::pow(t, n)) / n;
  });
  rows.push_back(
      {"P3", "(8) (9)", "with a from (9) the quadratic meets cos^n at the inflection point",
       "largest difference there, divided by n, over n = 2..1000: " + number(interpolation.value, 2),
       verdict_of(interpolation.value < kRounding)});

  const auto line_error = [](double slope, double offset) {
    return worst_over(1, kMaxExponent,
                      [=](int n) { return std::abs(slope * n + offset - exact_coefficient(1.0 * n)); });
  };
  const auto printed = line_error(0.786, 0.5);
  const auto turned = line_error(0.786, -0.5);
  const auto derived = line_error(coefficient_slope<double>(), -0.5);
  rows.push_back({"P4", "(10)", "a = 0.786 n + 0.5 approximates (9)",
                  "largest |line - (9)| over n = 1..1000: as printed " + at(printed) + "; with - 0.5 " +
                      at(turned) + "; with the slope 2 (1 - e^(-1/2)) = " +
                      number(coefficient_slope<double>(), 15) + " and - 0.5 " + at(derived),
                  std::string(kPartly) + ": the slope to its printed digits, not the sign of 0.5"});

  const auto quoted = [](lobe which) {
    const auto whole = worst_whole(which);
    const auto edge = worst_relative(which, epicentre::level_056);
    return at(whole) + " and " + percent_at(edge);
  };
  rows.push_back(
      {"P5", "(3) (10)",
       "the quadratic on the line (10) approximates cos^n for n in 1..1000 (no figure is given)",
       "largest absolute error over cos in [0, 1], clamped, and largest relative error where cos^n >= 0.56: "
       "published " +
           quoted(lobe::quadratic_published) + "; derived " + quoted(lobe::quadratic_derived) + "; exact a " +
           quoted(lobe::quadratic_exact),
       std::string(kAmbiguous) + ": no threshold is stated"});

  int wrong = 0;
  constexpr unsigned kMask = 0xff;
  for (unsigned a = 0; a <= kMask; ++a) {
    for (unsigned b = 0; b <= kMask; ++b) wrong += ((a + (~b & kMask) + 1) & kMask) != ((a - b) & kMask);
  }
  rows.push_back(
      {"P10", "adder 9", "inverters and a carry of 1 make the adder subtract",
       std::to_string(wrong) + " of the 65536 pairs of 8 bits differ; at any width, as ~b = 2^w - 1 - b",
       verdict_of(wrong == 0)});
  const double rom_bits = 8.0 * 2048 / 1024;
  rows.push_back({"P6", "prototype", "the prototype needs a read-only memory of at least 2 KB",
                  "n in 1..1000 takes 10 address bits, 1024 words; 2 KB give " + number(rom_bits) +
                      " bits a word. a(1000) = " + number(exact_coefficient(1000.0), 6) +
                      " takes 10 integer bits, which leaves " + number(rom_bits - 10) + " fraction bits",
                  std::string(kAmbiguous) + ": holds for words of " + number(rom_bits) + " bits"});
  rows.push_back({"P7", "task", "without the read-only memory the chip is simpler",
                  "takes the areas of both chips, synthesised alike; the prototype is not modelled",
                  std::string(kUncheckable)});
  rows.push_back({"P8", "advantage over UA 71489", "faster, as no arc cosine has to be computed",
                  "takes cycles and longest paths of both devices; UA 71489's is not modelled",
                  std::string(kUncheckable)});
  rows.push_back({"P9", "fig. 3", "the strobe's period must exceed the transients of the device",
                  "a duty of the host, without a figure; the clocked model settles within one period of clk",
                  std::string(kUncheckable)});
  return rows;
}

}  // namespace blysk::golden
