// SPDX-License-Identifier: Apache-2.0
/// What the doors' fuzz targets share: places where text from outside enters, each tried with whatever may come.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// One input, as libFuzzer calls it; replay.cpp calls it with each file that is kept.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace blysk::fuzz {

/// Ends the program with a message if it does not hold.
void expect(bool holds, std::string_view what);

/// What a door says of bad input is one line of printable text.
void expect_message(std::string_view what);

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// A file in memory with that text.
class memory_file {
 public:
  explicit memory_file(std::string_view text);
  ~memory_file();
  memory_file(const memory_file&) = delete;
  memory_file& operator=(const memory_file&) = delete;

  const std::string& path() const { return path_; }

 private:
  int number_;
  std::string path_;
};

}  // namespace blysk::fuzz
