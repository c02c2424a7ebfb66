// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tb/usage_error.h"

namespace blysk {

/// The lines of a text file, read in constant memory. A byte order mark and CR before LF are left out.
class line_reader {
 public:
  /// \param path  "-" is standard input
  /// \param what  the file should be, for messages: "a CSV file"
  /// \throws usage_error if the file cannot be read
  line_reader(const std::string& path, std::string_view what);
  ~line_reader();
  line_reader(const line_reader&) = delete;
  line_reader& operator=(const line_reader&) = delete;

  /// Reads the next line; false at the end of the file.
  /// \param may_wait  if not, false too where more input has to be waited for
  /// \throws usage_error if the file cannot be read, or the line is longer than 1 MiB
  bool next(bool may_wait = true);

  /// The next next() gives the same line again.
  void put_back();

  /// The line, valid until the next one is read; and its number from 1 on, 0 before the first.
  std::string_view text() const { return text_; }
  std::size_t number() const { return number_; }

  /// Whether a line feed ends the line; the last one of a file may have none.
  bool has_end() const { return has_end_; }

  /// The error of the line.
  usage_error error(std::string_view what) const { return file_error(path_, number_, what); }

  /// As messages name the file.
  const std::string& path() const { return path_; }

  /// Bytes read so far, and those of the whole file; 0 if it is no regular file.
  std::size_t bytes_read() const { return bytes_read_; }
  std::size_t file_size() const;

 private:
  class descriptor;

  bool fill(bool may_wait);

  std::string path_;
  std::string what_;
  std::unique_ptr<descriptor> file_;
  std::vector<char> buffer_;
  std::size_t line_ = 0, begin_ = 0, end_ = 0;  // the line, what follows it, and the end of what was read
  bool is_ended_ = false;
  bool has_end_ = true;
  std::size_t bytes_read_ = 0;
  std::string_view text_;
  std::size_t number_ = 0;
};

/// The text as a message can hold it: printable, cut after 40 bytes, between two characters of UTF-8.
std::string shown(std::string_view text);

}  // namespace blysk
