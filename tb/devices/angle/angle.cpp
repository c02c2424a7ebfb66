// SPDX-License-Identifier: Apache-2.0
// UA 71489 as its user meets it: options, formula, bit-accurate model.
#include "tb/golden/angle.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "tb/device.h"
#include "tb/devices/angle/contents.h"
#include "tb/devices/angle/kinds.h"
#include "tb/devices/word_lengths.h"
#include "tb/visit_format.h"

namespace blysk::angle_device {
namespace {

enum column : std::size_t { kN, kIntensity, kStart, kStep, kCount };
enum result : std::size_t { kAngle, kBrdf, kOut };

/// Fraction bits, those of the stimulus aside.
struct widths_of_model {
  int angle;    ///< of the stimulus and register 4
  int address;  ///< of a part of ROM 1
  int limited;  ///< of the angle at multiplier 2
  int factor;   ///< of the words of ROM 2
  int brdf;     ///< of the words of ROM 1, and of the reflectance
  int energy;   ///< of the factors of the lobe, where there are any
};

/// Calls use(row, first pixel, pixels) for each line, after `out` has room for all pixels.
template <class Use>
void for_lines(const columns& in, columns& out, Use use) {
  std::size_t pixels = 0;
  for (std::size_t row = 0; row < in.size(); ++row) pixels += static_cast<std::size_t>(in[kCount].get(row));
  out.resize(pixels);
  std::size_t first = 0;
  for (std::size_t row = 0; row < in.size(); ++row) {
    const auto count = static_cast<std::size_t>(in[kCount].get(row));
    use(row, first, count);
    first += count;
  }
}

/// The blocks' laws in the order of the clock edges.
class bit_engine final : public engine {
 public:
  bit_engine(const widths_of_model& bits, const selection& asked, std::vector<storage> results)
      : bit_engine(bits, level_of(asked), powers_of(asked), energy_of(asked), std::move(results)) {}

 private:
  bit_engine(const widths_of_model& bits, std::uint64_t level, int powers, std::optional<angle_energy> energy,
             std::vector<storage> results)
      : engine(std::move(results)),
        bits_(bits),
        powers_(powers),
        factors_(static_cast<std::size_t>(exponent::max) + 1),
        words_(static_cast<std::size_t>(powers) << bits.address) {
    fill_factors(factors_, level, static_cast<std::uint64_t>(powers), bits.factor);
    fill_powers(words_, static_cast<std::uint64_t>(powers), bits.address, bits.brdf);
    if (energy) {
      energies_.resize(factors_.size());
      fill_energy(energies_, *energy, level, static_cast<std::uint64_t>(powers), bits.energy);
    }
  }

  // A vector holds what the blocks' arrays hold.
  static std::int64_t lookup(const std::vector<std::int64_t>& words, std::int64_t index) {
    return static_cast<std::size_t>(index) < words.size() ? words[static_cast<std::size_t>(index)] : 0;
  }

  void compute(const columns& in, columns& out) override {
    for_lines(in, out, [&](std::size_t row, std::size_t first, std::size_t pixels) {
      const std::int64_t n = in[kN].get(row);
      const std::int64_t intensity = in[kIntensity].get(row);
      const std::int64_t step = in[kStep].get(row);
      const std::int64_t factor = lookup(factors_, n);
      const auto part = part_decoder<exponent, uq<4, 0>>::law<std::int64_t>(n, powers_);
      std::int64_t angle = in[kStart].get(row);
      for (std::size_t pixel = first; pixel < first + pixels; ++pixel) {
        std::int64_t brdf = reflectance(angle, factor, part);
        if (!energies_.empty()) brdf = law::mul<std::int64_t>(brdf, lookup(energies_, n), bits_.energy);
        out[kAngle].set(pixel, angle);
        out[kBrdf].set(pixel, brdf);
        out[kOut].set(pixel, law::mul<std::int64_t>(brdf, intensity, 0));
        angle = law::add<std::int64_t>(angle, 0, step, 0, 0);
      }
    });
  }

  std::int64_t reflectance(std::int64_t angle, std::int64_t factor, std::int64_t part) const {
    const std::int64_t most = (std::int64_t{1} << (bits_.limited + 1)) - 1;
    const std::int64_t one = std::int64_t{1} << bits_.address;
    const auto limited =
        law::smaller<std::int64_t>(law::round_off(law::magnitude(angle), bits_.angle - bits_.limited), most);
    const auto turned = law::mul<std::int64_t>(limited, factor, 0);
    const auto place =
        law::smaller<std::int64_t>(law::round_off(turned, bits_.limited + bits_.factor - bits_.address), one);
    return law::select<std::int64_t>(place < one, lookup(words_, (part << bits_.address) + place), 0);
  }

  widths_of_model bits_;
  int powers_;
  std::vector<std::int64_t> factors_, words_;
  std::vector<std::int64_t> energies_;  // empty without a factor of the lobe
};

/// The factor of the lobe.
double energy_at(std::optional<angle_energy> which, double n, double k, double level) {
  if (!which) return 1;
  if (*which == angle_energy::safe) return golden::angle_coefficient_safe(n, k, level);
  if (*which == angle_energy::published && n > k) return golden::angle_coefficient_fitted(n, k, level);
  return golden::angle_coefficient_exact(n, k, level);
}

/// cos^k(factor |start + i step|), times the factor of the lobe.
class formula_engine final : public engine {
 public:
  formula_engine(int angle_bits, const selection& asked)
      : engine({storage::f64, storage::f64, storage::f64}),
        angle_bits_(angle_bits),
        level_(static_cast<double>(level_of(asked)) / kMillion),
        powers_(powers_of(asked)),
        energy_(energy_of(asked)) {}

 private:
  void compute(const columns& in, columns& out) override {
    for_lines(in, out, [&](std::size_t row, std::size_t first, std::size_t pixels) {
      const double n = in[kN].real(row);
      const double k = std::min<double>(powers_, n);
      const double scale = golden::angle_scale(n, k, level_);
      const double energy = energy_at(energy_, n, k, level_);
      const double intensity = in[kIntensity].real(row);
      const double start = std::ldexp(in[kStart].real(row), -angle_bits_);
      const double step = std::ldexp(in[kStep].real(row), -angle_bits_);
      for (std::size_t i = 0; i < pixels; ++i) {
        const double angle = start + static_cast<double>(i) * step;
        const double brdf = energy * golden::angle_lobe_scaled(k, scale * std::abs(angle));
        out[kAngle].set(first + i, angle);
        out[kBrdf].set(first + i, brdf);
        out[kOut].set(first + i, brdf * intensity);
      }
    });
  }

  int angle_bits_;
  double level_;
  int powers_;
  std::optional<angle_energy> energy_;
};

class angle_device_of final : public device {
 public:
  std::string name() const override { return "angle"; }
  std::string title() const override {
    return "cos^k of a multiple of the angle, along a scan line of angles";
  }
  std::string source() const override { return "patent UA 71489, article of Zavalniuk"; }
  std::string figure() const override { return "as UA 60553 describes it"; }
  std::string good_for() const override {
    return "a pixel a clock where the angle is known; it takes an arc cosine where only the cosine is";
  }

  std::vector<option> options() const override {
    return {
        {.name = "q",
         .help = "Q of the article, at which the lobe meets cos^n: above 0 and below 1, at most six decimals",
         .preset = "0.5"},
        {.name = "k", .help = "power of the cosine for n > k, 1..15", .preset = "5"},
        {.name = "energy",
         .help = "factor of the lobe: 1 (none), the article's fit (published), its 1/(2 pi Int) (exact), one "
                 "that "
                 "keeps the reflectance at or below 1 at every incidence (safe)",
         .values = {"none", "published", "exact", "safe"},
         .preset = "none"}};
  }

  void check(const selection& asked) const override {
    level_of(asked);
    powers_of(asked);
    energy_of(asked);
  }

  /// A number is one however it is written.
  std::map<std::string, std::string> canonical(const selection& asked) const override {
    std::map<std::string, std::string> values = asked.values();
    std::string& level = values["q"];
    level = fmt::format("0.{:06}", level_of(asked));
    level.erase(level.find_last_not_of('0') + 1);
    values["k"] = fmt::format("{}", powers_of(asked));
    return values;
  }

  std::string words(const selection& asked) const override {
    return fmt::format("Q {}, k {}{}", asked.value("q"), asked.value("k"),
                       energy_of(asked) ? fmt::format(", energy factor {}", asked.value("energy")) : "");
  }

  bool draws_lines() const override { return true; }
  std::int64_t pixels(const columns& in, std::size_t row) const override { return in[kCount].get(row); }

  std::unique_ptr<engine> make_bit(const selection& asked) const override {
    return visit_format(asked.format(), [&]<class Q>() {
      return with_formats<Q>(asked, [&]<class Formats>() -> std::unique_ptr<engine> {
        std::vector<storage> results{storage_of(Formats::angle::width, Formats::angle::is_signed),
                                     storage_of(Formats::brdf::width, Formats::brdf::is_signed),
                                     storage_of(Formats::out::width, Formats::out::is_signed)};
        return std::make_unique<bit_engine>(bits_of(asked), asked, std::move(results));
      });
    });
  }

  std::int64_t rom_bits(const selection& asked) const override {
    const widths_of_model bits = bits_of(asked);
    return (std::int64_t{powers_of(asked)} << bits.address) * (bits.brdf + 1) +
           exponent::max * (5 + std::int64_t{bits.factor} + (energy_of(asked) ? 9 + bits.energy : 0));
  }

  word_lengths widths(const selection& asked) const override {
    const widths_of_model bits = bits_of(asked);
    word_lengths named{
        {"address", bits.address}, {"limited", bits.limited}, {"factor", bits.factor}, {"brdf", bits.brdf}};
    if (energy_of(asked)) named["energy"] = bits.energy;
    return named;
  }

  /// The stimulus keeps the fraction bits of its format.
  std::unique_ptr<engine> make_bit(const selection& asked, const word_lengths& bits) const override {
    widths_of_model chosen = bits_of(asked);
    std::vector<known_width> known{{"address", &chosen.address, 1, 16},
                                   {"limited", &chosen.limited, 1, chosen.angle},
                                   {"factor", &chosen.factor, 1, 30},
                                   {"brdf", &chosen.brdf, 1, 30}};
    if (energy_of(asked)) known.push_back({"energy", &chosen.energy, 1, 20});
    take_widths(bits, known);
    if (chosen.limited + chosen.factor > 57 || chosen.limited + chosen.factor < chosen.address) {
      throw std::invalid_argument(
          fmt::format("word lengths limited {} and factor {} do not go together, expected {}..57 in sum",
                      chosen.limited, chosen.factor, chosen.address));
    }
    return std::make_unique<bit_engine>(chosen, asked, std::vector<storage>(3, storage::i64));
  }

  std::unique_ptr<engine> make_golden(const selection& asked) const override {
    return std::make_unique<formula_engine>(bits_of(asked).angle, asked);
  }

  std::size_t enumerated() const override { return 1; }

  /// Where the parts of ROM 1 end.
  std::vector<std::int64_t> corners(const selection& asked, std::span<const std::int64_t>) const override {
    return {powers_of(asked)};
  }

 private:
  static widths_of_model bits_of(const selection& asked) {
    return visit_format(asked.format(), []<class Q>() {
      using formats = angle_formats<Q>;
      return widths_of_model{
          formats::angle_bits, formats::address_bits, formats::limited_bits, formats::factor_bits, Q::frac,
          formats::energy_bits};
    });
  }
};

}  // namespace

std::uint64_t level_of(const selection& asked) {
  const std::string& text = asked.value("q");
  const auto refuse = [&] {
    return std::invalid_argument(fmt::format(
        "--q is {}, expected a decimal number above 0 and below 1 with at most six decimals", text));
  };
  const std::size_t point = text.find('.');
  if (point == std::string::npos || text.substr(0, point).find_first_not_of('0') != std::string::npos)
    throw refuse();
  std::string decimals = text.substr(point + 1);
  if (decimals.empty() || decimals.size() > 6 ||
      decimals.find_first_not_of("0123456789") != std::string::npos) {
    throw refuse();
  }
  decimals.resize(6, '0');
  std::uint64_t level = 0;
  std::from_chars(decimals.data(), decimals.data() + decimals.size(), level);
  if (level == 0) throw refuse();
  return level;
}

int powers_of(const selection& asked) {
  const std::string& text = asked.value("k");
  int powers = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), powers);
  if (error != std::errc{} || end != text.data() + text.size() || powers < 1 || powers > kMostPowers) {
    throw std::invalid_argument(fmt::format("--k is {}, expected an integer 1..{}", text, kMostPowers));
  }
  return powers;
}

std::optional<angle_energy> energy_of(const selection& asked) {
  const std::string& text = asked.value("energy");
  if (text == "none") return std::nullopt;
  if (text == "exact") return angle_energy::exact;
  if (text == "safe") return angle_energy::safe;
  if (!is_fitted(level_of(asked), static_cast<std::uint64_t>(powers_of(asked)))) {
    throw std::invalid_argument(
        fmt::format("--energy published holds for --q in [0.1, 0.4] or [0.5, 0.9] and --k in 1..5, expected "
                    "these, not --q {} --k {}, or --energy exact",
                    asked.value("q"), asked.value("k")));
  }
  return angle_energy::published;
}

const device& instance() {
  static const angle_device_of device;
  return device;
}

}  // namespace blysk::angle_device
