// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/wave_names.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "tb/catch.h"
#include "tb/usage_error.h"

using blysk::harness::declared_signals;
using blysk::harness::rows_of;
using Catch::Matchers::EndsWith;

namespace {

/// A file with that text, for the time of a test.
class file {
 public:
  file(const std::string& name, const std::string& text)
      : path_(std::filesystem::temp_directory_path() / (std::to_string(getpid()) + name)) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  ~file() { std::filesystem::remove(path_); }
  file(const file&) = delete;
  file& operator=(const file&) = delete;

  std::string path() const { return path_; }

 private:
  std::filesystem::path path_;
};

const std::string kHeader =
    "$comment\nblysk-device --device some-device\n$end\n$scope module SystemC $end\n$var wire 1 aaa clk "
    "$end\n"
    " $scope module rg1 $end\r\n  $var wire 10 aac q_o [9:0] $end\n $upscope $end\n$var wire 4 aad "
    "flags[3:0] $end\n"
    "$upscope $end\n$enddefinitions $end\n";

}  // namespace

TEST_CASE("names have their scopes and no range") {
  const file vcd(".vcd", kHeader + "$scope module late $end\n$var wire 1 aae late $end\n");
  CHECK(declared_signals(vcd.path()) ==
        std::unordered_set<std::string>{"SystemC.clk", "SystemC.rg1.q_o", "SystemC.flags"});
}

TEST_CASE("the waves of a terabyte take no time") {
  const file vcd(".vcd", kHeader);
  std::filesystem::resize_file(vcd.path(), std::uintmax_t{1} << 40);
  CHECK(declared_signals(vcd.path()).size() == 3);
}

TEST_CASE("rows are counted whose signal is declared") {
  const file vcd(".vcd", kHeader);
  const auto signals = declared_signals(vcd.path());
  const auto rows = [&](const std::string& text) {
    const auto [shown, unknown] = rows_of(file(".gtkw", text).path(), signals);
    return std::pair(shown, unknown);
  };
  CHECK(rows("[size] 1600 1000\n@22\n+{n} SystemC.rg1.q_o[9:0]\nSystemC.clk\n") ==
        std::pair<std::size_t, std::size_t>(2, 0));
  CHECK(rows("SystemC.flags[3:0]\n") == std::pair<std::size_t, std::size_t>(1, 0));
  CHECK(rows("SystemC.cos18[30:0]\nTOP.clk\nSystemC.rg1\nclk\n-a title\n") ==
        std::pair<std::size_t, std::size_t>(0, 4));
  CHECK(rows("") == std::pair<std::size_t, std::size_t>(0, 0));
}

TEST_CASE("a header without its end is refused") {
  const file cut(".vcd", kHeader.substr(0, 100));
  CHECK_THROWS_WITH(declared_signals(cut.path()),
                    EndsWith(" the header has no end, expected $enddefinitions"));
  const file closed(".vcd", "$upscope $end\n" + kHeader);
  CHECK_THROWS_WITH(declared_signals(closed.path()),
                    EndsWith(":1: no scope is open, expected $scope before it"));
  CHECK_THROWS_AS(declared_signals("nowhere.vcd"), blysk::usage_error);
}
