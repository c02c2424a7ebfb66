// SPDX-License-Identifier: Apache-2.0
#include "tb/waves_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "tb/run_tool.h"
#include "tb/usage_error.h"

namespace blysk {

namespace {

constexpr const char* kConverter = "vcd2fst";

/// Whether a path ends so, in letters of either case.
bool has_ending(const std::string& path, std::string_view ending) {
  return path.size() >= ending.size() &&
         std::equal(ending.rbegin(), ending.rend(), path.rbegin(), [](char of_ending, char of_path) {
           return of_ending == std::tolower(static_cast<unsigned char>(of_path));
         });
}

const std::string& checked(const std::string& path) {
  for (const std::string_view other : {".lxt", ".lxt2", ".vzt", ".ghw", ".fsdb", ".vpd", ".wlf"}) {
    if (has_ending(path, other))
      throw file_error(path, 0, "names another form of waves, expected .vcd or .fst");
  }
  for (const std::string_view packed : {".gz", ".bz2", ".xz", ".zst", ".zip"}) {
    if (has_ending(path, packed)) throw file_error(path, 0, "names a packed file, expected .vcd or .fst");
  }
  return path;
}

}  // namespace

waves_file::waves_file(const std::string& path) : path_(path), recorded_(checked(path), ".vcd") {
  if (recorded_path().empty()) throw file_error(path, 0, "is no regular file, expected one to write");
  if (!has_ending(path, ".fst")) return;
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
  const std::string& made = converted_->temporary_path();
  const bool is_well =
      runs_well({kConverter, seen_by_others(recorded_.temporary_path()), seen_by_others(made)});
  // A good status is no proof that it wrote.
  std::error_code error;
  if (!is_well || std::filesystem::file_size(made, error) == 0 || error)
    throw file_error(path_, 0, "cannot be made: vcd2fst failed, expected room for the waves");
}

}  // namespace blysk
