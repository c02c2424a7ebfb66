// SPDX-License-Identifier: Apache-2.0
// The errors of a device computed a second time, point by point and in long double, and on devices whose errors are known.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include "tb/catch_text.h"
#include "tb/cost/error_sums.h"
#include "tb/cost/errors.h"
#include "tb/golden/sphere.h"
#include "tb/golden/teapot.h"
#include "tb/specular/specular.h"

namespace {

using namespace blysk;
using namespace blysk::cost;
using real = long double;

/// cos^n rounded to nearest, ties up, in ulp: the exact power of an integer by its binary digits, in long double.
real power_of(real c, int n) {
  real result = 1;
  for (real square = c; n > 0; n /= 2, square *= square) {
    if (n % 2 == 1) result *= square;
  }
  return result;
}

/// Results of one device, one write at a time, kept.
class table_of_results {
 public:
  explicit table_of_results(const judged& of) : model_(of.make()), in_(of.stimulus) {
    in_.resize(1);
    for (std::size_t i = specular::kRed; i <= specular::kBlue; ++i)
      in_[i].set(0, 77);  // colours do not matter
  }
  real operator()(int n, std::int64_t code) {
    const auto [found, is_new] = kept_.try_emplace({n, code});
    if (is_new) {
      in_[specular::kN].set(0, n);
      in_[specular::kCos].set(0, code);
      model_->run(in_, out_);
      found->second = static_cast<real>(out_[specular::kBrdf].get(0));
    }
    return found->second;
  }

 private:
  std::unique_ptr<engine> model_;
  columns in_, out_;
  std::map<std::pair<int, std::int64_t>, real> kept_;
};

struct point {
  int n;
  std::int64_t code, before;  // -1: none
  real cos;
};

bool is_in(domain which, const point& p, real device, real exact) {
  const real inflection = p.n == 1 ? 0 : std::sqrt(1 - real(1) / p.n);
  const bool at_060 = exact >= real(0.6L) - 1e-17L;
  const bool at_056 = exact >= real(0.56L) - 1e-17L;
  const bool at_inflection = p.cos > 0 && p.cos >= inflection - 1e-17L;
  switch (which) {
    case domain::lobe:
      return std::fabs(device) * 255 >= 0.5L || exact * 255 >= 0.5L;
    case domain::epicentre:
      return at_060 || at_056 || at_inflection;
    case domain::epicentre_060:
      return at_060;
    case domain::epicentre_056:
      return at_056;
    case domain::epicentre_inflection:
      return at_inflection;
    case domain::whole:
    case domain::sphere:
    case domain::teapot:
      break;
  }
  return true;
}

errors sum_up(domain which, const std::vector<point>& points, int bits, table_of_results& results) {
  errors e;
  const real ulps = std::ldexp(real(1), bits);
  real abs = 0, bias = 0, square = 0, energy = 0, relative = 0;
  for (const point& p : points) {
    const real device = results(p.n, p.code) / ulps;
    const real exact = power_of(p.cos, p.n);
    if (!is_in(which, p, device, exact)) continue;
    ++e.points;
    const real error = device - exact;
    e.max_abs_err = std::max(e.max_abs_err, static_cast<double>(std::fabs(error)));
    abs += std::fabs(error);
    bias += error;
    square += error * error;
    energy += exact * exact;
    const auto off = static_cast<std::size_t>(std::fabs(device * ulps - std::floor(exact * ulps + 0.5L)));
    ++e.ulps[std::min<std::size_t>(off, 3)];
    if (exact * ulps >= 0.5L) {
      ++e.relative_points;
      relative += std::fabs(error) / exact;
      e.max_rel_err = std::max(e.max_rel_err, static_cast<double>(std::fabs(error) / exact));
    }
    if (p.before >= 0 && results(p.n, p.before) > results(p.n, p.code)) ++e.falls;
    const auto step = std::fabs(std::floor(device * 255 + 0.5L) - std::floor(exact * 255 + 0.5L));
    e.max_step = std::max(e.max_step, static_cast<int>(step));
  }
  const auto count = static_cast<real>(e.points);
  e.mean_abs_err = static_cast<double>(abs / count);
  e.bias = static_cast<double>(bias / count);
  e.rms_err = static_cast<double>(std::sqrt(square / count));
  e.mean_rel_err = static_cast<double>(relative / static_cast<real>(e.relative_points));
  e.error_probability = static_cast<double>(static_cast<real>(e.points - e.ulps[0]) / count);
  e.nmse = static_cast<double>(square / energy);
  return e;
}

std::vector<point> grid_points(int bits, int first_n, int last_n) {
  std::vector<point> points;
  for (int n = first_n; n <= last_n; ++n) {
    for (std::int64_t code = 0; code <= std::int64_t{1} << bits; ++code)
      points.push_back({n, code, code - 1, std::ldexp(static_cast<real>(code), -bits)});
  }
  return points;
}

/// Cosines with their codes, in increasing order.
std::vector<point> pixel_points(std::vector<double> cosines, int bits, int first_n, int last_n) {
  std::ranges::sort(cosines);
  std::vector<point> points;
  for (int n = first_n; n <= last_n; ++n) {
    std::int64_t before = -1;
    for (const double c : cosines) {
      const auto code = static_cast<std::int64_t>(std::floor(std::ldexp(c, bits) + 0.5));
      points.push_back({n, code, before, c});
      before = code;
    }
  }
  return points;
}

/// N.H by the half angle's own formula.
std::vector<point> sphere_points(int bits, int first_n, int last_n) {
  const golden::sphere_scene scene;
  std::vector<double> cosines;
  for (const auto& pixel : golden::sphere_pixels(scene)) {
    const auto& [x, y, z] = pixel.normal;
    if (x * scene.light.x + y * scene.light.y + z * scene.light.z <= 0) continue;
    cosines.push_back(golden::clamped_cosine(pixel.normal, golden::half_vector(scene.light, scene.view)));
  }
  return pixel_points(std::move(cosines), bits, first_n, last_n);
}

/// N.H = N.(L + V) / |L + V| of the teapot's pixels that the light falls on.
std::vector<point> teapot_points(int bits, int first_n, int last_n) {
  static const std::vector<golden::teapot_pixel> pixels = golden::teapot_pixels({});
  const auto light = golden::teapot_scene{}.light;
  std::vector<double> cosines;
  for (const auto& [x, y, normal, view] : pixels) {
    if (golden::dot(normal, light) <= 0 || golden::dot(normal, view) <= 0) continue;
    cosines.push_back(golden::clamped_cosine(normal, golden::normalised(light + view)));
  }
  return pixel_points(std::move(cosines), bits, first_n, last_n);
}

void check_equal(const errors& a, const errors& b) {
  CHECK(a.points == b.points);
  CHECK(a.relative_points == b.relative_points);
  CHECK(a.ulps == b.ulps);
  CHECK(a.falls == b.falls);
  CHECK(a.max_step == b.max_step);
  // Each sum of 2^18 numbers rounds at most as many times.
  const auto near = [](double x, double y) {
    CHECK(std::fabs(x - y) <= 1e-10 * std::max(1e-3, std::fabs(y)));
  };
  near(a.max_abs_err, b.max_abs_err);
  near(a.mean_abs_err, b.mean_abs_err);
  near(a.bias, b.bias);
  near(a.rms_err, b.rms_err);
  near(a.error_probability, b.error_probability);
  near(a.max_rel_err, b.max_rel_err);
  near(a.mean_rel_err, b.mean_rel_err);
  near(a.nmse, b.nmse);
}

/// The devices that shade points.
std::vector<selection> shaders(const std::string& format) {
  std::vector<selection> all;
  for (const device* each : devices()) {
    if (dynamic_cast<const specular::device_of_points*>(each) != nullptr)
      all.push_back(choose(each->name(), format));
  }
  return all;
}

bool is_of_pixels(domain which) {
  return which == domain::sphere || which == domain::teapot;
}

const errors& in(const error_table& table, domain which) {
  return table[static_cast<std::size_t>(which)];
}

/// A device of n, cos, r, g, b that gives cos^n rounded, but at `planted` inputs so much more.
class planted_engine final : public engine {
 public:
  planted_engine(int bits, std::map<std::pair<int, std::int64_t>, int> planted)
      : engine({storage::i64, storage::i64, storage::i64, storage::i64}),
        bits_(bits),
        planted_(std::move(planted)) {}

 private:
  void compute(const columns& in, columns& out) override {
    for (std::size_t i = 0; i < in.size(); ++i) {
      const auto n = static_cast<int>(in[specular::kN].get(i));
      const std::int64_t code = in[specular::kCos].get(i);
      const real exact = power_of(std::ldexp(static_cast<real>(code), -bits_), n);
      const auto found = planted_.find({n, code});
      out[specular::kBrdf].set(i, static_cast<std::int64_t>(std::floor(std::ldexp(exact, bits_) + 0.5L)) +
                                      (found == planted_.end() ? 0 : found->second));
    }
  }

  int bits_;
  std::map<std::pair<int, std::int64_t>, int> planted_;
};

judged planted(int bits, int first_n, int last_n, const std::map<std::pair<int, std::int64_t>, int>& faults) {
  return {[=] { return std::make_unique<planted_engine>(bits, faults); },
          {storage::u16, storage::u32, storage::u8, storage::u8, storage::u8},
          bits,
          first_n,
          last_n};
}

}  // namespace

TEST_CASE("errors of q8 and q10 by a loop over points", "[cost]") {
  for (const std::string format : {"q8", "q10"}) {
    for (const selection& asked : shaders(format)) {
      for (const auto& [first_n, last_n] : {std::pair{1, 3}, std::pair{50, 51}, std::pair{1000, 1000}}) {
        CAPTURE(asked.text(), first_n);
        judged of = judge(asked);
        of.first_n = first_n;
        of.last_n = last_n;
        const error_table table = measure_errors(of, 1);
        table_of_results results(of);
        const std::vector<point> grid = grid_points(of.cos_bits, first_n, last_n);
        for (const named_domain& each : kDomains) {
          if (is_of_pixels(each.which)) continue;
          CAPTURE(each.name);
          check_equal(in(table, each.which), sum_up(each.which, grid, of.cos_bits, results));
        }
        if (format == "q10") continue;
        check_equal(
            in(table, domain::sphere),
            sum_up(domain::sphere, sphere_points(of.cos_bits, first_n, last_n), of.cos_bits, results));
        check_equal(
            in(table, domain::teapot),
            sum_up(domain::teapot, teapot_points(of.cos_bits, first_n, last_n), of.cos_bits, results));
        // A domain of pixels by itself is what it is among the others.
        CHECK(json_of(measure_on_pixels(of, domain::teapot, 1)) == json_of(in(table, domain::teapot)));
      }
    }
  }
}

TEST_CASE("errors of a device that rounds cos^n correctly, and of planted faults", "[cost]") {
  const int bits = GENERATE(8, 13, 14);  // one block, two, several chunks of the wider ones
  const error_table none = measure_errors(planted(bits, 1, 40, {}), 2);
  const errors& whole = in(none, domain::whole);
  CHECK(whole.points == 40 * ((std::uint64_t{1} << bits) + 1));
  CHECK(whole.error_probability == 0);
  CHECK(whole.ulps == std::array<std::uint64_t, 4>{whole.points, 0, 0, 0});
  CHECK(whole.falls == 0);
  CHECK(whole.max_abs_err <= std::ldexp(0.5, -bits));
  CHECK(whole.max_abs_err > std::ldexp(0.49, -bits));
  CHECK(whole.max_rel_err <= 1);

  // Somewhere in the middle, at the seam of two blocks, and at both ends. A fault of one code rises and falls again.
  const std::int64_t codes = std::int64_t{1} << bits;
  const std::map<std::pair<int, std::int64_t>, int> faults{{{7, codes / 2}, 1},
                                                           {{40, std::min<std::int64_t>(4096, codes - 2)}, 2},
                                                           {{1, 0}, 3},
                                                           {{3, codes}, -200}};
  const error_table table = measure_errors(planted(bits, 1, 40, faults), 2);
  const errors& e = in(table, domain::whole);
  CHECK(e.ulps == std::array<std::uint64_t, 4>{e.points - 4, 1, 1, 2});
  CHECK(e.error_probability == 4.0 / static_cast<double>(e.points));
  CHECK(e.max_abs_n == 3);
  CHECK(e.max_abs_cos == 1);
  CHECK(e.max_abs_err == std::ldexp(200.0, -bits));
  CHECK(e.falls >= 2);  // after the first fault and at the last
  CHECK(in(table, domain::epicentre_060).max_abs_n == 3);
  CHECK(in(table, domain::epicentre_060).ulps[3] == 1);
  // cos = 0 is in no epicentre and, at 3 ulp, in the lobe only where that is half an 8-bit step.
  CHECK(in(table, domain::lobe).ulps[3] == (bits == 8 ? 2 : 1));
}

TEST_CASE("an error of just below half an ulp is none", "[cost]") {
  constexpr int kBits = 8;
  const double below = std::nextafter(0.5, 0.0);
  // On its own, and in a group that is added at once.
  for (const std::size_t size : {std::size_t{1}, kLanes + 1}) {
    const std::vector<double> cosines(size, 0.25);
    const std::vector<double> device(size, 0.0);
    for (const auto& [ulps, within] :
         {std::pair{below, 0}, std::pair{0.5, 1}, std::pair{std::nextafter(1.5, 0.0), 1}}) {
      CAPTURE(size, ulps);
      const std::vector<double> exact(size, std::ldexp(ulps, -kBits));
      error_sums sums;
      add_points({1, kBits, cosines, exact, device, 0}, 0, size, sums);
      CHECK(std::accumulate(sums.ulps[static_cast<std::size_t>(within)].begin(),
                            sums.ulps[static_cast<std::size_t>(within)].end(),
                            0.0) == static_cast<double>(size));
    }
  }
}

TEST_CASE("errors do not depend on the threads", "[cost]") {
  judged of = judge(shaders("q16").front());
  of.last_n = 3;
  CHECK(json_of(measure_errors(of, 1)) == json_of(measure_errors(of, 3)));
}

TEST_CASE("errors keep what holds for all of them", "[cost]") {
  for (const selection& asked : shaders("q8")) {
    CAPTURE(asked.text());
    const error_table table = measure_errors(judge(asked), 1);
    CHECK(in(table, domain::whole).points == 1000 * 257);
    for (const named_domain& each : kDomains) {
      CAPTURE(each.name);
      const errors& e = in(table, each.which);
      CHECK(e.points > 0);
      CHECK(e.ulps[0] + e.ulps[1] + e.ulps[2] + e.ulps[3] == e.points);
      CHECK(std::fabs(e.bias) <= e.mean_abs_err);
      CHECK(e.mean_abs_err <= e.rms_err);
      CHECK(e.rms_err <= e.max_abs_err);
      CHECK(e.relative_points <= e.points);
      CHECK(e.mean_rel_err <= e.max_rel_err);
      if (is_of_pixels(each.which)) continue;
      CHECK(e.points <= in(table, domain::whole).points);
      CHECK(e.max_abs_err <= in(table, domain::whole).max_abs_err);
    }
    for (const domain part : {domain::epicentre_060, domain::epicentre_056, domain::epicentre_inflection})
      CHECK(in(table, part).points <= in(table, domain::epicentre).points);
    CHECK(in(table, domain::epicentre_060).points < in(table, domain::epicentre_056).points);
  }
}

TEST_CASE("word lengths of a format give the format's errors", "[cost]") {
  for (const selection& asked : shaders("q8")) {
    CAPTURE(asked.text());
    CHECK(json_of(measure_errors(judge(asked), 1)) ==
          json_of(measure_errors(judge(asked, asked.of().widths(asked)), 1)));
  }
}

TEST_CASE("a table of errors is read as it was written", "[cost]") {
  judged of = judge(shaders("q8").front());
  of.last_n = 2;
  const nlohmann::ordered_json stored = json_of(measure_errors(of, 1));
  CHECK(json_of(parse_errors("file", stored)) == stored);
  nlohmann::ordered_json damaged = stored;
  damaged["lobe"].erase("bias");
  CHECK_THROWS_WITH(parse_errors("file", damaged), ContainsSubstring("file: is damaged"));
  damaged = stored;
  damaged["lobe"]["status"] = "guessed";
  CHECK_THROWS_WITH(parse_errors("file", damaged), ContainsSubstring("status is not exhaustive"));
  const auto refused = [&](const char* key, const nlohmann::ordered_json& value, const char* why) {
    nlohmann::ordered_json other = stored;
    other["whole"][key] = value;
    CHECK_THROWS_WITH(parse_errors("file", other), ContainsSubstring(why));
  };
  refused("points", -3, "points is no count");
  refused("points", 1, "ulps do not add up to points");
  refused("points", "many", "is damaged");
  refused("rms_err", -0.5, "rms_err is below zero");
  refused("rms_err", nullptr, "a key is missing or of another type");
  refused("ulps", {1, 2, 3}, "is damaged");
}
