// SPDX-License-Identifier: Apache-2.0
// rtl_verilog/ is what the SystemC model exports. With BLYSK_UPDATE_VERILOG in the environment it is rewritten.
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "tb/catch.h"
#include "tb/export/export.h"

namespace blysk::verilog {
namespace {

files read_directory(const std::filesystem::path& directory) {
  files result;
  if (!std::filesystem::exists(directory)) return result;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    std::ifstream file(entry.path(), std::ios::binary);
    result[entry.path().filename()] = {std::istreambuf_iterator<char>(file), {}};
  }
  return result;
}

void compare(const std::string& format) {
  device_options options;
  options.format = format;
  const std::filesystem::path directory = std::filesystem::path(BLYSK_RTL_VERILOG) / ("quadratic_" + format);
  if (std::getenv("BLYSK_UPDATE_VERILOG") != nullptr) {
    std::filesystem::remove_all(directory);
    export_device(options, directory);
    return;
  }
  const files exported = export_files(options);
  const files checked_in = read_directory(directory);
  for (const auto& [name, text] : exported) {
    CAPTURE(name);
    REQUIRE(checked_in.contains(name));
    CHECK(checked_in.at(name) == text);
  }
  CHECK(checked_in.size() == exported.size());
}

}  // namespace

// A process elaborates one device: ctest runs each case in its own.
TEST_CASE("q8", "[verilog]") {
  compare("q8");
}
TEST_CASE("q10", "[verilog]") {
  compare("q10");
}
TEST_CASE("q12", "[verilog]") {
  compare("q12");
}
TEST_CASE("q14", "[verilog]") {
  compare("q14");
}
TEST_CASE("q16", "[verilog]") {
  compare("q16");
}
TEST_CASE("q18", "[verilog]") {
  compare("q18");
}
TEST_CASE("q20", "[verilog]") {
  compare("q20");
}
TEST_CASE("q22", "[verilog]") {
  compare("q22");
}
TEST_CASE("q24", "[verilog]") {
  compare("q24");
}

}  // namespace blysk::verilog
