// SPDX-License-Identifier: Apache-2.0
/// What a program says of bad use and bad input.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace blysk {

/// The text as one line of printable UTF-8. Escaped are control characters, what separates lines, what changes the
/// direction of writing or cannot be seen, and bytes that are no UTF-8: \x1B for a byte, \u202E for a character.
std::string printable(std::string_view text);

/// Bad use or bad input: the program prints "NAME: what()" and exits with status 2.
class usage_error : public std::runtime_error {
 public:
  /// \param what  made printable: a zero byte in it would end what()
  explicit usage_error(std::string_view what) : std::runtime_error(printable(what)) {}
};

/// "FILE:LINE: what is wrong, what was expected"; "FILE: ..." if the line is 0, for the file as a whole.
usage_error file_error(const std::string& path, std::size_t line, std::string_view what);

/// What the operating system says of the current errno, for the end of a message.
std::string system_reason();

}  // namespace blysk
