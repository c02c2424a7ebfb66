// SPDX-License-Identifier: Apache-2.0
/// Perspective, and what of a triangle a pixel sees, in homogeneous coordinates of the picture: a point (x, y, w) is seen
/// at (x / w, y / w), pixels from the upper left corner; w is its distance along the view. No triangle is clipped: the
/// planes through the eye and an edge tell on which side a pixel lies, also where a corner lies behind the eye
/// (M. Olano, T. Greer, Triangle scan conversion using 2D homogeneous coordinates, 1997).
#pragma once

#include <array>
#include <cmath>

#include "tb/scene/scene.h"

namespace blysk::render {

using scene::vec;

class projection {
 public:
  projection(const scene::camera& view, int width, int height)
      : eye_(view.eye),
        forward_(golden::normalised(view.target - view.eye)),
        right_(golden::normalised(scene::cross(forward_, golden::normalised(view.up)))),
        up_(scene::cross(right_, forward_)),
        middle_x_(width / 2.0),
        middle_y_(height / 2.0),
        scale_(std::min(middle_x_, middle_y_) / std::tan(view.fov_deg * golden::pi<double>() / 360)) {}

  const vec& eye() const { return eye_; }

  vec of(const vec& point) const {
    const vec from_eye = point - eye_;
    const double w = golden::dot(from_eye, forward_);
    return {scale_ * golden::dot(from_eye, right_) + middle_x_ * w,
            middle_y_ * w - scale_ * golden::dot(from_eye, up_), w};
  }

 private:
  vec eye_, forward_, right_, up_;
  double middle_x_, middle_y_, scale_;
};

/// A triangle on the picture.
class footprint {
 public:
  using weights = std::array<double, 3>;

  footprint() = default;
  explicit footprint(const std::array<vec, 3>& corners)
      : edges_{scene::cross(corners[1], corners[2]), scene::cross(corners[2], corners[0]),
               scene::cross(corners[0], corners[1])},
        depths_{corners[0].z, corners[1].z, corners[2].z},
        volume_(golden::dot(corners[0], edges_[0])),
        front_(volume_ < 0),
        is_before_eye_(corners[0].z > 0 && corners[1].z > 0 && corners[2].z > 0) {
    if (!front_) return;
    for (vec& each : edges_) each = -1.0 * each;  // exact: neighbours have the same edges with the other sign
    volume_ = -volume_;
  }

  /// False if it is seen from the side or has a corner in the eye.
  bool has_area() const { return std::isfinite(volume_) && volume_ > 0; }

  /// Whether its outer side is seen.
  bool is_front() const { return front_; }

  /// Whether it covers the centre of pixel (x, y). Of two triangles that share an edge through the centre one does.
  bool covers(double x, double y, weights& sides) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const vec& edge = edges_[i];
      sides[i] = edge.x * x + edge.y * y + edge.z;
      if (sides[i] < 0) return false;
      if (sides[i] == 0 && !(edge.x > 0 || (edge.x == 0 && edge.y > 0))) return false;
    }
    return true;
  }

  /// 1 / w of the point at which sides were taken.
  double nearness(const weights& sides) const { return (sides[0] + sides[1] + sides[2]) / volume_; }

  /// Shares of the corners in the point that is seen, their sum 1. Without perspective correction: in the point of the
  /// picture, unless a corner lies beside or behind the eye, where it has no place on the picture.
  weights shares(double x, double y, bool corrected) const {
    weights sides{};
    for (std::size_t i = 0; i < 3; ++i) {
      sides[i] = edges_[i].x * x + edges_[i].y * y + edges_[i].z;
      if (!corrected && is_before_eye_) sides[i] *= depths_[i];
    }
    const double sum = sides[0] + sides[1] + sides[2];
    return {sides[0] / sum, sides[1] / sum, sides[2] / sum};
  }

 private:
  std::array<vec, 3> edges_{};
  weights depths_{};
  double volume_ = 0;
  bool front_ = false;
  bool is_before_eye_ = true;
};

}  // namespace blysk::render
