// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "tb/line_reader.h"
#include "tb/usage_error.h"

namespace blysk {

/// CSV with a header, read line by line in constant memory.
///
/// The header has to name the wanted columns, each once, in any order; other columns are passed over. It may follow lines
/// of comment and a first line "sep=;", and stand behind a `#` itself. Columns are separated as the header separates them: by commas,
/// semicolons, tabs or blanks. Fields may be quoted, "" being a quote. Empty fields beyond the header's are none.
/// Passed over are a byte order mark, blanks around fields, CR before LF, lines without a field that is not empty, and
/// lines that begin with #.
class csv_reader {
 public:
  /// \param path    "-" is standard input
  /// \param header  names of the wanted columns, separated by commas
  /// \throws usage_error if the file cannot be read or has no such header; lines end within 1 MiB
  csv_reader(const std::string& path, std::string_view header);

  /// Reads the next row; false at the end of the file.
  bool next();

  /// The same if the row is there without waiting for more input; false where it would have to wait, too.
  bool next_at_hand();

  /// Whether rows may be what the header of the wanted columns alone announces: these columns, separated by commas.
  bool is_plain() const { return is_plain_; }

  /// The row's text without the line's end, valid until the next row is read.
  std::string_view text() const { return lines_.text(); }

  /// The fields of the wanted columns, in their order, valid until the next row is read.
  /// \throws usage_error if the row has more or fewer fields than the header
  const std::vector<std::string_view>& fields();

  /// The error of a wanted column of the row, after fields(): "NAME is 'FIELD', expected ...".
  usage_error error(std::size_t column, std::string_view expected) const;

  /// The error of the row as a whole.
  usage_error error(std::string_view what) const;

  /// Bytes read so far, and those of the whole file; 0 if it is no regular file.
  std::size_t bytes_read() const { return lines_.bytes_read(); }
  std::size_t file_size() const { return lines_.file_size(); }

 private:
  void read_header(std::string_view header);
  bool find_columns(std::string_view line);
  std::string repeated_name(std::string_view line);
  bool next_row(bool may_wait);
  bool split(std::string_view line, char separator, std::vector<std::string_view>& fields);

  line_reader lines_;
  std::vector<std::string> names_;      // of the wanted columns
  std::vector<std::string> all_names_;  // of the file's
  std::vector<std::size_t> places_;     // of the wanted columns among the file's
  char separator_ = ',';
  bool is_plain_ = false;
  std::deque<std::string> unescaped_;  // fields with quotes in them
  std::vector<std::string_view> all_fields_;
  std::vector<std::string_view> fields_;  // of the wanted columns; empty until they are asked for
};

}  // namespace blysk
