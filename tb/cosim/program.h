// SPDX-License-Identifier: Apache-2.0
/// What the programs of this folder have in common.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace blysk::cosim {

/// The body of a main(): bad use or bad input ends it with one line on standard error and status 2.
template <class Body>
int program(Body body) {
  try {
    return body();
  } catch (const std::exception& error) {
    fmt::print(stderr, "blysk: {}\n", error.what());
    return 2;
  }
}

/// \throws std::invalid_argument if the text is no decimal number above zero
inline std::uint64_t positive(std::string_view name, std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value == 0) {
    throw std::invalid_argument(fmt::format("{} is '{}', expected a number above zero", name, text));
  }
  return value;
}

/// Writes the file as a whole or not at all.
/// \throws std::runtime_error if it cannot be written
inline void write_file(const std::string& path, std::string_view text) {
  const std::string part = path + ".part";
  std::ofstream file(part, std::ios::binary);
  file << text;
  file.close();
  if (!file || std::rename(part.c_str(), path.c_str()) != 0) {
    std::remove(part.c_str());
    throw std::runtime_error(path + ": cannot be written, expected a file in a folder that exists");
  }
}

}  // namespace blysk::cosim
