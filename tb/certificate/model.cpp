// SPDX-License-Identifier: Apache-2.0
#include "tb/certificate/model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tb/certificate/definitions.h"
#include "tb/certificate/scripts.h"
#include "tb/columns.h"
#include "tb/specular/specular.h"

namespace blysk {
namespace {

constexpr std::size_t kInputs = 20000;

/// The codes of the cosine that are tried at n: all of them, or in wide formats those beside 0, the root and 1, and some
/// at random.
class codes_of {
 public:
  explicit codes_of(const selection& asked) : last_(std::uint64_t{1} << asked.fraction()), asked_(asked) {}

  bool are_all() const { return asked_.fraction() <= 20; }

  /// Calls use(first, size) for runs of codes.
  template <class Use>
  void visit(int n, Use use) {
    constexpr std::uint64_t kBlock = 1 << 14;
    if (are_all()) {
      for (std::uint64_t first = 0; first <= last_; first += kBlock)
        use(first, std::min(kBlock, last_ + 1 - first));
      return;
    }
    const auto& device = dynamic_cast<const specular::device_of_points&>(asked_.of());
    const auto root =
        static_cast<std::uint64_t>(std::llround(device.root(asked_, n) * static_cast<double>(last_)));
    for (const std::uint64_t middle : {std::uint64_t{0}, root, last_}) {
      const std::uint64_t first = middle < kBlock / 2 ? 0 : std::min(middle - kBlock / 2, last_ + 1 - kBlock);
      use(first, kBlock);
    }
    // Within the lobe.
    constexpr int kRuns = 64;
    constexpr std::uint64_t kRun = 256;
    for (int run = 0; run < kRuns; ++run) {
      const std::uint64_t span = last_ + 1 - root;
      if (span > kRun) use(root + random_() % (span - kRun), kRun);
    }
  }

 private:
  std::uint64_t last_;
  const selection& asked_;
  std::mt19937_64 random_{1};
};

columns some_inputs(const selection& asked) {
  constexpr std::uint32_t kExponents = 1000;
  const std::uint64_t last = std::uint64_t{1} << asked.fraction();
  columns in(columns(asked.of().ports(asked), port::role::data).layout());
  in.resize(kInputs);
  std::mt19937_64 random(1);
  for (std::size_t i = 0; i < kInputs; ++i) {
    // Of the lobe, which is narrow, every second one.
    const std::uint64_t n = i < 4 ? 1 + (i / 2) * (kExponents - 1) : 1 + random() % kExponents;
    const std::uint64_t span = i % 2 == 0 ? last : 1 + last / n;
    const std::uint64_t c = i < 4 ? (i % 2) * last : last - random() % (span + 1);
    in[specular::kN].set(i, static_cast<std::int64_t>(n));
    in[specular::kCos].set(i, static_cast<std::int64_t>(c));
  }
  return in;
}

}  // namespace

cost::seen_error largest_error(const selection& asked) {
  const double ulp = std::ldexp(1.0, -asked.fraction());
  const auto& device = dynamic_cast<const specular::device_of_points&>(asked.of());
  const auto formula =
      device.formula(choose(device.name(), asked.format(), asked.values(), purpose::formula));
  const auto bit = asked.of().make_bit(asked);
  columns in(columns(asked.of().ports(asked), port::role::data).layout());
  columns out(columns(asked.of().ports(asked), port::role::result).layout());
  codes_of codes(asked);
  cost::seen_error worst{.is_exhaustive = codes.are_all()};
  for (int n = 1; n <= 1000; ++n) {
    codes.visit(n, [&](std::uint64_t first, std::uint64_t size) {
      in.resize(size);
      for (std::size_t i = 0; i < size; ++i) {
        in[specular::kN].set(i, n);
        in[specular::kCos].set(i, static_cast<std::int64_t>(first + i));
      }
      bit->run(in, out);
      worst.inputs += size;
      out[specular::kBrdf].visit([&](const auto& brdf) {
        for (std::size_t i = 0; i < size; ++i) {
          const double c = static_cast<double>(first + i) * ulp;
          const double error = std::fabs(static_cast<double>(brdf[i]) * ulp - formula(n, c));
          if (error <= worst.max_abs_err) continue;
          worst.max_abs_err = error;
          worst.n = n;
          worst.cos = c;
        }
      });
    });
  }
  return worst;
}

bool are_those_of_the_model(const selection& asked, netlist::planted_fault fault) {
  const auto device = asked.of().elaborate(asked, 0);
  const netlist::gappa_netlist definitions = netlist::read_gappa(*device, kCertifiedNet, fault);
  const std::vector<port> data = of_role(asked.of().ports(asked), port::role::data);
  const columns in = some_inputs(asked);
  columns out(columns(asked.of().ports(asked), port::role::result).layout());
  asked.of().make_bit(asked)->run(in, out);
  std::size_t lit = 0;
  for (std::size_t i = 0; i < kInputs; ++i) {
    const named_numbers given{
        {data[specular::kN].name + "_code", static_cast<long double>(in[specular::kN].get(i))},
        {data[specular::kCos].name + "_code", static_cast<long double>(in[specular::kCos].get(i))}};
    const std::optional<long double> told = compute(definitions, given, kCertifiedNet);
    const auto raw = static_cast<long double>(out[specular::kBrdf].get(i));
    if (raw != 0) ++lit;
    if (told && std::ldexp(*told, asked.fraction()) == raw) continue;
    fmt::print("n = {}, cos code {}: the definitions give {}, the model code {}\n", in[specular::kN].get(i),
               in[specular::kCos].get(i),
               told ? fmt::format("{}", std::ldexp(*told, asked.fraction())) : "no path", raw);
    return false;
  }
  fmt::print("{}: {} inputs, {} with a BRDF above 0, {} paths: equal\n", asked.text(), kInputs, lit,
             definitions.paths.size());
  return lit > kInputs / 10;
}

}  // namespace blysk
