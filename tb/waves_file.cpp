// SPDX-License-Identifier: Apache-2.0
#include "tb/waves_file.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "tb/usage_error.h"

namespace blysk {

namespace {

constexpr const char* kConverter = "vcd2fst";

bool is_installed(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((folder.empty() ? program : folder + "/" + program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

const std::string& checked(const std::string& path) {
  for (const std::string_view other : {".lxt", ".lxt2", ".vzt", ".ghw", ".fsdb", ".vpd", ".wlf"}) {
    if (path.ends_with(other))
      throw file_error(path, 0, "names another form of waves, expected .vcd or .fst");
  }
  return path;
}

/// The path as another process reaches it: "/proc/self" is this one.
std::string seen_by_others(const std::string& path) {
  constexpr std::string_view kSelf = "/proc/self/";
  if (!path.starts_with(kSelf)) return path;
  return "/proc/" + std::to_string(getpid()) + "/" + path.substr(kSelf.size());
}

}  // namespace

waves_file::waves_file(const std::string& path) : path_(path), recorded_(checked(path), ".vcd") {
  if (recorded_path().empty()) throw file_error(path, 0, "is no regular file, expected one to write");
  if (!path.ends_with(".fst")) return;
  if (!is_installed(kConverter))
    throw file_error(path, 0,
                     "is FST, which GTKWave's vcd2fst makes, and that is not installed; expected .vcd");
  converted_.emplace(path, ".fst");
}

void waves_file::commit(bool is_whole) {
  if (!is_whole) throw file_error(path_, 0, "cannot be written to its end, expected room for the waves");
  if (!converted_) {
    recorded_.commit();
    return;
  }
  convert();
  converted_->commit();
}

void waves_file::convert() {
  std::string program = kConverter;
  std::string from = seen_by_others(recorded_.temporary_path());
  std::string to = seen_by_others(converted_->temporary_path());
  const std::array<char*, 4> arguments{program.data(), from.data(), to.data(), nullptr};
  posix_spawn_file_actions_t streams;
  posix_spawn_file_actions_init(&streams);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&streams, stream, "/dev/null", O_WRONLY, 0);
  pid_t id = 0;
  const bool is_started = posix_spawnp(&id, kConverter, &streams, nullptr, arguments.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&streams);
  int status = 1;
  if (is_started) waitpid(id, &status, 0);
  if (!is_started || status != 0)
    throw file_error(path_, 0, "cannot be made: vcd2fst failed, expected room for the waves");
}

}  // namespace blysk
