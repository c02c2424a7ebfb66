// SPDX-License-Identifier: Apache-2.0
#include "tb/run_tool.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <string_view>

namespace blysk {

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
  pid_t id = 0;
  const bool is_started = posix_spawnp(&id, arguments[0], &streams, nullptr, arguments.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&streams);
  if (!is_started) return false;
  int status = 1;
  while (waitpid(id, &status, 0) == -1) {
    if (errno != EINTR) return false;
  }
  return status == 0;
}

std::string seen_by_others(const std::string& path) {
  constexpr std::string_view kSelf = "/proc/self/";
  if (!path.starts_with(kSelf)) return path;
  return "/proc/" + std::to_string(getpid()) + "/" + path.substr(kSelf.size());
}

}  // namespace blysk
