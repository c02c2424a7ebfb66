// SPDX-License-Identifier: Apache-2.0
/// Vectors for somebody else's hardware, as text: one write a line, raw hexadecimal codes separated by blanks. What
/// `blysk vectors` prints and `blysk check` reads.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tb/columns.h"
#include "tb/device.h"
#include "tb/line_reader.h"

namespace blysk::cli {

/// The ports that a vector has codes of: data, then the results that leave the device.
std::vector<port> inputs_of(const std::vector<port>& ports);
std::vector<port> outputs_of(const std::vector<port>& ports);

/// What the first line says of the vectors.
struct vector_header {
  std::string device;       ///< "--device NAME --format q12"
  std::uint64_t count = 0;  ///< how many vectors there are
  std::string columns;      ///< "n cos r g b"
};

/// "# blysk vectors --device NAME --format q12; 5 vectors of n cos r g b", without the line's end.
std::string header_text(const selection& asked, std::uint64_t count);

/// The header that a line is; nothing if it is none.
std::optional<vector_header> parse_header(std::string_view line);

/// Appends a line for each row: the codes of the inputs, with as many digits as their wires need.
void append_vectors(fmt::memory_buffer& text, const std::vector<port>& inputs, const columns& rows);

/// Inputs and outputs of some hardware, and the lines that they come from.
struct answers {
  columns in;                                  ///< a row for each vector
  std::vector<std::vector<std::int64_t>> out;  ///< for each output its codes, one for each line
  std::vector<std::size_t> lines;              ///< where they stand
  std::vector<std::size_t> vectors;            ///< for each line its row of `in`
};

/// Reads what hardware answered to vectors.
class answer_reader {
 public:
  /// \param lines  outlives this
  answer_reader(line_reader& lines, const selection& asked);

  /// Reads up to `most` lines, and those that follow of the last vector; none at the end. A vector has a line, or one for
  /// each pixel if the device draws scan lines.
  /// \throws usage_error for vectors of another device, a line that is cut or too long, an input that is not legal, digits
  ///         that are none, X and Z among them, and vectors without an answer, or with pixels missing
  void read(answers& block, std::size_t most);

  /// Vectors so far.
  std::uint64_t count() const { return count_; }

 private:
  void read_header();
  void check_end() const;
  void parse(answers& block);
  std::size_t vector_of_line(answers& block, const std::vector<std::int64_t>& codes);
  std::int64_t parse_code(const port& of, std::string_view digits) const;

  line_reader& lines_;
  std::string device_;
  std::vector<port> in_, out_;
  std::optional<vector_header> header_;
  std::uint64_t count_ = 0;
  const device& of_;
  std::int64_t missing_ = 0;  // pixels of the vector that was begun
};

}  // namespace blysk::cli
