// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tb/usage_error.h"

namespace blysk {

/// CSV with a fixed header, read line by line in constant memory. A byte order mark, CRLF, blanks around fields and
/// empty lines are tolerated; there is no quoting.
class csv_reader {
 public:
  /// \param path    "-" is standard input
  /// \param header  column names, separated by commas
  /// \throws usage_error if the file cannot be read or its first line is not that header; lines end within 1 MiB
  csv_reader(const std::string& path, std::string_view header);

  /// Reads the next row; false at the end of the file.
  bool next();

  /// The row's text without the line's end, valid until the next call of next(). The kSlack bytes behind it can be
  /// read, whatever they are.
  std::string_view text() const { return text_; }
  static constexpr std::size_t kSlack = 8;

  /// The fields of the row, valid until the next call of next().
  /// \throws usage_error if the row has more or fewer fields than the header
  const std::vector<std::string_view>& fields();

  /// The error of that column of the row, after fields(): "NAME is 'FIELD', expected ...".
  usage_error error(std::size_t column, std::string_view expected) const;

  /// The error of the row as a whole.
  usage_error error(std::string_view what) const;

 private:
  struct close_stream {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  bool read_line();
  void set_text_to_line();
  void split();

  std::string path_;
  std::vector<std::string> names_;
  std::unique_ptr<std::FILE, close_stream> file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  std::string line_;  // a line that does not lie whole in the buffer
  std::string_view text_;
  std::vector<std::string_view> fields_;  // empty until they are asked for
  std::size_t line_number_ = 0;
};

}  // namespace blysk
