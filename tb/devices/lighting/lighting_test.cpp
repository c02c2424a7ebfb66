// SPDX-License-Identifier: Apache-2.0
// The lighting unit against sums in integers.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tb/catch.h"
#include "tb/device.h"
#include "tb/harness/systemc_engine.h"

namespace {

using namespace blysk;

/// A light of a pixel, raw codes; the same in all channels but for the ambient term.
struct light {
  std::int64_t cosine;
  bool is_first;
  std::array<std::int64_t, 3> ambient;
  std::int64_t diffuse, specular;
  std::int64_t energy = 0;
};

columns rows_of(const selection& asked, const std::vector<light>& lights) {
  columns in(asked.of().ports(asked), port::role::data);
  in.resize(lights.size());
  for (std::size_t i = 0; i < lights.size(); ++i) {
    in[0].set(i, lights[i].cosine);
    in[1].set(i, lights[i].is_first ? 1 : 0);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      in[2 + channel].set(i, lights[i].ambient[channel]);
      in[5 + channel].set(i, lights[i].diffuse);
      in[8 + channel].set(i, lights[i].specular);
    }
    if (in.width() > 11) in[11].set(i, lights[i].energy);
  }
  return in;
}

/// What comes of the lights, by the bit-accurate model.
columns results_of(const selection& asked, const std::vector<light>& lights) {
  columns out;
  asked.of().make_bit(asked)->run(rows_of(asked, lights), out);
  REQUIRE(out.size() == lights.size());
  return out;
}

/// Pixels of up to `most` lights, so dim that about half of the sums stay below 255.
std::vector<light> random_lights(int fraction, int count, int most, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](std::int64_t end) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(end));
  };
  std::vector<light> lights;
  std::int64_t left = 0;
  std::int64_t dim = 1;
  for (int i = 0; i < count; ++i) {
    const bool is_first = left == 0;
    if (is_first) {
      left = 1 + below(most);
      dim = left;
    }
    --left;
    lights.push_back({below((std::int64_t{1} << fraction) + 1),
                      is_first,
                      {below(20000), below(20000), below(65281)},
                      below(65280 / dim + 1),
                      below((std::int64_t{300} << fraction) / (2 * dim))});
  }
  return lights;
}

/// x / 2^bits to nearest, ties up.
std::int64_t nearest(std::int64_t x, int bits) {
  return static_cast<std::int64_t>(std::floor(std::ldexp(static_cast<long double>(x), -bits) + 0.5L));
}

}  // namespace

TEST_CASE("a pixel of one light, by hand", "[lighting]") {
  const selection asked = choose("lighting", "q8");
  // 10.5, 0 and 255; 100 * 0.5; 20.25.
  const columns out = results_of(asked, {{128, true, {2688, 0, 65280}, 25600, 5184}});
  CHECK(out[0].get(0) == (10 + 50 + 20) * 65536 + 49152);  // 80.75
  CHECK(out[1].get(0) == 70 * 65536 + 16384);              // 70.25
  CHECK(out[2].get(0) == 255 * 65536);
  CHECK(out[3].get(0) == 81);
  CHECK(out[4].get(0) == 70);
  CHECK(out[5].get(0) == 255);
}

TEST_CASE("half a level is rounded up", "[lighting]") {
  const columns out = results_of(choose("lighting", "q12"), {{0, true, {127, 128, 65280 - 128}, 65280, 0}});
  CHECK(out[3].get(0) == 0);
  CHECK(out[4].get(0) == 1);
  CHECK(out[5].get(0) == 255);
}

TEST_CASE("a sum is saturated once for each light, which is as good as once at the end", "[lighting]") {
  for (const char* format : {"q8", "q16", "q18", "q24"}) {
    const selection asked = choose("lighting", format);
    const int fraction = asked.fraction();
    const std::vector<light> lights = random_lights(fraction, 20'000, 64, 1);
    const columns out = results_of(asked, lights);
    std::array<std::int64_t, 3> sums{};
    std::size_t saturated = 0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const light& each = lights[i];
      for (std::size_t channel = 0; channel < 3; ++channel) {
        if (each.is_first) sums[channel] = each.ambient[channel] * 256;
        sums[channel] += nearest(each.diffuse * each.cosine, fraction - 8) +
                         (fraction <= 16 ? each.specular * (1 << (16 - std::min(fraction, 16)))
                                         : nearest(each.specular, fraction - 16));
        const std::int64_t expected = std::min<std::int64_t>(sums[channel], 255 * 65536);
        CAPTURE(format, i, channel);
        REQUIRE(out[channel].get(i) == expected);
        REQUIRE(out[3 + channel].get(i) == nearest(expected, 16));
        saturated += expected < sums[channel] ? 1U : 0U;
      }
    }
    CHECK(saturated > lights.size() / 10);
    CHECK(saturated < 3 * lights.size() * 9 / 10);
  }
}

TEST_CASE("no number of lights overflows a sum", "[lighting]") {
  const selection asked = choose("lighting", "q8");
  std::vector<light> lights(1000, {256, false, {0, 0, 0}, 65280, 65280});
  lights.front().is_first = true;
  lights.push_back({0, true, {256, 512, 768}, 0, 0});
  const columns out = results_of(asked, lights);
  for (std::size_t i = 0; i < 1000; ++i) REQUIRE(out[3].get(i) == 255);
  CHECK(out[3].get(1000) == 1);
  CHECK(out[4].get(1000) == 2);
  CHECK(out[5].get(1000) == 3);
}

TEST_CASE("lights go on from one run to the next", "[lighting]") {
  const selection asked = choose("lighting", "q8");
  const auto model = asked.of().make_bit(asked);
  const auto formula = asked.of().make_golden(asked);
  columns out, real;
  const columns first = rows_of(asked, {{256, true, {256, 0, 0}, 256, 256}});
  const columns further = rows_of(asked, {{256, false, {65280, 65280, 65280}, 512, 0}});
  for (int runs = 0; runs < 2; ++runs) {
    model->run(first, out);
    formula->run(first, real);
    CHECK(out[3].get(0) == 3);
    CHECK(real[0].real(0) == 3);
    model->run(further, out);
    formula->run(further, real);
    CHECK(out[3].get(0) == 5);
    CHECK(real[0].real(0) == 5);
    CHECK(out[4].get(0) == 4);
  }
}

TEST_CASE("pixels of many lights: systemc = bit, and near the formula", "[lighting]") {
  const selection asked = choose("lighting", "q12");
  const auto device = harness::make_systemc(asked);
  const columns in = rows_of(asked, random_lights(12, 10'000, 64, 2));
  columns got, expected, real;
  device->run(in, got);
  asked.of().make_bit(asked)->run(in, expected);
  asked.of().make_golden(asked)->run(in, real);
  CHECK(got == expected);
  for (std::size_t i = 0; i < in.size(); ++i) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      // Half a unit of each light's product; specular terms of q12 are exact.
      const double off = std::ldexp(static_cast<double>(got[channel].get(i)), -16) - real[channel].real(i);
      REQUIRE(std::abs(off) <= 64 * std::ldexp(0.5, -16) + 1e-9);
      REQUIRE(std::abs(static_cast<double>(got[3 + channel].get(i)) - real[channel].real(i)) <= 0.5005);
    }
  }
  // A light each cycle, and one until the first is offered.
  const std::uint64_t before = device->cycles();
  device->run(in, got);
  CHECK(device->cycles() - before == in.size() + 1);
}

TEST_CASE("an energy factor multiplies the specular terms", "[lighting]") {
  const selection asked = choose("lighting", "q8", {{"energy", "on"}});
  // 1 + 2 * 0.5 + 3 * 2.5, 41 times 6.5 is beyond 255.
  const columns out = results_of(asked, {{128, true, {256, 256, 256}, 512, 768, 2560},
                                         {0, true, {0, 0, 0}, 0, 1664, 41 << 10},
                                         {0, true, {0, 0, 0}, 0, 1664, 1 << 10},
                                         {256, false, {0, 0, 0}, 256, 256, 0}});
  CHECK(out[0].get(0) == 9 * 65536 + 32768);
  CHECK(out[3].get(0) == 10);
  CHECK(out[3].get(1) == 255);
  CHECK(out[0].get(2) == 6 * 65536 + 32768);
  CHECK(out[0].get(3) == 7 * 65536 + 32768);
}
