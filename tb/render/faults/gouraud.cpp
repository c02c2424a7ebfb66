// SPDX-License-Identifier: Apache-2.0
#include "tb/render/faults/gouraud.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tb/render/report.h"
#include "tb/render/text.h"
#include "tb/scene/shapes.h"
#include "tb/scene/turn.h"

namespace blysk::render {
namespace {

constexpr int kSide = 150;

scene::material material_of(double diffuse, double specular, int n) {
  scene::material made;
  made.kd = {diffuse, 0.8 * diffuse, 0.5 * diffuse};
  made.ks = {specular, specular, specular};
  made.n = n;
  return made;
}

/// Without light from everywhere, the camera at (0, 0, 6), a light far behind it.
scene::world world_of(scene::mesh surface, const scene::material& material) {
  scene::world made;
  made.surface = std::move(surface);
  made.surface.materials = {material};
  made.ambient = {0, 0, 0};
  made.lights = {{false, {0, 0, 1}, {1, 1, 1}}};
  scene::camera view;
  view.eye = {0, 0, 6};
  view.fov_deg = 24;
  made.view = view;
  return made;
}

/// Corners one after the other around a quadrangle of two triangles.
scene::mesh make_square(const std::array<scene::vec, 4>& corners, const std::array<scene::vec, 4>& normals) {
  scene::mesh made;
  made.positions.assign(corners.begin(), corners.end());
  made.normals.assign(normals.begin(), normals.end());
  made.triangles = {{{0, 1, 2}, {0, 1, 2}, 0}, {{0, 2, 3}, {0, 2, 3}, 0}};
  return made;
}

constexpr std::array<scene::vec, 4> kSquare{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}};

class studio {
 public:
  explicit studio(const device_source& from) : from_(from) {}

  outcome made(const scene::world& of, const char* shading, bool corrected = true) const {
    const job asked{.of = &of,
                    .width = kSide,
                    .height = kSide,
                    .shading = &find_shading(shading),
                    .is_corrected = corrected,
                    .device = &from_};
    return render(asked);
  }

 private:
  const device_source& from_;
};

int largest_red(const picture& of) {
  int largest = 0;
  for (std::size_t i = 0; i < of.rgb.size(); i += 3) largest = std::max(largest, int{of.rgb[i]});
  return largest;
}

/// Largest red less the smallest one that is not the background's 0.
double range_of_red(const picture& of) {
  int smallest = 255;
  for (std::size_t i = 0; i < of.rgb.size(); i += 3) {
    if (of.rgb[i] > 0) smallest = std::min(smallest, int{of.rgb[i]});
  }
  return largest_red(of) - smallest;
}

picture side_by_side(const picture& left, std::string_view says, const picture& right,
                     std::string_view says_right) {
  picture sheet(left.width + right.width, left.height + kTextHeight);
  paste(left, sheet, 0, kTextHeight);
  paste(right, sheet, left.width, kTextHeight);
  write_text(sheet, 4, 2, says);
  write_text(sheet, left.width + 4, 2, says_right);
  return sheet;
}

/// What both pictures differ by.
gouraud_fault compared(const studio& in, const scene::world& of, std::string name, std::string what,
                       bool against_phong) {
  const picture gouraud = in.made(of, "gouraud", against_phong).image;
  const picture other = in.made(of, against_phong ? "phong" : "gouraud").image;
  return {std::move(name),
          std::move(what),
          "largest difference of a channel, in 1/255",
          static_cast<double>(distance_of(other, gouraud).largest),
          0,
          side_by_side(gouraud, against_phong ? "Gouraud" : "on the picture", other,
                       against_phong ? "Phong" : "on the surface")};
}

gouraud_fault find_linear(const studio& in) {
  const double s = std::sqrt(0.75);
  const scene::world of = world_of(
      make_square(kSquare, {{{-s, 0, 0.5}, {s, 0, 0.5}, {s, 0, 0.5}, {-s, 0, 0.5}}}), material_of(0.8, 0, 1));
  return compared(in, of, "gouraud_a",
                  "a) intensities are interpolated in line, diffuse and specular light "
                  "are not linear: a square bent like a cylinder, 120 degrees, diffuse light",
                  true);
}

gouraud_fault find_lost(const studio& in) {
  const scene::vec up{0, 0, 1};
  scene::world of = world_of(make_square(kSquare, {{up, up, up, up}}), material_of(0.4, 0.5, 200));
  of.lights = {{true, of.view->eye, {1, 1, 1}}};
  const outcome gouraud = in.made(of, "gouraud");
  const outcome phong = in.made(of, "phong");
  return {"gouraud_b",
          "b) a highlight that no corner lies in is lost: a flat square, the light at the eye",
          "pixels in a highlight",
          static_cast<double>(gouraud.pixels_in_highlight),
          static_cast<double>(phong.pixels_in_highlight),
          side_by_side(gouraud.image, "Gouraud", phong.image, "Phong")};
}

gouraud_fault find_curvature(const studio& in) {
  scene::world of = world_of(make_zigzag(), material_of(0.9, 0, 1));
  of.lights = {{false, {0.6, 0, 0.8}, {1, 1, 1}}};
  const outcome gouraud = in.made(of, "gouraud");
  const outcome flat = in.made(of, "flat");
  return {"gouraud_c",
          "c) normals at the corners do not know of the curvature between them: a folded sheet. Phong's "
          "shading has the fault, too; beside it each plane with its own normal",
          "range of red, in 1/255",
          range_of_red(gouraud.image),
          range_of_red(flat.image),
          side_by_side(gouraud.image, "Gouraud", flat.image, "flat")};
}

gouraud_fault find_flicker(const studio& in) {
  constexpr int kFrames = 10;
  constexpr double kStepRad = M_PI / 72;  // 2.5 degrees
  const scene::mesh sphere = scene::make_sphere(8);
  gouraud_fault made{"gouraud_d",
                     "d) the brightness of a highlight changes from frame to frame: a sphere of 8 x 16 "
                     "quadrangles turned by 2.5 degrees a frame, frames 1, 4, 7 and 10",
                     "range of the brightest red over ten frames, in 1/255",
                     0,
                     0,
                     picture(4 * kSide, 2 * (kSide + kTextHeight))};
  write_text(made.sheet, 4, 2, "Gouraud");
  write_text(made.sheet, 4, kSide + kTextHeight + 2, "Phong");
  const auto follow = [&](const char* shading, int top) {
    int least = 255;
    int most = 0;
    for (int i = 0; i < kFrames; ++i) {
      scene::world of =
          world_of(scene::turned(sphere, {0, 0, 0}, {0, 1, 0}, i * kStepRad), material_of(0.4, 0.5, 50));
      of.lights = {{false, {0, 1, 1}, {1, 1, 1}}};  // the half vector meets a row of corners
      const picture frame = in.made(of, shading).image;
      least = std::min(least, largest_red(frame));
      most = std::max(most, largest_red(frame));
      if (i % 3 == 0) paste(frame, made.sheet, i / 3 * kSide, top + kTextHeight);
    }
    return static_cast<double>(most - least);
  };
  made.gouraud = follow("gouraud", 0);
  made.other = follow("phong", kSide + kTextHeight);
  return made;
}

gouraud_fault find_star(const studio& in) {
  scene::world of = world_of(scene::make_sphere(10), material_of(0, 0.9, 20));
  const outcome gouraud = in.made(of, "gouraud");
  const outcome phong = in.made(of, "phong");
  return {"gouraud_e",
          "e) a highlight that should be an ellipse is a star: a sphere of 10 x 20 quadrangles, the light "
          "behind the "
          "eye, the highlight alone",
          "largest over smallest radius of the highlight",
          roundness(gouraud.image),
          roundness(phong.image),
          side_by_side(gouraud.image, "Gouraud", phong.image, "Phong")};
}

gouraud_fault find_perspective(const studio& in) {
  scene::world of = world_of(make_square({{{-0.7, 0, 1}, {0.7, 0, 1}, {0.7, 0, -20}, {-0.7, 0, -20}}},
                                         {{{0, 1, 0}, {0, 1, 0}, {0, 0.28, 0.96}, {0, 0.28, 0.96}}}),
                             material_of(0.9, 0, 1));
  of.lights = {{false, {0, 1, 0}, {1, 1, 1}}};
  of.view->eye = {0, 1.2, 3};
  of.view->target = {0, 0, -2};
  of.view->fov_deg = 40;
  return compared(in, of, "gouraud_f",
                  "f) perspective is not regarded: a road that grows dark, interpolated on the picture and, "
                  "beside it, on the surface",
                  false);
}

}  // namespace

scene::mesh make_zigzag() {
  constexpr int kFolds = 8;
  constexpr double kHeight = 0.12;
  scene::mesh made;
  made.normals = {{0, 0, 1}};
  for (int i = 0; i <= kFolds; ++i) {
    const double x = -1 + 2.0 * i / kFolds;
    const double z = i % 2 == 0 ? 0 : kHeight;
    made.positions.push_back({x, -1, z});
    made.positions.push_back({x, 1, z});
  }
  for (std::uint32_t i = 0; i < 2 * kFolds; i += 2) {
    made.triangles.push_back({{i, i + 2, i + 3}, {0, 0, 0}, 0});
    made.triangles.push_back({{i, i + 3, i + 1}, {0, 0, 0}, 0});
  }
  return made;
}

double roundness(const picture& of) {
  const int threshold = (largest_red(of) + 1) / 2;
  const auto is_bright = [&](int x, int y) { return of.pixel(x, y)[0] >= threshold; };
  double count = 0;
  double x_sum = 0;
  double y_sum = 0;
  for (int y = 0; y < of.height; ++y) {
    for (int x = 0; x < of.width; ++x) {
      if (!is_bright(x, y)) continue;
      ++count;
      x_sum += x;
      y_sum += y;
    }
  }
  double largest = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (int y = 0; y < of.height; ++y) {
    for (int x = 0; x < of.width; ++x) {
      const double radius = std::hypot(x - x_sum / count, y - y_sum / count);
      if (is_bright(x, y)) {
        largest = std::max(largest, radius);
      } else {
        smallest = std::min(smallest, radius);
      }
    }
  }
  return largest / smallest;
}

std::vector<gouraud_fault> find_gouraud_faults(const device_source& from) {
  const studio in(from);
  return {find_linear(in),  find_lost(in), find_curvature(in),
          find_flicker(in), find_star(in), find_perspective(in)};
}

}  // namespace blysk::render
