// SPDX-License-Identifier: Apache-2.0
#include "tb/fuzz/fuzz.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "tb/usage_error.h"

namespace blysk::fuzz {

void expect(bool holds, std::string_view what) {
  if (holds) return;
  std::fprintf(stderr, "%.*s\n", static_cast<int>(what.size()), what.data());
  std::abort();
}

void expect_message(std::string_view what) {
  expect(!what.empty() && printable(what) == what, "a message is no line of printable text");
}

memory_file::memory_file(std::string_view text)
    : number_(memfd_create("fuzz", MFD_CLOEXEC)), path_("/proc/self/fd/" + std::to_string(number_)) {
  expect(number_ != -1 && write(number_, text.data(), text.size()) == static_cast<ssize_t>(text.size()),
         "no file in memory");
}

memory_file::~memory_file() {
  close(number_);
}

}  // namespace blysk::fuzz
