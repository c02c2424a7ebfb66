// SPDX-License-Identifier: Apache-2.0
/// The device that a test is run for, from the environment: BLYSK_DEVICE, BLYSK_FORMAT, and BLYSK_OPTIONS, a line such as
/// those of tb/devices/<identifier>/variants. tb/devices/test/device_tests.cmake sets them.
#pragma once

#include <cstdlib>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>

#include "tb/device.h"

namespace blysk::test {

/// A variable of the environment.
/// \throws std::runtime_error if it is not set
inline std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  if (value == nullptr) throw std::runtime_error(std::string(name) + " is not set: run this case by ctest");
  return value;
}

/// "--coefficient published --as-published" by name, a flag as "on".
inline std::map<std::string, std::string> options_of(const std::string& line) {
  std::map<std::string, std::string> options;
  std::istringstream words(line);
  std::string name;
  for (std::string word; words >> word;) {
    if (word.starts_with("--")) {
      name = word.substr(2);
      options[name] = "on";
    } else {
      options.at(name) = word;
    }
  }
  return options;
}

/// \throws std::invalid_argument as choose() does
inline selection asked_for(purpose is_for = purpose::hardware) {
  return choose(variable("BLYSK_DEVICE"), variable("BLYSK_FORMAT"), options_of(variable("BLYSK_OPTIONS")),
                is_for);
}

/// One line that holds the words.
inline bool is_line_with(const std::string& message, const std::string& words) {
  return message.find(words) != std::string::npos && message.find('\n') == std::string::npos;
}

}  // namespace blysk::test
