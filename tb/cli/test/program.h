// SPDX-License-Identifier: Apache-2.0
/// The program blysk as tests start it, in a folder of their own.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

/// The device that a command line takes if it names none, and its Verilog module in a format.
inline const std::string kDevice = BLYSK_DEVICE_NAME;
inline std::string top_of(const std::string& format) {
  return "blysk_" BLYSK_DEVICE_IDENTIFIER "_" + format;
}

/// A folder that vanishes with the test.
class scratch {
 public:
  scratch() {
    std::string pattern =
        (fs::temp_directory_path() / "blysk test XXXXXX").string();  // a blank in every path
    folder_ = mkdtemp(pattern.data());
  }
  ~scratch() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  scratch(const scratch&) = delete;
  scratch& operator=(const scratch&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return path(name);
  }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      names.push_back(entry.path().filename().string());
    return names;
  }

 private:
  fs::path folder_;
};

inline std::string slurp(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
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
