// SPDX-License-Identifier: Apache-2.0
#include "tb/render/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

namespace blysk::render {
namespace {

struct glyph {
  char character;
  std::uint16_t rows;  // five of three bits, an octal digit each, from the top
};

// clang-format off
constexpr std::array kGlyphs{std::to_array<glyph>({
    {'A', 025755}, {'B', 065656}, {'C', 034443}, {'D', 065556}, {'E', 074647}, {'F', 074644}, {'G', 034553},
    {'H', 055755}, {'I', 072227}, {'J', 011152}, {'K', 055655}, {'L', 044447}, {'M', 057755}, {'N', 065555},
    {'O', 025552}, {'P', 065644}, {'Q', 025563}, {'R', 065655}, {'S', 034216}, {'T', 072222}, {'U', 055557},
    {'V', 055552}, {'W', 055775}, {'X', 055255}, {'Y', 055222}, {'Z', 071247}, {'0', 075557}, {'1', 026227},
    {'2', 061247}, {'3', 061216}, {'4', 055711}, {'5', 074616}, {'6', 034757}, {'7', 071222}, {'8', 075757},
    {'9', 075716}, {'.', 000002}, {',', 000024}, {'-', 000700}, {'+', 002720}, {'=', 007070}, {'/', 011244},
    {':', 002020}, {'%', 051245}, {'(', 012221}, {')', 042224}, {'\'', 022000}, {'_', 000007},
})};
// clang-format on

constexpr int kScale = 2;
constexpr int kAdvance = 4 * kScale;

void write_glyph(picture& on, int x, int y, std::uint16_t rows) {
  for (int row = 0; row < 5 * kScale; ++row) {
    for (int column = 0; column < 3 * kScale; ++column) {
      const int bit = 3 * (4 - row / kScale) + 2 - column / kScale;
      const bool is_inside = x + column >= 0 && x + column < on.width && y + row >= 0 && y + row < on.height;
      if (is_inside && ((rows >> bit) & 1) != 0)
        std::fill_n(on.pixel(x + column, y + row), 3, std::uint8_t{255});
    }
  }
}

}  // namespace

void write_text(picture& on, int x, int y, std::string_view text) {
  for (const char each : text) {
    const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(each)));
    const auto found = std::ranges::find(kGlyphs, capital, &glyph::character);
    if (found != kGlyphs.end()) write_glyph(on, x, y, found->rows);
    x += kAdvance;
  }
}

int text_width(std::string_view text) {
  return kAdvance * static_cast<int>(text.size());
}

}  // namespace blysk::render
