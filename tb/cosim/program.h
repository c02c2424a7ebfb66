// SPDX-License-Identifier: Apache-2.0
/// What the programs of this folder have in common.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tb/output_file.h"
#include "tb/program.h"

namespace blysk::cosim {

/// The body of a main(): bad use or bad input ends it with one line on standard error and status 2.
template <class Body>
int program(Body body) {
  return run_program("blysk", body);
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
/// \throws usage_error if it cannot be written
inline void write_file(const std::string& path, std::string_view text) {
  output_file file(path);
  file.write(text);
  file.commit();
}

}  // namespace blysk::cosim
