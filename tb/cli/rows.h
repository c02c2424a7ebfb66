// SPDX-License-Identifier: Apache-2.0
/// The CSV rows of `simulate`: stimuli of a device, and stimuli with their results. Columns, ranges and fraction bits are
/// those of its ports.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <memory>
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

  /// Of a device that draws scan lines: how many pixels each line has, and the number of the first line.
  std::vector<std::int64_t> pixels;
  std::uint64_t first_line = 0;
};

/// What the rows of the results are.
enum class row_kind {
  writes,  ///< a row for each of the stimulus, which it repeats
  pixels   ///< a row for each pixel of a scan line, with the line's number and its own, from 0
};

/// "n,cos,r,g,b".
std::string stimulus_header(const std::vector<port>& ports);

/// "n,cos,r,g,b,brdf,red,green,blue", or "line,pixel,red,green,blue".
std::string results_header(const std::vector<port>& ports, row_kind kind);

/// Reads the stimuli of a device in blocks.
class stimulus_reader {
 public:
  /// \param rows    a file with the device's stimulus columns; outlives this
  /// \param clamps  real numbers not more than kClampReach outside the range of their port become its end
  stimulus_reader(csv_reader& rows, std::vector<port> ports, bool clamps = false);
  ~stimulus_reader();
  stimulus_reader(const stimulus_reader&) = delete;
  stimulus_reader& operator=(const stimulus_reader&) = delete;

  /// Reads up to kRowsPerBlock rows, fewer where the next would have to be waited for; no rows at the end of the file.
  /// A port without fraction bits takes integers, another one real numbers, which are rounded to its fraction bits, ties
  /// up.
  /// \throws usage_error if a field is no number or outside the legal range of its port
  void read(columns& block);

  const std::vector<port>& ports() const { return ports_; }

  /// How many numbers were outside and became an end of their range.
  std::uint64_t clamped() const;

 private:
  class row_parser;

  csv_reader& rows_;
  std::vector<port> ports_;
  std::unique_ptr<row_parser> parser_;
};

/// Appends the rows of a block. Raw integers are exact, without trailing zeros; real ones are as short as they can be read
/// back.
void append_rows(fmt::memory_buffer& text, const std::vector<port>& ports, const row_block& block,
                 row_kind kind = row_kind::writes);

}  // namespace blysk::cli
