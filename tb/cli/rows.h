// SPDX-License-Identifier: Apache-2.0
/// The CSV rows of `simulate`: stimuli of a device, and stimuli with their results. Columns, ranges and fraction bits are
/// those of its ports.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

#include "tb/columns.h"
#include "tb/csv_reader.h"

namespace blysk::cli {

inline constexpr std::size_t kRowsPerBlock = 8192;

/// Stimuli and what was computed from them.
struct row_block {
  columns writes;
  columns computed;
};

/// "n,cos,r,g,b" and "n,cos,r,g,b,brdf,red,green,blue".
std::string stimulus_header(const std::vector<port>& ports);
std::string results_header(const std::vector<port>& ports);

/// Reads up to kRowsPerBlock rows; no rows at the end of the file. A port without fraction bits takes integers, another
/// one real numbers, which are rounded to its fraction bits, ties up.
/// \throws usage_error if a field is no number or outside the legal range of its port
void read_block(csv_reader& rows, const std::vector<port>& ports, columns& block);

/// Appends a row for each stimulus with its results. Raw integers are exact, without trailing zeros; real ones are as short
/// as they can be read back.
void append_rows(fmt::memory_buffer& text, const std::vector<port>& ports, const row_block& block);

}  // namespace blysk::cli
