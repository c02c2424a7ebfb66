// SPDX-License-Identifier: Apache-2.0
#include "tb/csv_reader.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
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

/// The text as a message can hold it: printable, cut between two characters of UTF-8.
std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  constexpr std::size_t kLongestCharacter = 4;
  const auto goes_on = [text](std::size_t i) { return i < text.size() && (text[i] & 0xC0) == 0x80; };
  std::size_t size = std::min(text.size(), kLongest);
  while (size > kLongest - kLongestCharacter && goes_on(size)) --size;
  return printable(text.substr(0, size)) + (size < text.size() ? "..." : "");
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

constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

}  // namespace

csv_reader::csv_reader(const std::string& path, std::string_view header)
    : path_(path == "-" ? "standard input" : path), buffer_(kBufferBytes + kSlack) {
  for_each_field(header, [&](std::string_view name) { names_.emplace_back(name); });
  if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) {
    throw file_error(path_, 0, "is a directory, expected a CSV file");
  }
  errno = 0;
  file_.reset(path == "-" ? fdopen(dup(STDIN_FILENO), "rb") : std::fopen(path.c_str(), "rbe"));
  if (errno == EINVAL) errno = EBADF;  // open, but not for reading
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

}  // namespace blysk
