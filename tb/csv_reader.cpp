// SPDX-License-Identifier: Apache-2.0
#include "tb/csv_reader.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace blysk {
namespace {

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

// Fields are a few characters long: the loops here are faster than the searches of the library.
std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_comment(std::string_view trimmed) {
  return trimmed.starts_with('#');
}

/// The text as a message can hold it: printable, cut between two characters of UTF-8.
std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  constexpr std::size_t kLongestCharacter = 4;
  const auto goes_on = [text](std::size_t i) { return i < text.size() && (text[i] & 0xC0) == 0x80; };
  std::size_t size = std::min(text.size(), kLongest);
  while (size > kLongest - kLongestCharacter && goes_on(size)) --size;
  return printable(text.substr(0, size)) + (size < text.size() ? "..." : "");
}

/// A quoted field, from its quote to the one that ends it.
struct quoted_field {
  std::string_view inside;
  std::size_t size = 0;  ///< of the text, quotes included; 0 if no quote ends it
  bool has_quotes = false;
};

quoted_field read_quoted(std::string_view text) {
  quoted_field field;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] != '"') continue;
    if (i + 1 < text.size() && text[i + 1] == '"') {
      field.has_quotes = true;
      ++i;
    } else {
      field.inside = text.substr(1, i - 1);
      field.size = i + 1;
      break;
    }
  }
  return field;
}

std::string without_doubled_quotes(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    result += text[i];
    if (text[i] == '"') ++i;
  }
  return result;
}

/// Empty fields at the end, beyond `least`: what a comma at the end of a line leaves.
void drop_empty_ends(std::vector<std::string_view>& fields, std::size_t least) {
  while (fields.size() > least && fields.back().empty()) fields.pop_back();
}

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

}  // namespace

class csv_reader::descriptor {
 public:
  explicit descriptor(int number) : number_(number) {}
  ~descriptor() {
    if (number_ != -1) ::close(number_);
  }
  descriptor(const descriptor&) = delete;
  descriptor& operator=(const descriptor&) = delete;

  int number() const { return number_; }

  /// Waits until something can be read, or the end of the file; false if that would take longer.
  bool wait_ms(int time) const {
    pollfd asked{number_, POLLIN, 0};
    return poll(&asked, 1, time) != 0;
  }

 private:
  int number_;
};

csv_reader::csv_reader(const std::string& path, std::string_view header)
    : path_(path == "-" ? "standard input" : path), buffer_(kBufferBytes) {
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) {
    throw file_error(path_, 0, "is a directory, expected a CSV file");
  }
  errno = 0;
  file_ = std::make_unique<descriptor>(path == "-" ? dup(STDIN_FILENO)
                                                   : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file_->number() != -1 && (fcntl(file_->number(), F_GETFL) & O_ACCMODE) == O_WRONLY) errno = EBADF;
  if (file_->number() == -1 || errno == EBADF)
    throw file_error(path_, 0, fmt::format("cannot be read ({}), expected a CSV file", system_reason()));
  read_header(header);
}

csv_reader::~csv_reader() = default;

void csv_reader::read_header(std::string_view header) {
  std::vector<std::string_view> wanted;
  split(header, ',', wanted);
  names_.assign(wanted.begin(), wanted.end());
  bool is_found = false;
  while (read_line(true)) {
    const std::string_view line = trim(text_);
    if (line.empty()) continue;
    if (is_comment(line)) {
      is_found =
          find_columns(trim(line.substr(std::min(line.find_first_not_of('#'), line.size())))) || is_found;
      continue;
    }
    if (find_columns(line)) return;
    if (!is_found) throw error(fmt::format("header is '{}', expected {}", shown(text_), header));
    put_back();  // the first row below a header behind #
    return;
  }
  if (line_number_ == 0) throw file_error(path_, 1, fmt::format("is empty, expected the header {}", header));
  if (!is_found) throw error(fmt::format("is no header, expected {}", header));
}

// Takes the line as the header if it is one.
bool csv_reader::find_columns(std::string_view line) {
  for (const char separator : {',', ';', '\t', ' '}) {
    std::vector<std::string_view> columns;
    if (!split(line, separator, columns)) continue;
    drop_empty_ends(columns, 0);
    std::vector<std::size_t> places;
    for (const std::string& name : names_) {
      if (std::count(columns.begin(), columns.end(), name) != 1) break;
      places.push_back(
          static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) - columns.begin()));
    }
    if (places.size() != names_.size()) continue;
    separator_ = separator;
    places_ = std::move(places);
    all_names_.assign(columns.begin(), columns.end());
    is_plain_ = separator == ',' && all_names_ == names_;
    return true;
  }
  return false;
}

bool csv_reader::next() {
  return next_row(true);
}

bool csv_reader::next_at_hand() {
  return next_row(false);
}

bool csv_reader::next_row(bool may_wait) {
  for (;;) {
    if (!read_line(may_wait)) return false;
    const std::string_view line = trim(text_);
    const bool is_empty =
        std::ranges::all_of(line, [this](char c) { return c == separator_ || is_blank(c); });
    if (!is_empty && !is_comment(line)) break;
  }
  fields_.clear();
  return true;
}

const std::vector<std::string_view>& csv_reader::fields() {
  if (!fields_.empty()) return fields_;
  if (!split(text_, separator_, all_fields_)) {
    throw error(
        fmt::format("row '{}' has a quote out of place, expected fields such as 1 or \"1\"", shown(text_)));
  }
  drop_empty_ends(all_fields_, all_names_.size());
  if (all_fields_.size() != all_names_.size()) {
    throw error(fmt::format("row has {} fields, expected {}: {}", all_fields_.size(), all_names_.size(),
                            shown(fmt::format("{}", fmt::join(all_names_, ",")))));
  }
  for (const std::size_t place : places_) fields_.push_back(all_fields_[place]);
  return fields_;
}

// False if a quote has no end, or text behind it.
bool csv_reader::split(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  const bool by_blanks = separator == ' ';
  const auto ends = [=](char c) { return by_blanks ? is_blank(c) : c == separator; };
  const auto skips = [=](char c) { return !by_blanks && is_blank(c) && c != separator; };
  if (by_blanks) line = trim(line);
  unescaped_.clear();
  fields.clear();
  std::size_t at = 0;
  for (;;) {
    while (at < line.size() && skips(line[at])) ++at;
    if (at < line.size() && line[at] == '"') {
      const quoted_field field = read_quoted(line.substr(at));
      if (field.size == 0) return false;
      fields.push_back(field.has_quotes ? unescaped_.emplace_back(without_doubled_quotes(field.inside))
                                        : trim(field.inside));
      at += field.size;
      while (at < line.size() && skips(line[at])) ++at;
      if (at < line.size() && !ends(line[at])) return false;
    } else {
      const std::size_t begin = at;
      while (at < line.size() && !ends(line[at])) ++at;
      fields.push_back(trim(line.substr(begin, at - begin)));
    }
    if (at == line.size()) return true;
    ++at;
    while (by_blanks && is_blank(line[at])) ++at;  // the line's last character is none
  }
}

// Sets text_ to the next line; false at the end of the file, or where it would have to wait.
bool csv_reader::read_line(bool may_wait) {
  std::size_t searched = 0;
  const char* newline = nullptr;
  for (;;) {
    const char* const from = buffer_.data() + begin_ + searched;
    const std::size_t size = end_ - begin_ - searched;
    newline = size == 0 ? nullptr : static_cast<const char*>(std::memchr(from, '\n', size));
    if (newline != nullptr || is_ended_) break;
    searched += size;
    if (!fill(may_wait)) return false;
  }
  if (newline == nullptr && begin_ == end_) return false;
  line_ = begin_;
  const std::size_t line_end = newline == nullptr ? end_ : static_cast<std::size_t>(newline - buffer_.data());
  begin_ = newline == nullptr ? end_ : line_end + 1;
  text_ = {buffer_.data() + line_, line_end - line_};
  ++line_number_;
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (line_number_ == 1 && text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
  if (text_.ends_with('\r')) text_.remove_suffix(1);
  return true;
}

// The next read_line() gives the same line again.
void csv_reader::put_back() {
  begin_ = line_;
  --line_number_;
}

// Reads more behind what there is; false where that would have to wait.
bool csv_reader::fill(bool may_wait) {
  if (end_ - begin_ > kLongestLine) {
    throw file_error(path_, line_number_ + 1,
                     fmt::format("is longer than {} bytes, expected a row of CSV", kLongestLine));
  }
  if (begin_ != 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
  for (;;) {
    if (!may_wait && !file_->wait_ms(0)) return false;
    const ssize_t size = ::read(file_->number(), buffer_.data() + end_, buffer_.size() - end_);
    if (size >= 0) {
      is_ended_ = size == 0;
      end_ += static_cast<std::size_t>(size);
      bytes_read_ += static_cast<std::size_t>(size);
      return true;
    }
    if (errno == EAGAIN || errno == EWOULDBLOCK) {
      if (!may_wait) return false;
      file_->wait_ms(-1);
    } else if (errno != EINTR) {
      throw file_error(path_, line_number_ + 1, fmt::format("cannot be read ({})", system_reason()));
    }
  }
}

std::size_t csv_reader::file_size() const {
  struct stat status {};
  return fstat(file_->number(), &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0
             ? static_cast<std::size_t>(status.st_size)
             : 0;
}

usage_error csv_reader::error(std::size_t column, std::string_view expected) const {
  return error(fmt::format("{} is '{}', expected {}", names_[column], shown(fields_[column]), expected));
}

usage_error csv_reader::error(std::string_view what) const {
  return file_error(path_, line_number_, what);
}

}  // namespace blysk
