// SPDX-License-Identifier: Apache-2.0
// device_errors TABLE.csv: the device's BRDF at every cosine code against c^n, for each format and exponent.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "tb/bit/quadratic.h"
#include "tb/golden/errors.h"
#include "tb/golden/lobe_formulas.h"

namespace blysk {
namespace {

constexpr unsigned kExponents[] = {1, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000};

/// One row: max |brdf - c^n|, max |brdf / c^n - 1| in each epicentre, root of the mean square over all codes.
std::string row(const std::string& format, engine& model, int fraction, unsigned n) {
  const double one = std::ldexp(1.0, fraction);
  double max_abs = 0;
  double squares = 0;
  std::array<double, golden::kEpicentres.size()> max_rel{};
  std::array<double, golden::kEpicentres.size()> edges{};
  std::ranges::transform(golden::kEpicentres, edges.begin(),
                         [&](auto which) { return golden::epicentre_edge(which, n); });
  const std::uint64_t codes = (std::uint64_t{1} << fraction) + 1;
  batch in;
  results out;
  for (std::uint64_t first = 0; first < codes; first += 4096) {
    in.resize(std::min<std::uint64_t>(4096, codes - first));
    for (std::size_t i = 0; i < in.size(); ++i) {
      in.n[i] = static_cast<std::uint16_t>(n);
      in.cos_delta[i] = static_cast<std::uint32_t>(first + i);
    }
    model.run(in, out);
    for (std::size_t i = 0; i < in.size(); ++i) {
      const double c = in.cos_delta[i] / one;
      const double exact = golden::blinn<double>(n, c);
      const double error = std::abs(static_cast<double>(out.brdf[i]) / one - exact);
      max_abs = std::max(max_abs, error);
      squares += error * error;
      for (std::size_t e = 0; e < max_rel.size(); ++e) {
        if (c > 0 && c >= edges[e]) {
          max_rel[e] = std::max(max_rel[e], error / exact);
        }
      }
    }
  }
  return fmt::format("{},{},{:.6f},{:.6f},{:.6f},{:.6f},{:.6f}\n", format, n, max_abs, max_rel[0], max_rel[1],
                     max_rel[2], std::sqrt(squares / static_cast<double>(codes)));
}

}  // namespace
}  // namespace blysk

int main(int argc, char** argv) {
  using namespace blysk;
  if (argc != 2) {
    fmt::print(stderr, "usage: device_errors TABLE.csv\n");
    return 2;
  }
  std::string table = "format,n,max_abs_err,max_rel_err_060,max_rel_err_056,max_rel_err_inflection,rms_err\n";
  for (const std::string_view format : format_names) {
    device_options options;
    options.format = format;
    const auto model = bit::make_quadratic(options);
    for (const unsigned n : kExponents) table += row(options.format, *model, fraction_bits(options), n);
  }
  std::ofstream(argv[1]) << table;
  return 0;
}
