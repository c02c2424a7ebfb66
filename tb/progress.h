// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>

#include "tb/output_file.h"

namespace blysk {

/// True for results that go to a terminal: progress would stand among them.
inline bool is_shown_at(const std::string& path) {
  return is_standard_output(path) && isatty(STDOUT_FILENO) == 1;
}

/// One line on a terminal's standard error that tells how far long work has come; nothing where that is no terminal.
class progress {
 public:
  /// \param total      0 if it is not known: what was done is shown in millions then
  /// \param is_wanted  false: nothing is shown
  progress(std::string what, std::size_t total, bool is_wanted = true)
      : what_(std::move(what)), total_(total), shown_(is_wanted && isatty(STDERR_FILENO) == 1) {}
  ~progress() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  progress(const progress&) = delete;
  progress& operator=(const progress&) = delete;

  void advance(std::size_t amount) { reach(done_ + amount); }

  void reach(std::size_t done) {
    done_ = done;
    const std::size_t reached = total_ != 0 ? 100 * done_ / total_ : done_ / 1'000'000;
    if (!shown_ || (is_begun_ && reached == reached_)) return;
    is_begun_ = true;
    reached_ = reached;
    std::fprintf(stderr, "\r%s %3zu %s", what_.c_str(), reached, total_ != 0 ? "%" : "M");
    std::fflush(stderr);
  }

 private:
  std::string what_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::size_t reached_ = 0;
  bool is_begun_ = false;
  bool shown_;
};

}  // namespace blysk
