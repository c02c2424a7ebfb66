// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <string>

namespace blysk {

/// One line on a terminal's standard error that tells how far long work has come; nothing where that is no terminal.
class progress {
 public:
  progress(std::string what, std::size_t total) : what_(std::move(what)), total_(total) {}
  ~progress() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  progress(const progress&) = delete;
  progress& operator=(const progress&) = delete;

  void advance(std::size_t amount) {
    done_ += amount;
    const int percent = static_cast<int>(100 * done_ / total_);
    if (!shown_ || percent == percent_) return;
    percent_ = percent;
    std::fprintf(stderr, "\r%s %3d %%", what_.c_str(), percent);
    std::fflush(stderr);
  }

 private:
  std::string what_;
  std::size_t total_;
  std::size_t done_ = 0;
  int percent_ = -1;
  bool shown_ = isatty(STDERR_FILENO) == 1;
};

}  // namespace blysk
