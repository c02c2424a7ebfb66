// SPDX-License-Identifier: Apache-2.0
#include "tb/line_reader.h"

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

// The buffer begins small, for the many files that are, and grows with what is there.
constexpr std::size_t kFirstBufferBytes = std::size_t{1} << 12;
constexpr std::size_t kBufferBytes = std::size_t{1} << 18;
constexpr std::size_t kLongestLine = std::size_t{1} << 20;

}  // namespace

class line_reader::descriptor {
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

line_reader::line_reader(const std::string& path, std::string_view what)
    : path_(path == "-" ? "standard input" : path), what_(what), buffer_(kFirstBufferBytes) {
  if (std::error_code ignored; path != "-" && std::filesystem::is_directory(path, ignored)) {
    throw file_error(path_, 0, fmt::format("is a directory, expected {}", what_));
  }
  errno = 0;
  file_ = std::make_unique<descriptor>(path == "-" ? dup(STDIN_FILENO)
                                                   : ::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file_->number() != -1 && (fcntl(file_->number(), F_GETFL) & O_ACCMODE) == O_WRONLY) errno = EBADF;
  if (file_->number() == -1 || errno == EBADF)
    throw file_error(path_, 0, fmt::format("cannot be read ({}), expected {}", system_reason(), what_));
}

line_reader::~line_reader() = default;

bool line_reader::next(bool may_wait) {
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
  has_end_ = newline != nullptr;
  text_ = {buffer_.data() + line_, line_end - line_};
  ++number_;
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (number_ == 1 && text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
  if (text_.ends_with('\r')) text_.remove_suffix(1);
  return true;
}

void line_reader::put_back() {
  begin_ = line_;
  --number_;
}

// Reads more behind what there is; false where that would have to wait.
bool line_reader::fill(bool may_wait) {
  if (end_ - begin_ > kLongestLine) {
    throw file_error(path_, number_ + 1,
                     fmt::format("is longer than {} bytes, expected {}", kLongestLine, what_));
  }
  if (begin_ != 0) {
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  const bool was_filled = bytes_read_ >= buffer_.size() && buffer_.size() < kBufferBytes;
  if (was_filled || end_ == buffer_.size()) buffer_.resize(2 * buffer_.size());
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
      throw file_error(path_, number_ + 1, fmt::format("cannot be read ({})", system_reason()));
    }
  }
}

std::size_t line_reader::file_size() const {
  struct stat status {};
  return fstat(file_->number(), &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0
             ? static_cast<std::size_t>(status.st_size)
             : 0;
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

}  // namespace blysk
