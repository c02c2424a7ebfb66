// SPDX-License-Identifier: Apache-2.0
// What the plan leaves out would have added nothing.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <functional>

#include "tb/catch.h"
#include "tb/render/effects/ambient.h"
#include "tb/render/effects/diffuse.h"
#include "tb/render/effects/saturate.h"
#include "tb/render/effects/specular.h"
#include "tb/render/render.h"
#include "tb/render/report.h"
#include "tb/render/test/picture_source.h"
#include "tb/render/test/random_scene.h"
#include "tb/scene/read_scene.h"
#include "tb/scene/shapes.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;
using namespace blysk::render;

using source = test::picture_source;

outcome picture_of(const scene::world& of, const source& from, effects asked, const char* shading = "phong",
                   int side = 20, normalisation energy = normalisation::none) {
  const job asked_for{.of = &of,
                      .width = side,
                      .height = side,
                      .shading = &find_shading(shading),
                      .asked = asked,
                      .energy = energy,
                      .device = from.of()};
  return render::render(asked_for);
}

/// Devices that shade points.
std::vector<const device*> shading_devices() {
  std::vector<const device*> all;
  for (const device* each : devices()) {
    try {
      device_ports ports(choose(each->name(), "q8"));
      all.push_back(each);
    } catch (const std::invalid_argument&) {
    }
  }
  return all;
}

/// Pictures of random scenes with effects left out and with all of them.
void compare(std::uint64_t first_seed, std::uint64_t count) {
  const auto all = shading_devices();
  constexpr std::array kFormats{"q8", "q10", "q12"};
  constexpr std::array kShadings{"phong", "phong", "gouraud", "flat", "polynomial"};
  std::size_t written = 0;
  std::size_t dark = 0;
  for (std::uint64_t seed = first_seed; seed < first_seed + count; ++seed) {
    test::scene_maker maker(seed);
    const scene::world of = maker.make();
    const device& device = *all[maker.below(all.size())];
    const char* format = kFormats[maker.below(kFormats.size())];
    const bool is_formula = maker.below(4) == 0;
    const char* shading = kShadings[maker.below(kShadings.size())];
    const source from(choose(device.name(), format, {}, is_formula ? purpose::formula : purpose::hardware),
                      is_formula);
    const normalisation energy = kNormalisations[maker.below(kNormalisations.size())].is;
    const outcome few = picture_of(of, from, effects::automatic, shading, 20, energy);
    const outcome every = picture_of(of, from, effects::all, shading, 20, energy);
    CAPTURE(seed, device.name(), format, is_formula, shading, energy);
    REQUIRE(few.image.rgb == every.image.rgb);
    REQUIRE(few.pixels_in_highlight == every.pixels_in_highlight);
    REQUIRE(every.device_writes == every.points * of.lights.size());
    if (of.lights.size() == 1 && std::string(shading) == "phong")
      REQUIRE(few.device_writes == few.pixels_in_highlight);
    written += few.device_writes;
    dark += few.device_writes == 0 ? 1 : 0;
  }
  CHECK(written > count);    // highlights are there
  CHECK(dark > count / 10);  // and scenes without one
  CHECK(dark < count * 9 / 10);
}

TEST_CASE("random scenes look the same with all effects", "[render]") {
  compare(1, 400);
}

TEST_CASE("ten thousand random scenes look the same with all effects", "[render][full]") {
  compare(1000, 10'000);
}

TEST_CASE("the test models of assimp look the same with all effects", "[render][full]") {
  const std::filesystem::path models = "/usr/share/assimp/models";
  const source bit(choose(devices().front()->name(), "q12"), false);
  const source formula(choose(devices().front()->name(), "q12", {}, purpose::formula), true);
  std::size_t compared = 0;
  std::size_t lit = 0;
  for (const char* folder : {"OBJ", "3DS", "PLY"}) {
    for (const auto& entry : std::filesystem::directory_iterator(models / folder)) {
      std::string ending = entry.path().extension().string();
      std::ranges::transform(ending, ending.begin(), [](unsigned char each) { return std::tolower(each); });
      if (ending != ".obj" && ending != ".3ds" && ending != ".ply") continue;
      scene::read_world read;
      try {
        read = scene::read_scene(entry.path().string(), 0);
      } catch (const usage_error&) {
        continue;  // broken on purpose
      }
      CAPTURE(entry.path());
      for (const source* from : {&bit, &formula}) {
        for (const char* shading : {"phong", "gouraud"}) {
          const outcome few = picture_of(read.of, *from, effects::automatic, shading, 48);
          const outcome every = picture_of(read.of, *from, effects::all, shading, 48);
          CHECK(few.image.rgb == every.image.rgb);
          CHECK(few.pixels_in_highlight == every.pixels_in_highlight);
          lit += few.pixels_in_highlight > 0 ? 1U : 0U;
        }
      }
      ++compared;
    }
  }
  CHECK(compared >= 25);
  CHECK(lit >= 12);
}

TEST_CASE("a lobe begins at the first code that gives anything", "[render]") {
  for (const device* each : shading_devices()) {
    for (const char* format : {"q8", "q10"}) {
      const selection asked = choose(each->name(), format);
      const device_ports ports(asked);
      const auto law = each->make_bit(asked);
      const auto own = each->make_bit(asked);
      lobe_table table(asked, *law);
      columns writes = ports.make_writes();
      columns results;
      for (int n = 1; n <= 1000; ++n) {
        writes.resize(static_cast<std::size_t>(ports.one()) + 1);
        // The colour of a write is any: 1 gives no more than 255.
        for (std::size_t code = 0; code < writes.size(); ++code)
          ports.set(writes, code, n, static_cast<std::int64_t>(code),
                    {255, 1, static_cast<std::uint8_t>(n % 256)});
        own->run(writes, results);
        const std::int64_t begin = table.begin(n);
        for (std::size_t code = 0; code < static_cast<std::size_t>(begin); ++code) {
          if (!ports.is_dark(results, code))
            FAIL(each->name() << " " << format << " n " << n << " code " << code);
        }
        CAPTURE(each->name(), format, n, begin);
        REQUIRE(begin <= ports.one());
        REQUIRE(!ports.is_dark(results, static_cast<std::size_t>(begin)));
        REQUIRE(table.begin(n) == begin);
      }
    }
  }
}

TEST_CASE("grey: one multiplier of a device gives what three give", "[render]") {
  for (const device* each : shading_devices()) {
    const selection asked = choose(each->name(), "q10");
    const device_ports ports(asked);
    const auto law = each->make_bit(asked);
    columns writes = ports.make_writes();
    columns results;
    writes.resize(256);
    for (const int n : {1, 7, 50, 1000}) {
      for (std::int64_t code = 0; code <= ports.one(); ++code) {
        for (std::size_t grey = 0; grey < 256; ++grey) {
          const auto value = static_cast<std::uint8_t>(grey);
          ports.set(writes, grey, n, code, {value, value, value});
        }
        law->run(writes, results);
        for (std::size_t grey = 0; grey < 256; ++grey) {
          if (ports.term(results, grey, 0) != ports.term(results, grey, 1) ||
              ports.term(results, grey, 0) != ports.term(results, grey, 2))
            FAIL(each->name() << " n " << n << " code " << code << " grey " << grey);
        }
      }
    }
  }
}

TEST_CASE("the plan of a scene is what it calls for", "[render]") {
  scene::world of;
  of.surface = scene::make_sphere(8);
  const source from(choose(devices().front()->name(), "q12"), false);
  const auto planned = [&](effects asked = effects::automatic) {
    return plan_of(job{.of = &of, .shading = &find_shading("phong"), .asked = asked, .device = from.of()});
  };
  CHECK(planned().units.size() == 5);
  CHECK(planned().has_specular());
  CHECK(!planned().at(0, 0).is_grey);
  of.surface.materials[0].ks = {0.5, 0.5, 0.5};
  CHECK(planned().at(0, 0).is_grey);
  CHECK(!planned(effects::all).at(0, 0).is_grey);
  of.lights[0].colour = {1, 0, 0};
  CHECK(!planned().at(0, 0).is_grey);
  // Half of 1/255 is the least that the ports can hold.
  of.surface.materials[0].ks = {0.49 / 255, 1, 1};
  CHECK(!planned().has_specular());
  CHECK(!needs_device(of, effects::automatic));
  CHECK(needs_device(of, effects::all));
  of.surface.materials[0].ks = {0.51 / 255, 1, 1};
  CHECK(planned().has_specular());
  of.lights[0].colour = {0, 0, 0};
  CHECK(planned().units == std::vector<std::string>{"ambient", "saturation"});
  of.ambient = {0, 0, 0};
  CHECK(planned().units == std::vector<std::string>{"saturation"});
  of.surface.materials[0].emitted = {0, 0.1, 0};
  CHECK(planned().units == std::vector<std::string>{"ambient", "saturation"});
  // A material that no triangle has counts for nothing.
  of.lights[0].colour = {1, 1, 1};
  of.surface.materials[0].ks = of.surface.materials[0].kd = {0, 0, 0};
  of.surface.materials.push_back(scene::make_sphere(2).materials[0]);
  CHECK(planned().units == std::vector<std::string>{"ambient", "saturation"});
}

TEST_CASE("a material is grey if all its terms are", "[render]") {
  scene::world of;
  of.surface = scene::make_sphere(8);
  const source from(choose(devices().front()->name(), "q12"), false);
  const auto greys = [&](effects asked = effects::automatic) {
    return plan_of(job{.of = &of, .shading = &find_shading("phong"), .asked = asked, .device = from.of()})
        .grey_materials;
  };
  const auto is_grey = [&](effects asked = effects::automatic) -> bool { return greys(asked).at(0); };
  CHECK(!is_grey());
  scene::material& material = of.surface.materials[0];
  material.ka = material.kd = material.ks = {0.5, 0.5, 0.5};
  CHECK(is_grey());
  CHECK(!is_grey(effects::all));
  of.lights.push_back({.at = {0, 0, 1}, .colour = {0.25, 0.25, 0.25}});
  CHECK(is_grey());
  for (scene::rgb* each : {&material.ka, &material.kd, &material.ks, &material.emitted, &of.ambient,
                           &of.lights[0].colour, &of.lights[1].colour}) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const scene::rgb before = *each;
      (*each)[channel] += 0.125;
      CAPTURE(channel);
      CHECK(!is_grey());
      *each = before;
    }
  }
  CHECK(is_grey());
  // A material that no triangle has is nothing's.
  of.surface.materials.push_back(scene::material(material));
  CHECK(greys() == std::vector{true, false});
}

TEST_CASE("effects are exact to half a unit of their sums", "[render]") {
  CHECK(coefficient_code(1) == 255 * 256);
  CHECK(coefficient_code(2) == 255 * 256);
  CHECK(coefficient_code(-1) == 0);
  CHECK(ambient_term(coefficient_code(1)) == 255 << 16);
  for (const int fraction : {8, 12, 16, 24}) {
    CHECK(diffuse_term(255 * 256, std::int64_t{1} << fraction, fraction) == 255 << 16);
    for (std::int64_t code = 0; code <= std::int64_t{1} << std::min(fraction, 10); ++code) {
      const double exact = std::ldexp(12345.0 * static_cast<double>(code), 16 - 8 - fraction);
      REQUIRE(std::abs(static_cast<double>(diffuse_term(12345, code, fraction)) - exact) <= 0.5);
      REQUIRE(std::abs(static_cast<double>(specular_term(code * 255, fraction)) -
                       std::ldexp(255.0 * static_cast<double>(code), 16 - fraction)) <= 0.5);
    }
  }
  CHECK(specular_term(-3, 0) == -3 * 65536);
  CHECK(saturated(-1) == 0);
  CHECK(saturated(256 << 16) == 255 << 16);
  CHECK(channel_of(0x7FFF) == 0);
  CHECK(channel_of(0x8000) == 1);
  CHECK(channel_of(255 << 16) == 255);
}

TEST_CASE("a sphere seen from afar is that of the closed form", "[render]") {
  // From 1e6 radii the view is (0, 0, 1) for all points, to 1e-6; with normals of 200 rings the mesh is off by 1e-4.
  scene::world of;
  of.surface = scene::make_sphere(200);
  scene::material& material = of.surface.materials[0];
  material = {.name = "", .ka = {0.5, 0.5, 0.5}, .kd = {0.4, 0.3, 0.2}, .ks = {0.3, 0.2, 0.1}, .n = 20};
  scene::camera view;
  view.eye = {0, 0, 1e6};
  view.fov_deg = 2 * std::atan(1.25e-6) * 180 / M_PI;
  of.view = view;
  const source from(choose(devices().front()->name(), "q16"), false);
  constexpr int kSide = 80;
  const outcome made = picture_of(of, from, effects::automatic, "phong", kSide);
  const scene::vec light = golden::normalised(of.lights[0].at);
  const scene::vec half = golden::normalised(light + scene::vec{0, 0, 1});
  int compared = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double u = (x + 0.5 - kSide / 2.0) / (kSide / 2.0) * 1.25;
      const double v = -(y + 0.5 - kSide / 2.0) / (kSide / 2.0) * 1.25;
      if (u * u + v * v > 0.9) continue;
      const scene::vec normal{u, v, std::sqrt(1 - u * u - v * v)};
      const double nl = std::max(0.0, golden::dot(normal, light));
      const double lobe = nl > 0 ? std::pow(std::max(0.0, golden::dot(normal, half)), 20) : 0;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double exact = 255 * (0.2 * 0.5 + material.kd[channel] * nl + material.ks[channel] * lobe);
        CAPTURE(x, y, channel, exact);
        // Half a level of rounding, and what a normal off by 1e-3 makes of the lobe, whose slope is at most 20.
        REQUIRE(std::abs(made.reference.pixel(x, y)[channel] - exact) <= 0.5 + 255 * (0.4 + 0.3 * 20) * 1e-3);
        ++compared;
      }
    }
  }
  CHECK(compared > 3 * 2000);
}

TEST_CASE("distances of pictures are those of their formulas", "[render]") {
  picture a(2, 1);
  picture b(2, 1);
  a.rgb = {10, 20, 30, 0, 0, 0};
  b.rgb = {10, 22, 30, 3, 0, 0};
  const auto off = distance_of(a, b);
  CHECK(off.nmse.value() == Approx((4.0 + 9.0) / (100 + 400 + 900)));
  CHECK(*off.psnr_db == Approx(10 * std::log10(255.0 * 255.0 * 6 / 13)));
  CHECK(off.pixels_off == 1);
  CHECK(off.largest == 3);
  CHECK(distance_of(a, a).nmse == 0);
  CHECK(!distance_of(a, a).psnr_db);
  CHECK(!distance_of(picture(2, 1), b).nmse);  // nothing to take a share of
  CHECK(verdict({}) == "undefined, the reference is black");
  CHECK(verdict(1e-4) == "no visible difference");
  CHECK(verdict(2.6e-4) == "visible difference");
}

}  // namespace
