// SPDX-License-Identifier: Apache-2.0
/// Input and output files of the programs: what is wrong with one is said in one line, and no half-written file stays
/// behind.
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace blysk {

/// Bad use or bad input: the program prints "blysk: what()" and exits with status 2.
class usage_error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "FILE:LINE: what is wrong, what was expected"; line 0 stands for the file as a whole.
usage_error file_error(const std::string& path, std::size_t line, std::string_view what);

/// What the operating system says of the current errno, for the end of a message.
std::string system_reason();

struct close_file {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using file_handle = std::unique_ptr<std::FILE, close_file>;

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
  bool read_line();
  void set_text_to_line();
  void split();

  std::string path_;
  std::vector<std::string> names_;
  file_handle file_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  std::string line_;  // a line that does not lie whole in the buffer
  std::string_view text_;
  std::vector<std::string_view> fields_;  // empty until they are asked for
  std::size_t line_number_ = 0;
};

/// A result file: written beside its place and moved there by commit(), so that it is there as a whole or not at all.
/// A signal that ends the program takes the unfinished file with it. "-" is standard output; a device such as a terminal
/// is written as it stands, and so is what lies in /dev and /proc. A file that is replaced keeps its permissions, and a
/// link its place.
class output_file {
 public:
  /// \param ending  what the temporary name beside `path` ends with
  /// \throws usage_error if the file cannot be created
  explicit output_file(const std::string& path, std::string_view ending = ".part");
  ~output_file();
  output_file(const output_file&) = delete;
  output_file& operator=(const output_file&) = delete;

  /// \throws usage_error if the text cannot be written
  void write(std::string_view text);

  /// \throws usage_error if not all that was written has reached the disk
  void close();

  /// \throws usage_error if what was written cannot be brought to its place
  void commit();

  /// Where the text goes until commit(), for libraries that open the file themselves; empty if written in place.
  const std::string& temporary_path() const { return temporary_; }

 private:
  std::string path_;       // as messages name it
  std::string target_;     // path_, or what it links to
  std::string temporary_;  // empty if written in place
  file_handle file_;
  std::size_t line_ = 1;
};

/// \throws usage_error if two of the paths lead to the same file, or the same place for one; "-" and "" are none
/// \param options  what the paths are given by, for the message: "--results"
void expect_different_files(const std::vector<std::string>& options, const std::vector<std::string>& paths);

/// A directory to write into, made with those above it if it does not exist. What was made is removed again if it is
/// empty at the end.
class output_directory {
 public:
  /// \throws usage_error if it cannot be made
  explicit output_directory(const std::string& path);
  ~output_directory();
  output_directory(const output_directory&) = delete;
  output_directory& operator=(const output_directory&) = delete;

 private:
  void remove() const;

  std::vector<std::filesystem::path> made_;
};

/// Writes files into a directory, which is made if it does not exist: all of them, or none if one cannot be written.
/// \param texts  of the files by their names
/// \throws usage_error if they cannot be written, or the directory holds anything else: it would be taken for a part
void write_directory(const std::string& path, const std::map<std::string, std::string>& texts);

}  // namespace blysk
