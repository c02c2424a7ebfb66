// SPDX-License-Identifier: Apache-2.0
/// The CSV rows of `simulate`: writes of the device, and writes with their results.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

#include "tb/csv_reader.h"
#include "tb/engine.h"

namespace blysk::cli {

inline constexpr std::string_view kStimulusHeader = "n,cos,r,g,b";
inline constexpr std::string_view kResultsHeader = "n,cos,r,g,b,brdf,red,green,blue";
inline constexpr std::size_t kRowsPerBlock = 8192;

/// Writes and what was computed from them.
struct row_block {
  batch writes;
  std::variant<results, std::vector<double>> computed;  ///< by the hardware; by a formula: the BRDF

  /// Where to compute a Computed to; what it holds from another block keeps its memory.
  template <class Computed>
  Computed& compute_as() {
    auto* const held = std::get_if<Computed>(&computed);
    return held != nullptr ? *held : computed.emplace<Computed>();
  }
};

/// Reads up to kRowsPerBlock rows, cosines rounded to `fraction` bits, ties up; an empty batch at the end of the file.
/// \throws usage_error if a field is no number or outside its range
void read_block(csv_reader& rows, int fraction, batch& block);

/// Appends a row for each write with its results. Those of the hardware have `fraction` fraction bits and are exact,
/// without trailing zeros; those of a formula are BRDF and BRDF times colour, as short as they can be read back.
/// \param fraction  0..24
void append_rows(fmt::memory_buffer& text, const row_block& block, int fraction);

}  // namespace blysk::cli
