// SPDX-License-Identifier: Apache-2.0
#include "tb/render/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <cmath>
#include <mutex>
#include <set>
#include <span>
#include <stdexcept>

#include "tb/parallel.h"
#include "tb/render/effects/saturate.h"
#include "tb/render/inner_check.h"
#include "tb/render/reference.h"
#include "tb/render/shader.h"

namespace blysk::render {
namespace {

class stopwatch {
 public:
  explicit stopwatch(double& adds_to) : adds_to_(adds_to) {}
  ~stopwatch() {
    adds_to_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  }
  stopwatch(const stopwatch&) = delete;
  stopwatch& operator=(const stopwatch&) = delete;

 private:
  double& adds_to_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

/// Colours of points in [0, 255].
using real_rgb = std::array<float, 3>;

/// One picture in the making.
class frame {
 public:
  explicit frame(const job& asked)
      : job_(asked),
        world_(*asked.of),
        ports_(asked.device->device),
        view_(world_.view ? *world_.view : scene::fitted_camera(world_.surface), asked.width, asked.height),
        lights_(with_unit_directions(world_.lights)),
        made_{.image = picture(asked.width, asked.height), .reference = picture(asked.width, asked.height)} {}

  outcome run() {
    timed("plan", [&] { made_.planned = plan_of(job_); });
    timed("visibility", [&] {
      if (job_.by_segments) {
        seen_ = {job_.width, job_.height, {}};
        seen_.triangle.assign(made_.image.rgb.size() / 3, kNoTriangle);
      } else {
        seen_ = find_visible(world_.surface, view_, job_.width, job_.height, job_.threads);
      }
      points_ = job_.shading->make(world_.surface, view_, seen_, job_.is_corrected);
    });
    sums_.resize(points_->size());
    in_highlight_.resize(points_->size());
    if (job_.units != nullptr) channels_.resize(points_->size());
    if (job_.by_segments) {
      shade_segments();
    } else {
      shade();
    }
    timed("reference", [&] { shade_reference(); });
    timed("picture", [&] { resolve(); });
    if (job_.spans != nullptr) draw_spans();
    count();
    return std::move(made_);
  }

 private:
  static constexpr std::size_t kChunk = 8192;  // points or pixels a thread takes at a time

  template <class Work>
  void timed(const char* phase, const Work& work) {
    const stopwatch measured(made_.host_s[phase]);
    work();
  }

  /// Calls use(index, cursor, worker) for [0, count), in chunks.
  template <class Use>
  void for_each(std::size_t count, unsigned threads, const Use& use,
                const std::function<void(unsigned)>& done = {}) {
    for_each_in_parallel((count + kChunk - 1) / kChunk, threads, [&](std::size_t chunk, unsigned worker) {
      point_source::cursor near;
      const std::size_t end = std::min(count, (chunk + 1) * kChunk);
      for (std::size_t i = chunk * kChunk; i < end; ++i) use(i, near, worker);
      if (done) done(worker);
    });
  }

  /// One for each thread.
  std::vector<shader> make_shaders(unsigned threads) {
    std::vector<shader> all;
    for (unsigned i = 0; i < threads; ++i)
      all.push_back(make_shader(made_.planned.has_specular() ? job_.device->engine_of(i) : nullptr));
    return all;
  }

  shader make_shader(engine* device) {
    return {
        lights_, view_.eye(), made_.planned, ports_, device, job_.units, {sums_, channels_, in_highlight_}};
  }

  void add(shader& to, std::size_t index, point_source::cursor& near) const {
    const std::uint32_t material = points_->material_at(index);
    if (material == point_source::kNoMaterial) return;
    const auto number = static_cast<std::uint32_t>(index);
    const light_set dark = dark_.empty() ? 0 : dark_[seen_.triangle[index]];
    point at;
    if (!to.is_lit(material, dark)) {
      to.add_unlit(number, material);
    } else if (points_->at(index, near, at)) {
      to.add(number, at, dark);
    }
  }

  /// One where an engine has a clock or keeps what it has added.
  unsigned shading_threads() const {
    return job_.device->is_clocked || job_.units != nullptr ? 1 : job_.threads;
  }

  static void flush(std::vector<shader>& shaders, unsigned threads) {
    for_each_in_parallel(shaders.size(), threads, [&](std::size_t i, unsigned) { shaders[i].flush(); });
  }

  /// What shaders have cost. They ran side by side: the time is that of the longest.
  void add_costs(std::span<const shader> all) {
    double device_s = 0;
    double units_s = 0;
    for (const shader& each : all) {
      made_.device_writes += each.writes();
      made_.unit_rows += each.unit_rows();
      device_s = std::max(device_s, each.device_s());
      units_s = std::max(units_s, each.units_s());
    }
    made_.host_s["device"] += device_s;
    if (job_.units != nullptr) made_.host_s["units"] += units_s;
  }

  /// The time of shading without that of the engines.
  void split_times(double shading_s) {
    made_.host_s["shading"] = shading_s - made_.host_s["device"];
    if (job_.units != nullptr) made_.host_s["shading"] -= made_.host_s["units"];
  }

  void shade() {
    double shading_s = 0;
    {
      const stopwatch measured(shading_s);
      if (made_.planned.checks_triangles) {
        dark_ = find_dark_lights(world_.surface, view_, seen_, lights_, made_.planned, job_.is_corrected,
                                 job_.threads);
      }
      const std::vector<std::uint8_t> is_watched = shade_watched();
      const unsigned threads = shading_threads();
      std::vector<shader> shaders = make_shaders(threads);
      std::mutex guard;
      std::size_t done = 0;
      for_each(
          points_->size(), threads,
          [&](std::size_t i, point_source::cursor& near, unsigned worker) {
            if (is_watched.empty() || is_watched[i] == 0) add(shaders[worker], i, near);
          },
          [&](unsigned) {
            if (!job_.progress) return;
            const std::lock_guard lock(guard);
            done = std::min(points_->size(), done + kChunk);
            job_.progress(done, points_->size());
          });
      flush(shaders, threads);
      add_costs(shaders);
    }
    split_times(shading_s);
  }

  /// [T] 2.6: rays where the segments of the rows ask for them.
  void shade_segments() {
    const unsigned threads = shading_threads();
    std::vector<shader> shaders = make_shaders(threads);
    std::optional<ray_caster> rays;
    timed("visibility", [&] { rays.emplace(world_.surface, view_, job_.width, job_.height); });
    const auto trace = [&](std::span<const std::uint32_t> pixels) {
      timed("visibility", [&] {
        for_each(pixels.size(), job_.threads, [&](std::size_t i, point_source::cursor&, unsigned) {
          const auto pixel = static_cast<int>(pixels[i]);
          seen_.triangle[pixels[i]] = rays->triangle_at(pixel % job_.width, pixel / job_.width);
        });
      });
      timed("shading", [&] {
        for_each(pixels.size(), threads, [&](std::size_t i, point_source::cursor& near, unsigned worker) {
          add(shaders[worker], pixels[i], near);
        });
        flush(shaders, threads);
        for (const std::uint32_t pixel : pixels) {
          resolve_traced(pixel);
          if (seen_.triangle[pixel] != kNoTriangle) ++made_.points;
        }
      });
    };
    const bool by_blocks =
        std::ranges::find(kInnerColours, job_.by_segments->inner, &named_inner_colours::are)->are_of_blocks;
    made_.by_segments =
        (by_blocks ? fill_by_blocks : fill_by_segments)(made_.image, *job_.by_segments, trace);
    add_costs(shaders);
    split_times(made_.host_s["shading"]);
    // The picture is judged pixel by pixel.
    timed("reference",
          [&] { seen_ = find_visible(world_.surface, view_, job_.width, job_.height, job_.threads); });
  }

  void resolve_traced(std::uint32_t pixel) {
    std::uint8_t* const colour = made_.image.rgb.data() + 3 * std::size_t{pixel};
    for (std::size_t channel = 0; channel < 3; ++channel) {
      colour[channel] =
          seen_.triangle[pixel] == kNoTriangle ? background(channel) : channel_of_point(pixel, channel);
    }
  }

  std::uint8_t background(std::size_t channel) const {
    return static_cast<std::uint8_t>(std::lround(255 * world_.background[channel]));
  }

  /// \return  1 for the points that are done; empty if none is watched
  std::vector<std::uint8_t> shade_watched() {
    if (!job_.watch) return {};
    std::vector<std::uint8_t> is_watched(points_->size(), 0);
    point_source::cursor near;
    const rectangle asked = job_.watch->pixels ? *job_.watch->pixels : row_through_highlight();
    std::vector<std::uint32_t> order;  // as the pixels lie
    for (int y = asked.y; y < asked.y + asked.height; ++y) {
      for (int x = asked.x; x < asked.x + asked.width; ++x) {
        const auto pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(job_.width) + static_cast<std::size_t>(x);
        if (seen_.triangle[pixel] == kNoTriangle) continue;
        const mixture of = points_->of_pixel(pixel, near);
        for (std::size_t k = 0; k < of.count; ++k) {
          if (is_watched[of.point[k]]++ == 0) order.push_back(of.point[k]);
          is_watched[of.point[k]] = 1;
        }
      }
    }
    shader through = make_shader(job_.watch->through);
    near = {};
    for (const std::uint32_t each : order) add(through, each, near);
    through.flush();
    made_.watched_writes = through.writes();
    add_costs({&through, 1});
    if (job_.watch->done) job_.watch->done();
    return is_watched;
  }

  /// Around the pixel with the brightest highlight by Blinn's formula.
  rectangle row_through_highlight() const {
    point_source::cursor near;
    double best = 0;
    std::size_t place = 0;
    for (std::size_t i = 0; i < seen_.pixels(); ++i) {
      if (seen_.triangle[i] == kNoTriangle) continue;
      const mixture of = points_->of_pixel(i, near);
      point at;
      points_->at(of.point[0], near, at);
      const vec view = golden::normalised(view_.eye() - at.position);
      for (std::size_t k = 0; k < lights_.size(); ++k) {
        const light_plan& light = made_.planned.at(at.material, k);
        if (!light.has_specular) continue;
        const double nh = half_cosine(at, view, incidence_of(at, view, lights_[k]));
        const double brightness = std::ranges::max(light.specular) * std::pow(nh, light.n);
        if (brightness > best) {
          best = brightness;
          place = i;
        }
      }
    }
    const int x = static_cast<int>(place % static_cast<std::size_t>(job_.width));
    const int y = static_cast<int>(place / static_cast<std::size_t>(job_.width));
    const int first = std::max(0, x - 3 * job_.width / 16);
    return {first, y, std::min(job_.width, x + 3 * job_.width / 16 + 1) - first, 1};
  }

  void shade_reference() {
    real_.resize(points_->size());
    for_each(points_->size(), job_.threads, [&](std::size_t i, point_source::cursor& near, unsigned) {
      point at;
      if (!points_->at(i, near, at)) return;
      const auto colour = reference_colour(world_, lights_, view_.eye(), at, job_.energy);
      for (std::size_t channel = 0; channel < 3; ++channel)
        real_[i][channel] = static_cast<float>(std::min(colour[channel], 255.0));
    });
  }

  void resolve() {
    const auto width = static_cast<std::size_t>(job_.width);
    for_each(seen_.pixels(), job_.threads, [&](std::size_t i, point_source::cursor& near, unsigned) {
      std::uint8_t* const pixel = made_.image.pixel(static_cast<int>(i % width), static_cast<int>(i / width));
      std::uint8_t* const judged =
          made_.reference.pixel(static_cast<int>(i % width), static_cast<int>(i / width));
      if (seen_.triangle[i] == kNoTriangle) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
          judged[channel] = background(channel);
          if (!job_.by_segments) pixel[channel] = judged[channel];
        }
        return;
      }
      const mixture of = points_->of_pixel(i, near);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        if (!job_.by_segments) pixel[channel] = mixed(of, channel);
        double real = 0;
        for (std::size_t k = 0; k < of.count; ++k) real += of.weight[k] * double{real_[of.point[k]][channel]};
        judged[channel] = static_cast<std::uint8_t>(std::lround(std::clamp(real, 0.0, 255.0)));
      }
    });
  }

  /// Neighbours in a row that see one triangle are drawn between the colours of the two ends.
  void draw_spans() {
    span_drawer drawer(*job_.spans, made_.image);
    point_source::cursor near;
    const auto colour_at = [&](int x, int y) {
      const auto pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(job_.width) + static_cast<std::size_t>(x);
      const mixture of = points_->of_pixel(pixel, near);
      return span_drawer::colour{mixed(of, 0), mixed(of, 1), mixed(of, 2)};
    };
    for (int y = 0; y < job_.height; ++y) {
      const auto seen = seen_.triangle.begin() + std::ptrdiff_t{y} * job_.width;
      for (int left = 0, behind = 0; left < job_.width; left = behind) {
        const int most = std::min(job_.width, left + span_drawer::kMostPixels);
        for (behind = left + 1; behind < most && seen[behind] == seen[left];) ++behind;
        if (seen[left] == kNoTriangle || behind - left < 2) continue;
        drawer.add(y, left, behind - 1, colour_at(left, y), colour_at(behind - 1, y));
      }
    }
    drawer.run();
    made_.span_lines = drawer.lines();
    made_.host_s["lines"] = drawer.seconds();
  }

  std::uint8_t channel_of_point(std::size_t point, std::size_t channel) const {
    return channels_.empty() ? channel_of(saturated(sums_[point][channel])) : channels_[point][channel];
  }

  std::uint8_t mixed(const mixture& of, std::size_t channel) const {
    if (of.count == 1) return channel_of_point(of.point[0], channel);
    double sum = 0;
    for (std::size_t k = 0; k < of.count; ++k)
      sum += of.weight[k] * static_cast<double>(saturated(sums_[of.point[k]][channel]));
    return channel_of(saturated(std::llround(sum)));
  }

  void count() {
    enum : std::uint8_t { kSeen = 1, kLit = 2 };
    std::vector<std::uint8_t> of_triangle(world_.surface.triangles.size(), 0);
    point_source::cursor near;
    for (std::size_t i = 0; i < seen_.pixels(); ++i) {
      if (seen_.triangle[i] == kNoTriangle) continue;
      ++made_.pixels;
      const std::uint32_t seen = seen_.triangle[i];
      if (!dark_.empty()) made_.tests_left_out += static_cast<std::size_t>(std::popcount(dark_[seen]));
      std::uint8_t& triangle = of_triangle[seen];
      triangle |= kSeen;
      const mixture of = points_->of_pixel(i, near);
      bool is_lit = false;
      for (std::size_t k = 0; k < of.count; ++k)
        is_lit = is_lit || (of.weight[k] != 0 && in_highlight_[of.point[k]] != 0);
      if (!is_lit) continue;
      ++made_.pixels_in_highlight;
      triangle |= kLit;
    }
    for (std::size_t i = 0; i < of_triangle.size(); ++i) {
      made_.triangles_visible += (of_triangle[i] & kSeen) != 0 ? 1U : 0U;
      made_.triangles_in_highlight += (of_triangle[i] & kLit) != 0 ? 1U : 0U;
      made_.triangles_left_out += !dark_.empty() && dark_[i] != 0 ? 1U : 0U;
    }
    if (job_.by_segments) return;
    made_.points = job_.shading->is_by_pixel ? made_.pixels : points_->size();
  }

  const job& job_;
  const scene::world& world_;
  device_ports ports_;
  projection view_;
  std::vector<scene::light> lights_;
  outcome made_;
  visibility seen_{};
  std::unique_ptr<point_source> points_;
  std::vector<light_set> dark_;  // of each triangle, by the inner specular check; empty without it
  std::vector<sum_rgb> sums_;
  std::vector<channel_rgb> channels_;  // by the effect units; empty without them
  std::vector<std::uint8_t> in_highlight_;
  std::vector<real_rgb> real_;
};

}  // namespace

namespace {

void check(const job& asked) {
  if (asked.of->lights.size() > kMostLights)
    throw std::invalid_argument("the scene has more than 64 lights, expected at most as many");
  if (asked.by_segments && (asked.watch || !asked.shading->is_by_pixel))
    throw std::invalid_argument("segments are of pixels, expected shading phong and none watched");
  if (asked.spans != nullptr && asked.shading->name != "gouraud")
    throw std::invalid_argument("lines are drawn between colours of corners, expected shading gouraud");
}

}  // namespace

plan plan_of(const job& asked) {
  check(asked);
  const selection& device = asked.device->device;
  const device_ports ports(device);
  if (asked.units != nullptr) expect_fitting(*asked.units, device);
  if (asked.energy != normalisation::none && !ports.is_limited()) {
    throw std::invalid_argument(
        fmt::format("an energy factor multiplies colours of 0..255, and {} puts out more, expected a device "
                    "with options that limit it to 255",
                    device.text()));
  }
  // To try a code takes about a fiftieth of a write through SystemC.
  constexpr std::int64_t kCodesOfPixel = 16;
  constexpr std::int64_t kFewCodes = std::int64_t{1} << 20;
  const std::set<int> exponents = written_exponents(*asked.of, asked.asked);
  std::unique_ptr<engine> law;
  std::optional<lobe_table> table;
  lobe_table* lobes = asked.lobes;
  if (lobes == nullptr && asked.asked != effects::all && needs_device(*asked.of, asked.asked)) {
    law = asked.device->make_law();
    lobes = &table.emplace(device, *law);
  }
  const std::int64_t codes = ports.one() * static_cast<std::int64_t>(exponents.size());  // below cos = 1
  const bool knows_lobes = codes <= std::max(kFewCodes, kCodesOfPixel * asked.width * asked.height);
  plan made = make_plan(*asked.of, asked.asked, knows_lobes ? lobes : nullptr, ports.cos_fraction(),
                        device.top_name(), asked.energy);
  if (asked.units != nullptr) {
    made.reasons.push_back(fmt::format("ambient, diffuse, the sum and saturation run in {}, engine {}",
                                       asked.units->device.top_name(), asked.units->name));
    if (const auto grey = std::count(made.grey_materials.begin(), made.grey_materials.end(), true);
        grey > 0) {
      made.reasons.push_back(
          fmt::format("materials whose terms are all grey, so that red serves green and blue: {}", grey));
    }
  }
  if (!made.has_specular() || asked.asked == effects::all) return made;
  if (!knows_lobes) {
    made.reasons.push_back(fmt::format(
        "where lobes begin is not looked for: {} codes of cos to try are more than it could spare; "
        "inner specular check off",
        codes));
    return made;
  }
  made.checks_triangles = asked.checks_triangles && asked.shading->is_by_pixel && !asked.by_segments;
  const std::string_view why =
      made.checks_triangles    ? "on: no pixel of a triangle is tested whose cones of normals, lights and "
                                 "views keep cos below the lobe"
      : asked.by_segments      ? "off: rays are traced one by one"
      : asked.checks_triangles ? "off: the method shades points that are not pixels of one triangle"
                               : "off, as asked";
  made.reasons.push_back(fmt::format("inner specular check {}", why));
  return made;
}

outcome render(const job& asked) {
  return frame(asked).run();
}

}  // namespace blysk::render
