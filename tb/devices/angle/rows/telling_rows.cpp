// SPDX-License-Identifier: Apache-2.0
// telling_rows DEVICE FORMAT FILE: rows of `angle` in which a wrong bit of a word of either memory changes a pixel, as raw
// codes in CSV. For ROM 1 lines that go slowly through the lobe of each part and meet every place; for ROM 2 lines of one
// pixel, for each exponent and each bit of its word an angle at which the word with the bit inverted gives another
// reflectance. One more line runs as far from the axis as a line can. Exit 1 if a place of ROM 1 is not met.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/devices/angle/contents.h"
#include "tb/devices/angle/contents.h"
#include "tb/output_file.h"
#include "tb/program.h"

namespace blysk {
namespace {

constexpr std::int64_t kMostExponent = 1000;
constexpr std::int64_t kMostPixels = 1023;

/// The two memories, and the way from an angle to a place of ROM 1.
class memories {
 public:
  explicit memories(const selection& asked)
      : powers_(angle_device::powers_of(asked)),
        ports_(of_role(asked.of().ports(asked), port::role::data)),
        factors_(kMostExponent + 1) {
    const word_lengths bits = asked.of().widths(asked);
    angle_bits_ = ports_[kStart].carries->frac;
    address_bits_ = bits.at("address");
    limited_bits_ = bits.at("limited");
    factor_bits_ = bits.at("factor");
    words_.resize(static_cast<std::size_t>(powers_) << address_bits_);
    fill_factors(factors_, angle_device::level_of(asked), static_cast<std::uint64_t>(powers_), factor_bits_);
    fill_powers(words_, static_cast<std::uint64_t>(powers_), address_bits_, bits.at("brdf"));
  }

  enum column : std::size_t { kN, kIntensity, kStart, kStep, kCount };
  using row = std::array<std::int64_t, 5>;

  std::int64_t most(column of) const { return ports_[of].carries->max; }
  int powers() const { return powers_; }
  int factor_width() const { return factor_bits_ + 5; }
  std::int64_t places() const { return std::int64_t{1} << address_bits_; }
  std::int64_t factor(std::int64_t n) const { return factors_[static_cast<std::size_t>(n)]; }

  /// Angles of neighbouring codes at multiplier 2 lie so many codes of register 4 apart.
  std::int64_t pitch() const { return std::int64_t{1} << (angle_bits_ - limited_bits_); }

  /// The place of ROM 1 for an angle's code; places() beyond the lobe.
  std::int64_t place(std::int64_t angle, std::int64_t factor) const {
    const auto limited = law::round_off<std::int64_t>(angle, angle_bits_ - limited_bits_);
    return std::min(
        law::round_off<std::int64_t>(limited * factor, limited_bits_ + factor_bits_ - address_bits_),
        places());
  }

  std::int64_t reflectance(std::int64_t n, std::int64_t place) const {
    const std::int64_t part = n < powers_ ? n : 0;
    return place < places() ? words_[static_cast<std::size_t>((part << address_bits_) + place)] : 0;
  }

 private:
  int powers_;
  std::vector<port> ports_;
  std::vector<std::int64_t> factors_, words_;
  int angle_bits_ = 0, address_bits_ = 0, limited_bits_ = 0, factor_bits_ = 0;
};

/// Lines through the lobe of each part, from the axis to the largest start angle, which meet all its places.
void add_slow_lines(const memories& of, std::vector<memories::row>& rows) {
  const std::int64_t lines = (2 * of.places() + kMostPixels - 1) / kMostPixels;
  const std::int64_t step = of.most(memories::kStart) / (lines * kMostPixels) + 1;
  for (std::int64_t n = 1; n <= of.powers(); ++n) {
    std::vector<bool> is_met(static_cast<std::size_t>(of.places()) + 1, false);
    for (std::int64_t line = 0; line < lines; ++line) {
      const std::int64_t start = line * kMostPixels * step;
      rows.push_back({n, of.most(memories::kIntensity), start, step, kMostPixels});
      for (std::int64_t pixel = 0; pixel < kMostPixels; ++pixel)
        is_met[static_cast<std::size_t>(of.place(start + pixel * step, of.factor(n)))] = true;
    }
    const auto missed = std::ranges::find(is_met, false);
    if (missed != is_met.end()) {
      throw std::runtime_error(fmt::format("no pixel of n = {} is at place {} of ROM 1, expected one at each",
                                           n, missed - is_met.begin()));
    }
  }
}

/// Lines of one pixel, for the word of one exponent.
/// \return  bits of the word that no angle tells
int add_pixels_of(const memories& of, std::int64_t n, std::vector<memories::row>& rows) {
  const std::int64_t word = of.factor(n);
  const auto tells = [&](std::int64_t angle, int bit) {
    return of.reflectance(n, of.place(angle, word)) !=
           of.reflectance(n, of.place(angle, word ^ (std::int64_t{1} << bit)));
  };
  std::vector<std::int64_t> angles;
  int untold = 0;
  for (int bit = 0; bit < of.factor_width(); ++bit) {
    if (std::ranges::any_of(angles, [&](std::int64_t angle) { return tells(angle, bit); })) continue;
    // A wrong last place moves the place most where the angle is large.
    std::int64_t angle = of.most(memories::kStart) / of.pitch() * of.pitch();
    while (angle >= 0 && !tells(angle, bit)) angle -= of.pitch();
    if (angle < 0) {
      ++untold;
      continue;
    }
    angles.push_back(angle);
  }
  for (const std::int64_t angle : angles) rows.push_back({n, of.most(memories::kIntensity), angle, 0, 1});
  return untold;
}

int write_rows(const selection& asked, const std::string& path) {
  const memories of(asked);
  std::vector<memories::row> rows;
  add_slow_lines(of, rows);
  rows.push_back(
      {1, of.most(memories::kIntensity), of.most(memories::kStart), of.most(memories::kStep), kMostPixels});
  int untold = 0;
  for (std::int64_t n = 1; n <= kMostExponent; ++n) untold += add_pixels_of(of, n, rows);

  output_file file(path);
  std::string text = column_names(asked.of().ports(asked), port::role::data) + "\n";
  for (const memories::row& each : rows)
    text += fmt::format("{},{},{},{},{}\n", each[0], each[1], each[2], each[3], each[4]);
  file.write(text);
  file.close();
  file.commit();
  fmt::print("{} rows; {} of {} bits of ROM 2 change no reflectance at any angle\n", rows.size(), untold,
             kMostExponent * of.factor_width());
  return 0;
}

}  // namespace
}  // namespace blysk

int main(int argc, char** argv) {
  blysk::device_arguments arguments;
  std::string path;
  return blysk::run_program(
      argc, argv, "Writes rows of angle that show wrong bits of its memories",
      [&](CLI::App& program) {
        arguments.add_to(program);
        program.add_option("FILE", path, "rows, raw codes in CSV")->required();
      },
      [&] { return blysk::write_rows(arguments.chosen(), path); });
}
