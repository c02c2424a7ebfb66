// SPDX-License-Identifier: Apache-2.0
#include "tb/run_program.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <iostream>
#include <new>
#include <string>
#include <system_error>

#include "tb/usage_error.h"

namespace blysk {
namespace {

/// A number that the caller closed would go to the first file that is opened, and messages into it.
void hold_standard_files() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(number, F_GETFD) != -1 || errno != EBADF) continue;
    // Opened the wrong way round, so that using it is an error. The lowest free number is this one.
    if (open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY) == -1) return;
  }
}

/// SIGXCPU when the process has used that much processor time.
void end_after(long milliseconds) {
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGXCPU;
  timer_t timer{};
  if (timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer) != 0) return;
  itimerspec time{};
  time.it_value.tv_nsec = milliseconds * 1'000'000;
  timer_settime(timer, TIMER_ABSTIME, &time, nullptr);
}

/// The hard limit of processor time kills without a signal that can be handled; the soft one comes a second before. One
/// second is the smallest soft limit: under a hard one of as much, a timer comes first.
void soften_processor_time() {
  rlimit limit{};
  if (getrlimit(RLIMIT_CPU, &limit) != 0) return;
  if (limit.rlim_max == RLIM_INFINITY || limit.rlim_cur < limit.rlim_max) return;
  if (limit.rlim_max < 2) {
    end_after(800);
  } else {
    limit.rlim_cur = limit.rlim_max - 1;
    setrlimit(RLIMIT_CPU, &limit);
  }
}

void finish_standard_output() {
  errno = 0;
  std::cout.flush();
  if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw file_error("standard output", 0, fmt::format("cannot be written ({})", system_reason()));
  }
}

}  // namespace

void say(std::string_view name, std::string_view what) noexcept {
  constexpr std::size_t kMost = 2000;
  constexpr std::size_t kEnd = 500;
  try {
    const std::string text = what.size() <= kMost
                                 ? printable(what)
                                 : fmt::format("{} [...] {}", printable(what.substr(0, kMost - kEnd)),
                                               printable(what.substr(what.size() - kEnd)));
    std::fputs(fmt::format("{}: {}\n", name, text).c_str(), stderr);
  } catch (const std::exception&) {  // no memory
    std::fputs("out of memory\n", stderr);
  }
}

int run_program(std::string_view name, const std::function<int()>& body) noexcept {
  hold_standard_files();
  soften_processor_time();
  std::signal(SIGXFSZ, SIG_IGN);
  // Where a caller ignores it, the end of a tool could not be waited for.
  std::signal(SIGCHLD, SIG_DFL);
  try {
    const int status = body();
    finish_standard_output();
    return status;
  } catch (const std::bad_alloc&) {
    say(name, "out of memory");
  } catch (const std::system_error& error) {
    // fmt::print does not say which file it could not write.
    if (std::ferror(stdout) != 0)
      say(name, "standard output: cannot be written (" + error.code().message() + ")");
    else
      say(name, error.what());
  } catch (const std::exception& error) {
    say(name, error.what());
  } catch (...) {
    say(name, "unknown error");
  }
  return 2;
}

}  // namespace blysk
