// SPDX-License-Identifier: Apache-2.0
/// Files that are written atomically.
#pragma once

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "tb/usage_error.h"

namespace blysk {

/// A result file: written under a temporary name and moved to its place by commit(), so that it is there as a whole or
/// not at all. What ends the program, a signal too, takes the unfinished file with it; SIGKILL leaves it.
///
/// The temporary file is a new one with a random name beside the place. Only it is ever removed. A file that is
/// replaced keeps its owner and permissions; a link stays and what it leads to is replaced. Where a new file cannot
/// take the place of the old one, commit() copies the text over the old one: in a folder that cannot be written, on a
/// mount point, with another owner, with a second hard link. A file that the user may not write is refused.
///
/// "-" is standard output, and so is /dev/stdout; a device such as a terminal is written as it stands, and so is what lies
/// in /dev and /proc, such as /dev/fd/3.
class output_file {
 public:
  /// \param ending  not empty if a library opens the file by its name: what the temporary name ends with. The file lies
  ///                in a folder that only this user can write, so nobody can put a link in its place.
  /// \throws usage_error if the file cannot be created
  explicit output_file(const std::string& path, std::string_view ending = {});
  ~output_file();
  output_file(const output_file&) = delete;
  output_file& operator=(const output_file&) = delete;

  /// \throws usage_error if the text cannot be written
  void write(std::string_view text);

  /// Hands on what was written so far, to who reads the other end of a pipe.
  /// \throws usage_error if it cannot be written
  void flush();

  /// \throws usage_error if not all that was written has reached the disk
  void close();

  /// \throws usage_error if what was written cannot be brought to its place
  void commit();

  /// Where the text goes until commit(), for libraries that open the file themselves; empty if there is no temporary
  /// file. Valid as long as this object.
  const std::string& temporary_path() const;

 private:
  class temporary_file;
  struct close_stream {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  void stage(std::string_view ending);
  [[noreturn]] void fail(std::size_t line, std::string_view expected = {}) const;

  std::string path_;                           // as messages name it
  std::string target_;                         // path_, or what it links to
  std::unique_ptr<temporary_file> temporary_;  // null if written as it stands
  bool copies_ = false;                        // commit() copies over what is there
  std::unique_ptr<std::FILE, close_stream> file_;
  std::size_t line_ = 1;  // for messages; 0: what is written is no text
};

/// True for "-" and for what names the same: /dev/stdout, /dev/fd/1, /proc/self/fd/1, a link to one of them.
bool is_standard_output(const std::string& path);

/// What a path to read leads to: "-" is standard input there.
std::string input_path(const std::string& path);

/// \throws usage_error if two of the paths lead to the same file, the same place for one, or standard output; "" is none.
///         Standard input and other open files (/dev/fd/3) count where they are regular files.
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
  void remove();

  std::vector<std::unique_ptr<const std::string>> made_;
};

/// Writes files into a directory, which is made if it does not exist: all of them, or none if one cannot be written.
/// \param texts  of the files by their names
/// \throws usage_error if they cannot be written, or the directory holds anything else that is not hidden: it would be
///         taken for a part
void write_directory(const std::string& path, const std::map<std::string, std::string>& texts);

}  // namespace blysk
