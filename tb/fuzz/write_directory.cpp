// SPDX-License-Identifier: Apache-2.0
// The exporter's directory: lines of the input are names of what lies there already, the first character of each its
// kind. All files are written, and what else is there stays; or everything stays as it was.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

#include "tb/fuzz/fuzz.h"
#include "tb/output_file.h"

namespace {

namespace fs = std::filesystem;

/// What is in a directory: names with their kind and text.
std::map<std::string, std::string> contents(const fs::path& directory) {
  std::map<std::string, std::string> found;
  for (const auto& entry : fs::directory_iterator(directory)) {
    std::string& what = found[entry.path().filename().string()];
    if (entry.is_symlink()) {
      what = "link " + fs::read_symlink(entry.path()).string();
    } else if (entry.is_directory()) {
      what = "directory";
    } else {
      std::ifstream file(entry.path(), std::ios::binary);
      what = "file " + std::string(std::istreambuf_iterator<char>(file), {});
    }
  }
  return found;
}

void make(const fs::path& directory, std::string_view line) {
  std::string name(line.substr(1));
  std::erase(name, '/');
  std::erase(name, '\0');
  constexpr std::size_t kLongest = 255;
  name.resize(std::min(name.size(), kLongest));
  std::error_code exists;
  if (name.empty() || name == "." || name == ".." ||
      fs::symlink_status(directory / name, exists).type() != fs::file_type::not_found)
    return;
  switch (line[0]) {
    case 'd':
      fs::create_directory(directory / name);
      break;
    case 'l':
      fs::create_symlink("elsewhere", directory / name);
      break;
    default:
      std::ofstream(directory / name) << "old";
      break;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blysk;
  static fs::path parent = [] {
    std::string pattern = (fs::temp_directory_path() / "blysk-fuzz-XXXXXX").string();
    fuzz::expect(mkdtemp(pattern.data()) != nullptr, "no folder");
    std::atexit([] { fs::remove_all(parent); });
    return fs::path(pattern);
  }();
  const fs::path directory = parent / "export";
  fs::create_directory(directory);
  std::string_view text = fuzz::text_of(data, size);
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (line.size() > 1) make(directory, line);
    text.remove_prefix(std::min(text.size(), line.size() + 1));
  }
  const auto before = contents(directory);
  const std::map<std::string, std::string> texts{{"a.v", "module a"}, {"b.f", "a.v"}};
  try {
    write_directory(directory.string(), texts);
    auto expected = before;
    for (const auto& [name, written] : texts) {
      std::string& what = expected[name];
      if (!what.starts_with("link ")) what = "file " + written;
    }
    auto after = contents(directory);
    if (before.contains("a.v") || before.contains("b.f")) after.erase("elsewhere");  // what a link leads to
    expected.erase("elsewhere");
    fuzz::expect(after == expected, "not what was to be written, or something else was changed");
  } catch (const usage_error& error) {
    fuzz::expect(contents(directory) == before, "something was changed by an export that was refused");
    fuzz::expect(!std::string(error.what()).empty(), "no message");
  }
  fs::remove_all(directory);
  return 0;
}
