// SPDX-License-Identifier: Apache-2.0
/// Speed of every lobe against std::pow, per element, over arrays that stay in the cache, on one core.
/// Each row's counter `pow_ratio` is the time of one std::pow(double, double) over that of one element.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tb/golden/lobe.h"
#include "tb/golden/sphere.h"
#include "tb/run_program.h"

namespace {

using namespace blysk::golden;

constexpr std::size_t kCount = 1024;  // two arrays of doubles: 16 KiB, inside any first-level cache
constexpr double kExponent = 50;

/// Cosines spread over the lobe and its tail, in an order that no branch predictor learns.
template <class Real>
std::vector<Real> cosines() {
  std::vector<Real> result(kCount);
  for (std::size_t i = 0; i < kCount; ++i)
    result[i] = static_cast<Real>((i * 619) % kCount) / static_cast<Real>(kCount);
  return result;
}

void pow_each(const std::vector<double>& c, std::vector<double>& out) {
  for (std::size_t i = 0; i < kCount; ++i) out[i] = std::pow(c[i], kExponent);
}

/// Seconds of one std::pow, the least of several runs, measured in this same process.
double pow_seconds() {
  static const double seconds = [] {
    const auto c = cosines<double>();
    std::vector<double> out(kCount);
    double least = std::numeric_limits<double>::infinity();
    for (int run = 0; run < 200; ++run) {
      const auto start = std::chrono::steady_clock::now();
      pow_each(c, out);
      benchmark::DoNotOptimize(out.data());
      benchmark::ClobberMemory();
      least =
          std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    return least / static_cast<double>(kCount);
  }();
  return seconds;
}

/// A rate times the seconds of one pow is the number of elements in the time of one pow.
void count(benchmark::State& state, std::size_t elements = kCount) {
  const auto items = static_cast<double>(state.iterations()) * static_cast<double>(elements);
  state.SetItemsProcessed(static_cast<int64_t>(items));
  state.counters["pow_ratio"] = benchmark::Counter(items * pow_seconds(), benchmark::Counter::kIsRate);
}

void bench_pow(benchmark::State& state) {
  const auto c = cosines<double>();
  std::vector<double> out(kCount);
  for (auto _ : state) {
    pow_each(c, out);
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  count(state);
}

template <class Real>
void bench_lobe(benchmark::State& state, lobe which) {
  const auto c = cosines<Real>();
  std::vector<Real> out(kCount);
  for (auto _ : state) {
    evaluate(which, static_cast<Real>(kExponent), std::span<const Real>(c), std::span<Real>(out));
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  count(state);
}

/// One value after the other, as code that asks for them singly does: no two share a vector.
void bench_scalar(benchmark::State& state, lobe which) {
  const auto c = cosines<double>();
  with_lobe(which, kExponent, [&](const auto& f) {
    for (auto _ : state) {
      for (const double cosine : c) {
        double value = f(cosine);
        benchmark::DoNotOptimize(value);
      }
    }
  });
  count(state);
}

/// A whole picture: normals, diffuse light, highlight.
void bench_sphere(benchmark::State& state, lobe which) {
  const sphere_scene scene;
  std::size_t pixels = 0;
  for (auto _ : state) {
    const auto picture = shade_sphere(scene, {1, 1, 0.1, 0.3, 0.6}, which, kExponent);
    benchmark::DoNotOptimize(picture.data());
    pixels = picture.size();
  }
  count(state, pixels);
}

int run(int argc, char** argv) {
  benchmark::RegisterBenchmark("std::pow", bench_pow);
  for (const auto& [which, name] : kLobes) {
    benchmark::RegisterBenchmark(("double/" + std::string(name)).c_str(), bench_lobe<double>, which);
    benchmark::RegisterBenchmark(("float/" + std::string(name)).c_str(), bench_lobe<float>, which);
    benchmark::RegisterBenchmark(("scalar/" + std::string(name)).c_str(), bench_scalar, which);
  }
  for (const lobe which : {lobe::blinn, lobe::schlick, lobe::cosine_quadratic})
    benchmark::RegisterBenchmark(("sphere/" + std::string(name_of(which))).c_str(), bench_sphere, which);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return blysk::run_program("bench_golden", [&] { return run(argc, argv); });
}
