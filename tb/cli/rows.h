// SPDX-License-Identifier: Apache-2.0
/// The CSV rows of `simulate`: writes of the device, and writes with their results.
#pragma once

#include <fmt/format.h>

#include "tb/engine.h"
#include "tb/files.h"

namespace blysk::cli {

inline constexpr std::string_view kStimulusHeader = "n,cos,r,g,b";
inline constexpr std::string_view kResultsHeader = "n,cos,r,g,b,brdf,red,green,blue";
inline constexpr std::size_t kRowsPerBlock = 8192;

/// Reads up to kRowsPerBlock rows, cosines rounded to `fraction` bits, ties up; an empty batch at the end of the file.
/// \throws usage_error if a field is no number or outside its range
void read_block(csv_reader& rows, int fraction, batch& block);

/// Appends row i: the write and its results, all of them with `fraction` fraction bits, exact, without trailing zeros.
/// \param fraction  0..24
void append_row(fmt::memory_buffer& text, const batch& block, const results& raw, std::size_t i,
                int fraction);

/// Appends row i of the formula's results, reals.
void append_row(fmt::memory_buffer& text, const batch& block, double brdf, std::size_t i, int fraction);

}  // namespace blysk::cli
