// SPDX-License-Identifier: Apache-2.0
// The effect units as a device give the picture of their laws on the host.
#include "tb/render/effect_units.h"

#include <algorithm>

#include "tb/catch.h"
#include "tb/render/render.h"
#include "tb/render/report.h"
#include "tb/render/test/picture_source.h"
#include "tb/render/test/random_scene.h"
#include "tb/scene/shapes.h"

namespace {

using namespace blysk;
using namespace blysk::render;

/// Rows of neighbours that see one triangle, two pixels or more.
std::uint64_t rows_of_triangles(const job& of) {
  const scene::mesh& surface = of.of->surface;
  const projection view(of.of->view ? *of.of->view : scene::fitted_camera(surface), of.width, of.height);
  const visibility seen = find_visible(surface, view, of.width, of.height, 1);
  std::uint64_t count = 0;
  for (int y = 0; y < of.height; ++y) {
    int together = 0;
    for (int x = 0; x < of.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y * of.width + x);
      const bool goes_on = x > 0 && seen.triangle[pixel] == seen.triangle[pixel - 1];
      together = goes_on ? together + 1 : 1;
      count += together == 2 && seen.triangle[pixel] != kNoTriangle ? 1U : 0U;
    }
  }
  return count;
}

/// The bit-accurate model of the effect units.
struct bit_units {
  explicit bit_units(const std::string& format, bool has_energy = false)
      : device(choose_effect_units(format, has_energy)),
        model(device.of().make_bit(device)),
        source{device, model.get(), "model"} {}

  selection device;
  std::unique_ptr<engine> model;
  attached_device source;
};

outcome picture_of(const scene::world& of, const device_source* shades, const attached_device* units,
                   const char* shading, effects asked = effects::automatic, bool by_segments = false,
                   normalisation energy = normalisation::none) {
  job wanted{.of = &of,
             .width = 20,
             .height = 20,
             .shading = &find_shading(shading),
             .asked = asked,
             .energy = energy,
             .device = shades,
             .units = units};
  if (by_segments) wanted.by_segments = segments{};
  return render::render(wanted);
}

const device& first_device() {
  return *devices().front();
}

}  // namespace

TEST_CASE("random scenes look the same with the effect units as a device", "[render]") {
  constexpr std::array kShadings{"phong", "phong", "gouraud", "flat", "polynomial"};
  std::size_t many = 0;
  std::size_t dark = 0;
  std::size_t coloured = 0;
  std::size_t normalised = 0;
  std::size_t grey = 0;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    test::scene_maker maker(seed);
    const scene::world of = maker.make();
    const char* const format = std::array{"q8", "q12", "q16", "q20"}[maker.below(4)];
    const char* const shading = kShadings[maker.below(kShadings.size())];
    const effects asked = maker.below(3) == 0 ? effects::all : effects::automatic;
    const bool by_segments = std::string(shading) == "phong" && maker.below(2) == 0;
    const normalisation energy = kNormalisations[maker.below(kNormalisations.size())].is;
    const test::picture_source shades(choose(first_device().name(), format), false);
    const bit_units units(format, energy != normalisation::none);
    CAPTURE(seed, format, shading, by_segments, energy);
    const outcome host = picture_of(of, shades.of(), nullptr, shading, asked, by_segments, energy);
    const outcome device = picture_of(of, shades.of(), &units.source, shading, asked, by_segments, energy);
    REQUIRE(device.image.rgb == host.image.rgb);
    REQUIRE(device.pixels_in_highlight == host.pixels_in_highlight);
    REQUIRE(device.device_writes == host.device_writes);
    REQUIRE(host.unit_rows == 0);
    // Each point has a row, and no light of it has two. Segments count the background as points.
    if (!by_segments) REQUIRE(device.unit_rows >= device.points);
    REQUIRE(device.unit_rows <= device.points * std::max<std::size_t>(1, of.lights.size()));
    // Which pixels segments trace depends on their colours.
    if (energy != normalisation::none && host.planned.has_specular() && !by_segments) {
      const outcome plain = picture_of(of, shades.of(), nullptr, shading, asked, by_segments);
      REQUIRE(plain.device_writes == host.device_writes);
      REQUIRE(plain.pixels_in_highlight == host.pixels_in_highlight);
      normalised += plain.image.rgb != host.image.rgb ? 1U : 0U;
    }
    many += of.lights.size() > 1 && device.pixels > 0 ? 1U : 0U;
    dark += of.lights.empty() && device.pixels > 0 ? 1U : 0U;
    const auto is_coloured = [](const light_plan& each) { return each.has_specular && !each.is_grey; };
    coloured += std::ranges::any_of(device.planned.of_lights, is_coloured) ? 1U : 0U;
    const std::vector<bool>& greys = device.planned.grey_materials;
    grey += device.pixels > 0 && std::find(greys.begin(), greys.end(), true) != greys.end() ? 1U : 0U;
  }
  CHECK(normalised > 40);
  CHECK(grey > 10);
  CHECK(many > 40);
  CHECK(dark > 10);
  CHECK(coloured > 40);
  CHECK(coloured < 360);
}

TEST_CASE("lines by a device are Gouraud's shading to two levels", "[render]") {
  const selection device = choose_span_device("q12");
  const auto model = device.of().make_bit(device);
  const attached_device lines{device, model.get(), "model"};
  const test::picture_source shades(choose(first_device().name(), "q12"), false);
  std::uint64_t drawn = 0;
  std::size_t others = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    test::scene_maker maker(seed);
    const scene::world of = maker.make();
    // On the picture a colour is linear along a row of a triangle.
    job wanted{.of = &of,
               .width = 40,
               .height = 30,
               .shading = &find_shading("gouraud"),
               .is_corrected = false,
               .device = shades.of()};
    const outcome host = render::render(wanted);
    wanted.spans = &lines;
    const outcome made = render::render(wanted);
    CAPTURE(seed);
    // Half a level of each end, of either picture; and 40 pixels times 255 levels times 2^-13, the digits of the quotient.
    REQUIRE(distance_of(host.image, made.image).largest <= 2);
    REQUIRE(made.reference.rgb == host.reference.rgb);
    REQUIRE(host.span_lines == 0);
    REQUIRE(made.span_lines == rows_of_triangles(wanted));
    drawn += made.span_lines;
    others += host.image.rgb != made.image.rgb ? 1U : 0U;
  }
  CHECK(drawn > 200);
  CHECK(others > 10);
  scene::world ball;
  ball.surface = scene::make_sphere(8);
  for (const char* shading : {"flat", "polynomial", "phong"}) {
    job refused{
        .of = &ball, .width = 8, .height = 8, .shading = &find_shading(shading), .device = shades.of()};
    render::render(refused);
    refused.spans = &lines;
    CAPTURE(shading);
    CHECK_THROWS_AS(render::render(refused), std::invalid_argument);
  }
}

TEST_CASE("a triangle wider than a line of the device has two in a row", "[render]") {
  scene::world of;
  of.surface = scene::make_sphere(2);
  of.surface.positions = {{-50, -50, 0}, {50, -50, 0}, {0, 50, 0}};
  of.surface.normals = {
      golden::normalised(scene::vec{-2, 0, 1}), golden::normalised(scene::vec{1, 0, 1}), {0, 0, 1}};
  of.surface.triangles = {{{0, 1, 2}, {0, 1, 2}, 0}};
  of.view = scene::camera{.eye = {0, 0, 0.15}, .target = {0, 0, 0}};
  const selection device = choose_span_device("q18");
  const auto model = device.of().make_bit(device);
  const attached_device lines{device, model.get(), "model"};
  const test::picture_source shades(choose(first_device().name(), "q12"), false);
  // The last pixel of 1025 is alone, and no line.
  for (const auto& [width, in_a_row] : {std::pair{1024, 1}, std::pair{1025, 1}, std::pair{1026, 2}}) {
    job wanted{.of = &of,
               .width = width,
               .height = 2,
               .shading = &find_shading("gouraud"),
               .is_corrected = false,
               .device = shades.of()};
    const outcome host = render::render(wanted);
    REQUIRE(host.pixels == static_cast<std::size_t>(2 * width));
    wanted.spans = &lines;
    const outcome made = render::render(wanted);
    CAPTURE(width);
    CHECK(made.span_lines == static_cast<std::uint64_t>(2 * in_a_row));
    CHECK(distance_of(host.image, made.image).largest <= 2);
  }
}

TEST_CASE("a row longer than a line of the device is drawn by two", "[render]") {
  const selection device = choose_span_device("q18");
  const auto model = device.of().make_bit(device);
  const attached_device lines{device, model.get(), "model"};
  picture to(1500, 2);
  span_drawer drawer(lines, to);
  drawer.add(1, 0, 1023, {0, 255, 7}, {255, 0, 7});
  drawer.add(1, 1024, 1499, {255, 0, 7}, {0, 0, 255});
  drawer.run();
  CHECK(drawer.lines() == 2);
  for (int x = 0; x < 1500; ++x) {
    CHECK(to.pixel(x, 0)[0] == 0);
    const double share = x < 1024 ? x / 1023.0 : (x - 1024) / 475.0;
    REQUIRE(std::abs(to.pixel(x, 1)[0] - 255 * (x < 1024 ? share : 1 - share)) <= 1);
    REQUIRE(std::abs(to.pixel(x, 1)[1] - (x < 1024 ? 255 * (1 - share) : 0)) <= 1);
    REQUIRE(std::abs(to.pixel(x, 1)[2] - (x < 1024 ? 7 : 7 + 248 * share)) <= 1);
  }
}

TEST_CASE("an energy factor multiplies the specular term alone, as double does", "[render]") {
  const int fraction = 16;
  for (const named_normalisation& each : kNormalisations) {
    for (const int n : {1, 2, 50, 999, 1000}) {
      const energy_share by = energy_of(each.is, n, fraction);
      const double factor = each.is == normalisation::none     ? 1
                            : each.is == normalisation::thesis ? (n + 6) / 24.55
                                                               : (n + 6) / (8 * golden::pi<double>());
      CAPTURE(each.name, n);
      CHECK(by.real == Approx(factor).epsilon(1e-14));
      CHECK((by.bits == 0) == (each.is == normalisation::none));
      if (by.bits == 0) continue;
      CHECK(by.bits == 18);
      CHECK(std::ldexp(static_cast<double>(by.code), -by.bits) ==
            Approx(factor).margin(std::ldexp(0.5, -18)));
      // 200.25 in 16 fraction bits; half a unit of the code and half of the result.
      const double term =
          std::ldexp(static_cast<double>(normalised_term(std::int64_t{801} << 14, fraction, by)), -16);
      CHECK(term == Approx(200.25 * factor).margin(200.25 * std::ldexp(0.5, -18) + std::ldexp(0.5, -16)));
    }
  }
  // The picture that it is judged by has the factor, too.
  scene::world of;
  of.surface = scene::make_sphere(24);
  for (scene::material& each : of.surface.materials) {
    each.n = 20;
    each.kd = each.ka = {0, 0, 0};
    each.ks = {0.6, 0.3, 0.6};
  }
  const test::picture_source formula(choose(first_device().name(), "q16", {}, purpose::formula), true);
  const job wanted{.of = &of,
                   .width = 64,
                   .height = 64,
                   .shading = &find_shading("phong"),
                   .energy = normalisation::thesis,
                   .device = formula.of()};
  const outcome made = render::render(wanted);
  scene::world brighter = of;
  for (scene::material& each : brighter.surface.materials) {
    for (double& channel : each.ks) channel *= 26 / 24.55;
  }
  job plain = wanted;
  plain.of = &brighter;
  plain.energy = normalisation::none;
  const outcome expected = render::render(plain);
  CHECK(made.reference.rgb == expected.reference.rgb);
  CHECK(made.planned.at(0, 0).energy.code == std::llround(26 / 24.55 * (1 << 18)));
  CHECK(expected.planned.at(0, 0).energy.bits == 0);
  CHECK(std::ranges::count(expected.planned.units, "energy") == 0);
  CHECK(distance_of(made.image, expected.image).largest <= 1);  // ks has 8 bits
  CHECK(distance_of(made.image, made.reference).nmse.value() ==
        Approx(distance_of(expected.image, expected.reference).nmse.value()).epsilon(0.05));
  CHECK(made.planned.units.back() == "saturation");
  CHECK(std::ranges::count(made.planned.units, "energy") == 1);
  const test::picture_source wide(choose(first_device().name(), "q12", {{"as-published", "on"}}), false);
  job refused = wanted;
  refused.device = wide.of();
  CHECK_THROWS_AS(render::render(refused), std::invalid_argument);
  refused.energy = normalisation::none;
  CHECK(render::render(refused).device_writes > 0);
}

TEST_CASE("a grey point in several lights has in all channels what red has", "[render]") {
  const bit_units units("q12");
  std::array<sum_rgb, 2> sums{};
  std::array<channel_rgb, 2> channels{};
  effect_units adds(units.source, {sums, channels});
  for (std::uint32_t point = 0; point < 2; ++point) {
    const bool is_grey = point == 0;
    adds.begin(point, {1000, 1000, 1000}, is_grey);
    for (const std::int32_t light : {1, 2, 3}) {
      const std::uint32_t number = adds.add({5000 * light, 5000 * light, 5000 * light}, 1000 * light);
      for (std::size_t channel = 0; channel < (is_grey ? 1 : 3); ++channel)
        adds.set_specular(number, channel, 20000 * light);
    }
  }
  adds.run();
  CHECK(adds.rows() == 6);
  CHECK(sums[0] == sums[1]);
  CHECK(channels[0] == channels[1]);
  CHECK(channels[0][0] > 0);
  CHECK(channels[0][0] < 255);
}

TEST_CASE("sixty-four full lights are white", "[render]") {
  scene::world of;
  of.surface = scene::make_sphere(16);
  scene::material& material = of.surface.materials[0];
  material.ka = material.kd = material.ks = {1, 1, 1};
  material.n = 1;
  of.ambient = {1, 1, 1};
  scene::camera view;
  view.eye = {0, 0, 5};
  view.target = {0, 0, 0};
  of.view = view;
  of.lights.assign(kMostLights, scene::light{.at = {0, 0, 1}, .colour = {1, 1, 1}});
  const test::picture_source shades(choose(first_device().name(), "q12"), false);
  const bit_units units("q12");
  for (const attached_device* each : {static_cast<const attached_device*>(nullptr), &units.source}) {
    const outcome made = picture_of(of, shades.of(), each, "phong");
    for (std::size_t channel = 0; channel < 3; ++channel) CHECK(made.image.pixel(10, 10)[channel] == 255);
    CHECK(std::ranges::count(made.image.rgb, 255) > 3 * 150);
  }
}

TEST_CASE("effect units refuse a device whose outputs they cannot take", "[render]") {
  const bit_units units("q12");
  expect_fitting(units.source, choose(first_device().name(), "q12"));
  const auto refusal = [&](const selection& shades) -> std::string {
    try {
      expect_fitting(units.source, shades);
    } catch (const std::invalid_argument& why) {
      return why.what();
    }
    return "";
  };
  CHECK(refusal(choose(first_device().name(), "q12")).empty());
  CHECK(refusal(choose(first_device().name(), "q8")).find("puts out UQ8.8") != std::string::npos);
  CHECK(refusal(choose(first_device().name(), "q12", {{"as-published", "on"}})).find("puts out SQ") !=
        std::string::npos);
}
