// SPDX-License-Identifier: Apache-2.0
/// The program blysk as tests start it, in a folder of their own.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "tb/scratch.h"

namespace fs = std::filesystem;

/// The device that a command line takes if it names none, and its Verilog module in a format.
inline const std::string kDevice = BLYSK_DEVICE_NAME;
inline std::string top_of(const std::string& format) {
  return "blysk_" BLYSK_DEVICE_IDENTIFIER "_" + format;
}

struct outcome {
  int status;
  std::string out, err;
};

inline std::string quoted(const std::string& text) {
  return "'" + text + "'";
}

/// \param first  shell commands, each with its semicolon
inline outcome run_blysk(const scratch& folder, const std::string& arguments, const std::string& first = "") {
  const std::string out = folder.path("stdout.txt");
  const std::string err = folder.path("stderr.txt");
  const int raw = std::system(
      (first + quoted(BLYSK_PROGRAM) + " " + arguments + " >" + quoted(out) + " 2>" + quoted(err)).c_str());
  outcome result{WIFEXITED(raw) ? WEXITSTATUS(raw) : -1, slurp(out), slurp(err)};
  fs::remove(out);
  fs::remove(err);
  return result;
}
