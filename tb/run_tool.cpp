// SPDX-License-Identifier: Apache-2.0
#include "tb/run_tool.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sstream>
#include <string_view>

namespace blysk {
namespace {

std::atomic<pid_t> running_tool = 0;
static_assert(std::atomic<pid_t>::is_always_lock_free);

}  // namespace

bool is_installed(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((folder.empty() ? program : folder + "/" + program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

bool runs_well(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  posix_spawn_file_actions_addopen(&streams, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&streams, stream, "/dev/null", O_WRONLY, 0);
  // No signal comes between the start and running_tool; the tool itself gets them as before.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &before);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  pid_t id = 0;
  const bool is_started =
      posix_spawnp(&id, arguments[0], &streams, &attributes, arguments.data(), environ) == 0;
  if (is_started) running_tool = id;
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&streams);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (!is_started) return false;
  // Its number is its own until it is waited for to the end.
  siginfo_t ended{};
  while (waitid(P_PID, static_cast<id_t>(id), &ended, WEXITED | WNOWAIT) == -1 && errno == EINTR) {
  }
  running_tool = 0;
  int status = 1;
  while (waitpid(id, &status, 0) == -1) {
    if (errno != EINTR) return false;
  }
  return status == 0;
}

void end_running_tool() noexcept {
  const pid_t id = running_tool;
  if (id == 0) return;
  kill(id, SIGKILL);
  waitpid(id, nullptr, 0);
}

std::string seen_by_others(const std::string& path) {
  constexpr std::string_view kSelf = "/proc/self/";
  if (!path.starts_with(kSelf)) return path;
  return "/proc/" + std::to_string(getpid()) + "/" + path.substr(kSelf.size());
}

}  // namespace blysk
