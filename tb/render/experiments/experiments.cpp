// SPDX-License-Identifier: Apache-2.0
#include "tb/render/experiments/experiments.h"

#include <algorithm>

#include "tb/render/incidence.h"
#include "tb/render/report.h"
#include "tb/scene/shapes.h"

namespace blysk::render {
namespace {

constexpr int kSide = 512;

/// A factor in [0, 1] as calcColor cuts it.
int code_of(double factor) {
  return static_cast<int>(255 * factor);
}

int base_of(const listing_scene& in, std::size_t channel, double nl) {
  return in.colour[channel] * code_of(in.share * nl) / 255;
}

/// Values of a lobe at the pixels, as far as they show: a lobe falls with the angle.
template <class Pixels>
std::vector<double> highlight(golden::lobe which, int n, const Pixels& pixels) {
  return golden::with_lobe(which, static_cast<double>(n), [&](const auto& lobe) {
    std::vector<double> values;
    for (const auto& each : pixels) {
      const double value = lobe(each.nh);
      if (!(255 * value >= 1)) break;
      values.push_back(value);
    }
    return values;
  });
}

}  // namespace

listing_picture::listing_picture(const scene::mesh& surface, const scene::camera& camera) {
  const projection view(camera, kSide, kSide);
  const visibility seen = find_visible(surface, view, kSide, kSide, 1);
  const auto points = find_shading("phong").make(surface, view, seen, true);
  const vec light = golden::normalised(scene::light{}.at);
  const vec half = golden::half_vector(light, golden::normalised(camera.eye - camera.target));
  point_source::cursor near;
  point at;
  for (std::size_t i = 0; i < seen.pixels(); ++i) {
    if (points->at(i, near, at))
      pixels_.push_back({golden::clamped_cosine(at.normal, light), golden::clamped_cosine(at.normal, half)});
  }
  std::ranges::stable_sort(pixels_, std::ranges::greater{}, &pixel::nh);
  for (std::size_t s = 0; s < kListingScenes.size(); ++s) {
    std::vector<double>& energy = energy_behind_[s];
    energy.assign(pixels_.size() + 1, 0);
    for (std::size_t i = pixels_.size(); i-- > 0;) {
      energy[i] = energy[i + 1];
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const int base = base_of(kListingScenes[s], channel, pixels_[i].nl);
        energy[i] += base * base;
      }
    }
  }
}

std::array<double, kListingScenes.size()> listing_picture::nmse(golden::lobe which, int n) const {
  const std::vector<double> blinn = highlight(golden::lobe::blinn, n, pixels_);
  const std::vector<double> tried = highlight(which, n, pixels_);
  const std::size_t end = std::max(blinn.size(), tried.size());
  std::array<double, kListingScenes.size()> found{};
  for (std::size_t s = 0; s < found.size(); ++s) {
    const listing_scene& in = kListingScenes[s];
    double difference = 0;
    double energy = energy_behind_[s][end];
    for (std::size_t i = 0; i < end; ++i) {
      const int a = i < blinn.size() ? code_of(in.share * blinn[i]) : 0;
      const int b = i < tried.size() ? code_of(in.share * tried[i]) : 0;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const int base = base_of(in, channel, pixels_[i].nl);
        const int first = std::min(255, base + a);
        const int second = std::min(255, base + b);
        difference += (first - second) * (first - second);
        energy += first * first;
      }
    }
    found[s] = difference / energy;
  }
  return found;
}

std::vector<segment_run> run_segments(const device_source& from) {
  std::vector<segment_run> all;
  for (const char* name : {"sphere", "teapot"}) {
    const scene::shape& shape = *scene::find_shape(name);
    scene::world of;
    of.surface = shape.make(shape.density);
    job asked{.of = &of, .width = kSide, .height = kSide, .shading = &find_shading("phong"), .device = &from};
    const picture whole = render(asked).image;
    const auto run = [&](colour_measure measure, double limit, inner_colours inner) {
      asked.by_segments = segments{.limit = limit, .measure = measure, .inner = inner};
      const outcome made = render(asked);
      const distance off = distance_of(whole, made.image);
      all.push_back({name, *asked.by_segments, *made.by_segments, off.nmse.value(), off.largest});
    };
    for (const colour_measure measure : {colour_measure::cie76, colour_measure::rgb}) {
      for (const double limit : {0.0, 1.0, 2.3, 5.0, 10.0}) run(measure, limit, inner_colours::mean);
    }
    for (const inner_colours inner :
         {inner_colours::linear, inner_colours::cubic, inner_colours::bilinear, inner_colours::bicubic})
      run(colour_measure::cie76, 2.3, inner);
  }
  return all;
}

}  // namespace blysk::render
