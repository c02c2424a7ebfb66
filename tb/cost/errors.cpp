// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>
#include <span>
#include <stdexcept>

#include "tb/cost/cost_row.h"
#include "tb/cost/error_sums.h"
#include "tb/golden/errors.h"
#include "tb/golden/sphere.h"
#include "tb/golden/teapot.h"
#include "tb/parallel.h"
#include "tb/specular/specular.h"

namespace blysk::cost {
namespace {

constexpr std::size_t kBlock = 4096;        // points whose columns stay in the cache
constexpr std::size_t kChunk = 8 * kBlock;  // points whose sums are added up together, whatever the threads

/// Cosines in increasing order, with the codes that stand for them.
struct point_list {
  std::vector<std::uint32_t> codes;
  std::vector<double> cosines;
  std::size_t size = 0;
  domain where = domain::whole;  // every code, and no vectors; or a domain of pixels

  bool is_grid() const { return where == domain::whole; }
  std::uint32_t code(std::size_t i) const { return is_grid() ? static_cast<std::uint32_t>(i) : codes[i]; }
};

point_list grid_of(int bits) {
  return {{}, {}, (std::size_t{1} << bits) + 1, domain::whole};
}

using vec = golden::vec3<double>;

/// The cosines N.H of the sphere's lit pixels.
std::vector<double> sphere_cosines() {
  std::vector<double> cosines;
  const golden::sphere_scene scene;
  const vec half = golden::half_vector(scene.light, scene.view);
  for (const auto& [x, y, normal] : golden::sphere_pixels(scene)) {
    if (golden::faces_both(normal, scene.light, scene.view))
      cosines.push_back(golden::clamped_cosine(normal, half));
  }
  return cosines;
}

/// Those of the teapot's, whose view differs from pixel to pixel.
std::vector<double> teapot_cosines() {
  std::vector<double> cosines;
  const golden::teapot_scene scene;
  for (const auto& [x, y, normal, view] : golden::teapot_pixels(scene)) {
    if (golden::faces_both(normal, scene.light, view))
      cosines.push_back(golden::clamped_cosine(normal, golden::half_vector(scene.light, view)));
  }
  return cosines;
}

/// \param where  sphere or teapot
point_list pixels_of(domain where, int bits) {
  point_list points{{}, where == domain::sphere ? sphere_cosines() : teapot_cosines(), 0, where};
  std::ranges::sort(points.cosines);
  for (const double c : points.cosines)
    points.codes.push_back(static_cast<std::uint32_t>(std::llround(std::ldexp(c, bits))));
  points.size = points.cosines.size();
  return points;
}

/// Where the epicentres begin at each n.
struct edges {
  static constexpr std::size_t kCount = golden::kEpicentres.size() + 1;  // the widest, then the three

  explicit edges(int first_n, int last_n) {
    for (int n = first_n; n <= last_n; ++n) {
      std::array<double, kCount>& row = of_n.emplace_back();
      for (std::size_t e = 0; e < golden::kEpicentres.size(); ++e) {
        // cos = 0 is in none, although the inflection point of n = 1 lies there.
        row[1 + e] =
            std::max(golden::epicentre_edge(golden::kEpicentres[e], n), std::numeric_limits<double>::min());
      }
      row[0] = *std::min_element(row.begin() + 1, row.end());
    }
  }
  std::vector<std::array<double, kCount>> of_n;
};

using chunk_sums = std::array<error_sums, kDomains.size()>;

error_sums& in(chunk_sums& sums, domain which) {
  return sums[static_cast<std::size_t>(which)];
}

/// A block of points at one n after another.
class block_meter {
 public:
  block_meter(const judged& of, const point_list& points, const edges& epicentres)
      : of_(of), points_(points), epicentres_(epicentres), model_(of.make()), in_(of.stimulus) {
    const auto exponents = static_cast<std::size_t>(of.last_n) - static_cast<std::size_t>(of.first_n) + 1;
    last_.resize(exponents);
    for (std::size_t channel = specular::kRed; channel <= specular::kBlue; ++channel)
      set_column(channel, kBlock, 0);
  }

  chunk_sums measure(std::size_t first, std::size_t last) {
    chunk_sums sums{};
    std::ranges::fill(last_, -std::numeric_limits<double>::infinity());
    if (first > 0) seed(first - 1);
    for (std::size_t begin = first; begin < last; begin += kBlock)
      measure_block(begin, std::min(kBlock, last - begin), sums);
    return sums;
  }

 private:
  template <class T>
  void set_column(std::size_t index, std::size_t size, T value) {
    in_[index].resize(size);
    in_[index].visit([&](auto& of) {
      std::ranges::fill(of, static_cast<typename std::decay_t<decltype(of)>::value_type>(value));
    });
  }

  void set_cosines(std::size_t begin, std::size_t size) {
    in_.resize(size);
    in_[specular::kCos].visit([&](auto& codes) {
      for (std::size_t i = 0; i < size; ++i)
        codes[i] = static_cast<typename std::decay_t<decltype(codes)>::value_type>(points_.code(begin + i));
    });
    cosines_.resize(size);
    for (std::size_t i = 0; i < size; ++i)
      cosines_[i] = points_.is_grid() ? std::ldexp(static_cast<double>(begin + i), -of_.cos_bits)
                                      : points_.cosines[begin + i];
  }

  /// The device's results at n for the cosines that are set, in ulp.
  void run(int n, std::size_t size) {
    set_column(specular::kN, size, n);
    model_->run(in_, out_);
    device_.resize(size);
    out_[specular::kBrdf].visit([&](const auto& brdf) {
      for (std::size_t i = 0; i < size; ++i) device_[i] = static_cast<double>(brdf[i]);
    });
  }

  /// The results before the chunk, for its first step.
  void seed(std::size_t index) {
    set_cosines(index, 1);
    for (std::size_t k = 0; k < last_.size(); ++k) {
      run(of_.first_n + static_cast<int>(k), 1);
      last_[k] = device_[0];
    }
  }

  void measure_block(std::size_t begin, std::size_t size, chunk_sums& sums) {
    set_cosines(begin, size);
    power_.assign(size, 1);
    rest_.assign(size, 0);
    for (int n = 1; n <= of_.last_n; ++n) {
      multiply(cosines_, power_, rest_);
      if (n >= of_.first_n) measure_at(n, size, sums);
    }
  }

  void measure_at(int n, std::size_t size, chunk_sums& sums) {
    const auto row = static_cast<std::size_t>(n - of_.first_n);
    run(n, size);
    const point_block block{n, of_.cos_bits, cosines_, power_, device_, last_[row]};
    last_[row] = device_.back();
    if (!points_.is_grid()) return add_points(block, 0, size, in(sums, points_.where));
    add_points(block, 0, size, in(sums, domain::whole));
    add_lit_points(block, in(sums, domain::lobe));
    for (std::size_t e = 0; e < edges::kCount; ++e) {
      const auto from = std::ranges::lower_bound(cosines_, epicentres_.of_n[row][e]) - cosines_.begin();
      add_points(block, static_cast<std::size_t>(from), size,
                 in(sums, static_cast<domain>(static_cast<std::size_t>(domain::epicentre) + e)));
    }
  }

  const judged& of_;
  const point_list& points_;
  const edges& epicentres_;
  std::unique_ptr<engine> model_;
  columns in_, out_;
  std::vector<double> cosines_, power_, rest_, device_;
  std::vector<double> last_;  // the device's result at the cosine before, for each n
};

/// The chunks of all point lists, measured by threads in any order and added up in theirs.
error_table add_up(const std::vector<chunk_sums>& chunks) {
  error_table table;
  for (std::size_t d = 0; d < kDomains.size(); ++d) {
    error_sums all;
    for (const chunk_sums& chunk : chunks) all += chunk[d];
    table[d] = all.result();
  }
  return table;
}

}  // namespace

domain find_domain(const std::string& name) {
  const auto found = std::ranges::find(kDomains, name, &named_domain::name);
  if (found != kDomains.end()) return found->which;
  std::string names;
  for (const named_domain& each : kDomains)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", each.name);
  throw std::invalid_argument(fmt::format("domain {} does not exist, expected {}", name, names));
}

bool is_judged(const selection& asked) {
  const std::optional<selection> other = asked.of().computes_as(asked);
  return dynamic_cast<const specular::device_of_points*>(other ? &other->of() : &asked.of()) != nullptr;
}

judged judge(const selection& asked) {
  if (!is_judged(asked)) {
    throw std::invalid_argument(fmt::format(
        "device {} has no BRDF of n and cos, expected one that shades points", asked.of().name()));
  }
  if (const std::optional<selection> other = asked.of().computes_as(asked)) return judge(*other);
  return {[asked] { return asked.of().make_bit(asked); },
          columns(asked.of().ports(asked), port::role::data).layout(), asked.fraction()};
}

namespace {

const specular::rounded_in_any_way* rounded_in_any_way(const device& of) {
  return dynamic_cast<const specular::rounded_in_any_way*>(&of);
}

/// \throws std::invalid_argument if the device has no model that rounds in any way
const specular::rounded_in_any_way& rounding_model(const device& of) {
  if (const specular::rounded_in_any_way* found = rounded_in_any_way(of)) return *found;
  std::string names;
  for (const device* each : devices()) {
    if (rounded_in_any_way(*each) != nullptr)
      names += fmt::format("{}{}", names.empty() ? "" : ", ", each->name());
  }
  throw std::invalid_argument(
      fmt::format("device {} rounds in one way, expected --rounding nearest or one of {}", of.name(), names));
}

}  // namespace

judged judge(const selection& asked, const word_lengths& bits, specular::rounding how) {
  judged of = judge(asked);
  of.make = [asked, bits] { return asked.of().make_bit(asked, bits); };
  if (how != specular::rounding::nearest) {
    const selection computed = asked.of().computes_as(asked).value_or(asked);
    of.make = [computed, bits, how] {
      return rounding_model(computed.of()).make_rounded(computed, bits, how);
    };
  }
  of.make();  // refuses word lengths here and not in a thread
  of.cos_bits = bits.at("cos");
  of.stimulus[specular::kCos] = storage::u32;
  return of;
}

namespace {

error_table measure_lists(const std::vector<point_list>& lists, const judged& of, int threads,
                          const std::function<void(double)>& advanced) {
  const edges epicentres(of.first_n, of.last_n);
  struct chunk {
    const point_list* points;
    std::size_t first, last;
  };
  std::vector<chunk> chunks;
  for (const point_list& points : lists) {
    for (std::size_t first = 0; first < points.size; first += kChunk)
      chunks.push_back({&points, first, std::min(points.size, first + kChunk)});
  }
  std::vector<chunk_sums> sums(chunks.size());
  std::size_t done = 0;
  std::mutex one_at_a_time;
  for_each_in_parallel(chunks.size(), static_cast<unsigned>(threads), [&](std::size_t i, unsigned) {
    sums[i] = block_meter(of, *chunks[i].points, epicentres).measure(chunks[i].first, chunks[i].last);
    const std::lock_guard lock(one_at_a_time);
    ++done;
    if (advanced) advanced(static_cast<double>(done) / static_cast<double>(chunks.size()));
  });
  return add_up(sums);
}

}  // namespace

error_table measure_errors(const judged& of, int threads, const std::function<void(double)>& advanced) {
  return measure_lists(
      {grid_of(of.cos_bits), pixels_of(domain::sphere, of.cos_bits), pixels_of(domain::teapot, of.cos_bits)},
      of, threads, advanced);
}

errors measure_on_pixels(const judged& of, domain where, int threads,
                         const std::function<void(double)>& advanced) {
  if (where != domain::sphere && where != domain::teapot)
    throw std::invalid_argument("a domain of codes was asked for, expected sphere or teapot");
  return measure_lists({pixels_of(where, of.cos_bits)}, of, threads,
                       advanced)[static_cast<std::size_t>(where)];
}

namespace {

double six_digits(double value) {
  return std::stod(fmt::format("{:.6g}", value));
}

}  // namespace

nlohmann::ordered_json json_of(const errors& of) {
  return {{"status", "exhaustive"},
          {"points", of.points},
          {"max_abs_err", six_digits(of.max_abs_err)},
          {"max_abs_n", of.max_abs_n},
          {"max_abs_cos", of.max_abs_cos},
          {"mean_abs_err", six_digits(of.mean_abs_err)},
          {"bias", six_digits(of.bias)},
          {"rms_err", six_digits(of.rms_err)},
          {"error_probability", six_digits(of.error_probability)},
          {"max_rel_err", six_digits(of.max_rel_err)},
          {"mean_rel_err", six_digits(of.mean_rel_err)},
          {"relative_points", of.relative_points},
          {"ulps", of.ulps},
          {"falls", of.falls},
          {"nmse", six_digits(of.nmse)},
          {"max_step", of.max_step}};
}

nlohmann::ordered_json json_of(const error_table& table) {
  nlohmann::ordered_json domains;
  for (const named_domain& each : kDomains)
    domains[std::string(each.name)] = json_of(table[static_cast<std::size_t>(each.which)]);
  return domains;
}

namespace {

/// \throws std::domain_error unless it is at least 0
double size_of(const nlohmann::ordered_json& of, const char* key) {
  const double value = of.at(key);
  if (!(value >= 0)) throw std::domain_error(fmt::format("{} is below zero", key));
  return value;
}

errors errors_of(const nlohmann::ordered_json& of) {
  if (of.at("status") != "exhaustive") throw std::domain_error("status is not exhaustive");
  const auto count = [&](const char* key) { return static_cast<std::uint64_t>(count_of(of, key)); };
  errors e;
  e.points = count("points");
  e.max_abs_err = size_of(of, "max_abs_err");
  e.max_abs_n = of.at("max_abs_n");
  e.max_abs_cos = of.at("max_abs_cos");
  e.mean_abs_err = size_of(of, "mean_abs_err");
  e.bias = of.at("bias");
  e.rms_err = size_of(of, "rms_err");
  e.error_probability = size_of(of, "error_probability");
  e.max_rel_err = size_of(of, "max_rel_err");
  e.mean_rel_err = size_of(of, "mean_rel_err");
  e.relative_points = count("relative_points");
  e.ulps = of.at("ulps");
  e.falls = count("falls");
  e.nmse = size_of(of, "nmse");
  e.max_step = static_cast<int>(count_of(of, "max_step"));
  if (e.points == 0 || std::accumulate(e.ulps.begin(), e.ulps.end(), std::uint64_t{0}) != e.points)
    throw std::domain_error("ulps do not add up to points");
  const auto expect = [](bool holds, const char* what) {
    if (!holds) throw std::domain_error(what);
  };
  constexpr double kStored = 1 + 1e-5;  // six digits
  expect(e.max_abs_n >= 1 && e.max_abs_n <= 1000, "max_abs_n is not in 1..1000");
  expect(e.max_abs_cos >= 0 && e.max_abs_cos <= 1, "max_abs_cos is not in [0, 1]");
  expect(e.error_probability <= 1, "error_probability is above 1");
  expect(std::abs(e.bias) <= e.mean_abs_err * kStored, "bias is larger than mean_abs_err");
  expect(e.mean_abs_err <= e.rms_err * kStored, "mean_abs_err is larger than rms_err");
  expect(e.rms_err <= e.max_abs_err * kStored, "rms_err is larger than max_abs_err");
  expect(e.mean_rel_err <= e.max_rel_err * kStored, "mean_rel_err is larger than max_rel_err");
  expect(e.relative_points <= e.points, "relative_points are more than points");
  return e;
}

}  // namespace

error_table parse_errors(const std::string& path, const nlohmann::ordered_json& domains) {
  return read_stored(path, "errors as blysk writes them", [&] {
    error_table table;
    for (const named_domain& each : kDomains) {
      const std::string name(each.name);
      // Rows may be older than this domain; it was not measured then.
      if (each.which == domain::teapot && domains.is_object() && !domains.contains(name)) continue;
      table[static_cast<std::size_t>(each.which)] = errors_of(domains.at(name));
    }
    return table;
  });
}

}  // namespace blysk::cost
