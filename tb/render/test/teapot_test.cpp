// SPDX-License-Identifier: Apache-2.0
// The golden teapot, whose cosines the tables of errors are measured at, against the renderer's points of the built-in one.
#include "tb/golden/teapot.h"

#include <cmath>
#include <map>

#include "tb/catch.h"
#include "tb/render/incidence.h"
#include "tb/scene/shapes.h"

namespace {

using namespace blysk;
using namespace blysk::render;

struct lit {
  double nl, nh;
};

std::map<std::pair<int, int>, lit> golden_pixels(const golden::teapot_scene& of) {
  std::map<std::pair<int, int>, lit> found;
  for (const auto& [x, y, normal, view] : golden::teapot_pixels(of)) {
    const bool is_lit = golden::faces_both(normal, of.light, view);
    found[{x, y}] = {golden::clamped_cosine(normal, of.light),
                     is_lit ? golden::clamped_cosine(normal, golden::half_vector(of.light, view)) : 0};
  }
  return found;
}

/// What `blysk render teapot --size 512x512 --shading phong` gives the device.
std::map<std::pair<int, int>, lit> rendered_pixels(int side) {
  const scene::shape& shape = *scene::find_shape("teapot");
  const scene::mesh surface = shape.make(shape.density);
  const scene::light light = with_unit_directions({scene::light{}}).front();
  const projection view(scene::fitted_camera(surface), side, side);
  const visibility seen = find_visible(surface, view, side, side, 1);
  const auto points = find_shading("phong").make(surface, view, seen, true);
  std::map<std::pair<int, int>, lit> found;
  point_source::cursor near;
  point at;
  for (std::size_t i = 0; i < seen.pixels(); ++i) {
    if (!points->at(i, near, at)) continue;
    const scene::vec to_eye = golden::normalised(view.eye() - at.position);
    const incidence met = incidence_of(at, to_eye, light);
    const auto pixel = static_cast<int>(i);
    found[{pixel % side, pixel / side}] = {met.nl, half_cosine(at, to_eye, met)};
  }
  return found;
}

}  // namespace

TEST_CASE("the golden teapot has the cosines of the rendered one", "[render]") {
  const golden::teapot_scene of;
  const auto expected = golden_pixels(of);
  const auto rendered = rendered_pixels(of.side);
  CHECK(expected.size() > 50'000);
  std::size_t others =
      0;  // at outlines, where a rounding decides, and where a normal is at right angles to the light
  for (const auto& [place, one] : expected) {
    const auto found = rendered.find(place);
    const bool is_equal = found != rendered.end() && std::fabs(found->second.nl - one.nl) < 1e-9 &&
                          std::fabs(found->second.nh - one.nh) < 1e-9;
    others += is_equal ? 0 : 1;
  }
  CAPTURE(expected.size(), rendered.size(), others);
  CHECK(others <= 5);
  CHECK(rendered.size() <= expected.size() + 5);
}
