// SPDX-License-Identifier: Apache-2.0
#include "tb/files.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

namespace blysk {
namespace {

// Fields are a few characters long: the loops here are faster than the searches of the library.
std::string_view trim(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// The text as a message can hold it: control bytes escaped, cut between two characters of UTF-8.
std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::size_t size = std::min(text.size(), kLongest);
  while (size < text.size() && size > 0 && (text[size] & 0xC0) == 0x80) --size;
  std::string result;
  for (const char c : text.substr(0, size)) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte == 0x7F ? fmt::format("\\x{:02X}", byte) : std::string(1, c);
  }
  return size < text.size() ? result + "..." : result;
}

template <class Visitor>
void for_each_field(std::string_view text, Visitor&& visitor) {
  const char* begin = text.data();
  const char* const end = begin + text.size();
  for (const char* c = begin; c != end; ++c) {
    if (*c != ',') continue;
    visitor(trim({begin, c}));
    begin = c + 1;
  }
  visitor(trim({begin, end}));
}

/// Counted in bytes that no sum overflows, so that the compiler makes vectors of them.
std::size_t count_lines(std::string_view text) {
  constexpr std::size_t kLongestSum = 255;
  std::size_t lines = 0;
  for (std::size_t begin = 0; begin < text.size(); begin += kLongestSum) {
    std::uint8_t sum = 0;
    for (const char c : text.substr(begin, kLongestSum)) sum = static_cast<std::uint8_t>(sum + (c == '\n'));
    lines += sum;
  }
  return lines;
}

/// What a signal that ends the program has to remove: the paths of temporary files.
class unfinished_files {
 public:
  /// \param path  stays where it is until it is removed
  static void add(const char* path) {
    static const bool handles_signals = handle_signals();
    static_cast<void>(handles_signals);
    for (auto& place : paths_) {
      const char* nothing = nullptr;
      if (place.compare_exchange_strong(nothing, path)) return;
    }
  }

  static void remove(const char* path) {
    for (auto& place : paths_) {
      const char* expected = path;
      if (place.compare_exchange_strong(expected, nullptr)) return;
    }
  }

 private:
  static bool handle_signals() {
    struct sigaction ending {};
    ending.sa_handler = [](int signal) {
      for (const auto& place : paths_) {
        if (const char* const path = place.load()) unlink(path);
      }
      raise(signal);  // as if there were no handler
    };
    ending.sa_flags = static_cast<int>(SA_RESETHAND);
    for (const int signal : {SIGHUP, SIGINT, SIGPIPE, SIGTERM}) {
      struct sigaction before {};
      sigaction(signal, nullptr, &before);
      if (before.sa_handler == SIG_DFL) sigaction(signal, &ending, nullptr);
    }
    return true;
  }

  // Sphere writes most: a picture for each exponent and three files more.
  static inline std::array<std::atomic<const char*>, 1024> paths_{};
  static_assert(std::atomic<const char*>::is_always_lock_free);
};

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

}  // namespace

usage_error file_error(const std::string& path, std::size_t line, std::string_view what) {
  return usage_error(fmt::format("{}:{}: {}", path, line, what));
}

std::string system_reason() {
  return errno != 0 ? std::strerror(errno) : "unknown reason";
}

csv_reader::csv_reader(const std::string& path, std::string_view header)
    : path_(path == "-" ? "standard input" : path), buffer_(kBufferBytes + kSlack) {
  for_each_field(header, [&](std::string_view name) { names_.emplace_back(name); });
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) {
    throw file_error(path_, 0, "is a directory, expected a CSV file");
  }
  errno = 0;
  file_.reset(path == "-" ? fdopen(dup(STDIN_FILENO), "rb") : std::fopen(path.c_str(), "rb"));
  if (!file_)
    throw file_error(path_, 0, fmt::format("cannot be read ({}), expected a CSV file", system_reason()));
  if (!read_line()) throw file_error(path_, 1, fmt::format("is empty, expected the header {}", header));
  split();
  if (!std::equal(fields_.begin(), fields_.end(), names_.begin(), names_.end())) {
    throw error(fmt::format("header is '{}', expected {}", shown(text_), header));
  }
}

bool csv_reader::next() {
  do {
    if (!read_line()) return false;
  } while (trim(text_).empty());
  fields_.clear();
  return true;
}

const std::vector<std::string_view>& csv_reader::fields() {
  if (fields_.empty()) split();
  if (fields_.size() != names_.size()) {
    throw error(fmt::format("row has {} fields, expected {}: {}", fields_.size(), names_.size(),
                            fmt::join(names_, ",")));
  }
  return fields_;
}

// Sets text_ to the next line; lines that lie whole in the buffer are not copied.
bool csv_reader::read_line() {
  line_.clear();
  for (;;) {
    const char* const start = buffer_.data() + begin_;
    const auto* const newline =
        begin_ < end_ ? static_cast<const char*>(std::memchr(start, '\n', end_ - begin_)) : nullptr;
    if (newline != nullptr) {
      const auto size = static_cast<std::size_t>(newline - start);
      begin_ += size + 1;
      if (line_.empty()) {
        text_ = {start, size};
      } else {
        line_.append(start, size);
        set_text_to_line();
      }
      break;
    }
    line_.append(start, end_ - begin_);
    if (line_.size() > kLongestLine) {
      throw file_error(path_, line_number_ + 1,
                       fmt::format("is longer than {} bytes, expected a row of CSV", kLongestLine));
    }
    errno = 0;
    begin_ = 0;
    end_ = std::fread(buffer_.data(), 1, kBufferBytes, file_.get());
    if (end_ == 0) {
      if (std::ferror(file_.get()) != 0) {
        throw file_error(path_, line_number_ + 1, fmt::format("cannot be read ({})", system_reason()));
      }
      if (line_.empty()) return false;
      set_text_to_line();
      break;
    }
  }
  ++line_number_;
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (line_number_ == 1 && text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
  if (text_.ends_with('\r')) text_.remove_suffix(1);
  return true;
}

void csv_reader::set_text_to_line() {
  const std::size_t size = line_.size();
  line_.append(kSlack, '\0');
  text_ = std::string_view(line_).substr(0, size);
}

void csv_reader::split() {
  for_each_field(text_, [&](std::string_view field) { fields_.push_back(field); });
}

usage_error csv_reader::error(std::size_t column, std::string_view expected) const {
  return error(fmt::format("{} is '{}', expected {}", names_[column], shown(fields_[column]), expected));
}

usage_error csv_reader::error(std::string_view what) const {
  return file_error(path_, line_number_, what);
}

output_file::output_file(const std::string& path, std::string_view ending)
    : path_(path == "-" ? "standard output" : path) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const auto status = fs::status(path, ignored);
  // What a link leads to is written, not the link. /dev/stdout and the like are written where they are.
  const bool link = fs::is_symlink(fs::symlink_status(path, ignored));
  const bool special = path.starts_with("/dev/") || path.starts_with("/proc/");
  errno = 0;
  if (path == "-") {
    file_.reset(fdopen(dup(STDOUT_FILENO), "wb"));
  } else if (fs::is_directory(status)) {
    throw file_error(path_, 0, "is a directory, expected a file to write");
  } else if (special || (fs::exists(status) && !fs::is_regular_file(status))) {
    file_.reset(std::fopen(path.c_str(), "wb"));
  } else {
    target_ = link ? fs::weakly_canonical(path, ignored).string() : path;
    temporary_ = fmt::format("{}.{}{}", target_, getpid(), ending);
    unfinished_files::add(temporary_.c_str());
    file_.reset(std::fopen(temporary_.c_str(), "wb"));
    if (file_ && fs::exists(status)) fs::permissions(temporary_, status.permissions(), ignored);
  }
  if (!file_) {
    if (!temporary_.empty()) unfinished_files::remove(temporary_.c_str());
    throw file_error(path_, 0,
                     fmt::format("cannot be written ({}), expected a file to write", system_reason()));
  }
}

output_file::~output_file() {
  file_.reset();
  if (temporary_.empty()) return;
  std::remove(temporary_.c_str());
  unfinished_files::remove(temporary_.c_str());
}

void output_file::write(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) {
    throw file_error(path_, line_, fmt::format("cannot be written ({})", system_reason()));
  }
  line_ += count_lines(text);
}

void output_file::close() {
  errno = 0;
  if (file_ && std::fclose(file_.release()) != 0) {
    throw file_error(path_, line_, fmt::format("cannot be written ({})", system_reason()));
  }
}

void output_file::commit() {
  close();
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
    throw file_error(path_, 0, fmt::format("cannot be written ({})", system_reason()));
  }
  unfinished_files::remove(temporary_.c_str());
  temporary_.clear();
}

void expect_different_files(const std::vector<std::string>& options, const std::vector<std::string>& paths) {
  const auto leads_to = [](const std::string& path) {
    std::error_code ignored;
    return path.empty() || path == "-" || path.starts_with("/dev/")
               ? std::filesystem::path()
               : std::filesystem::weakly_canonical(std::filesystem::absolute(path), ignored);
  };
  for (std::size_t i = 0; i < paths.size(); ++i) {
    const auto place = leads_to(paths[i]);
    for (std::size_t j = 0; j < i; ++j) {
      if (!place.empty() && place == leads_to(paths[j])) {
        throw file_error(
            paths[i], 0,
            fmt::format("is given by {} and {}, expected different files", options[j], options[i]));
      }
    }
  }
}

output_directory::output_directory(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path above = fs::absolute(path, error);
  if (!above.has_filename()) above = above.parent_path();  // a slash at its end
  std::vector<fs::path> missing;
  for (; !error && !fs::exists(above, error) && !error; above = above.parent_path()) missing.push_back(above);
  if (!error && !fs::is_directory(above, error)) error = std::make_error_code(std::errc::not_a_directory);
  while (!error && !missing.empty()) {
    if (fs::create_directory(missing.back(), error)) made_.push_back(missing.back());
    missing.pop_back();
  }
  if (error) {
    remove();
    throw file_error(path, 0,
                     fmt::format("cannot be made ({}), expected a directory to write into", error.message()));
  }
}

output_directory::~output_directory() {
  remove();
}

void output_directory::remove() const {
  std::error_code ignored;
  for (auto last = made_.rbegin(); last != made_.rend(); ++last) std::filesystem::remove(*last, ignored);
}

void write_directory(const std::string& path, const std::map<std::string, std::string>& texts) {
  const output_directory place(path);
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(path, error)) {
    const std::string name = entry.path().filename().string();
    if (!texts.contains(name)) {
      throw file_error(
          path, 0,
          fmt::format(
              "holds {}, expected an empty directory or one with files of the same names as those to write",
              name));
    }
  }
  if (error)
    throw file_error(path, 0,
                     fmt::format("cannot be read ({}), expected a directory to write into", error.message()));
  std::vector<std::unique_ptr<output_file>> files;
  for (const auto& [name, text] : texts) {
    files.push_back(std::make_unique<output_file>((std::filesystem::path(path) / name).string()));
    files.back()->write(text);
    files.back()->close();
  }
  for (const auto& file : files) file->commit();
}

}  // namespace blysk
