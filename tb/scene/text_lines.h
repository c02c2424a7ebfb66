// SPDX-License-Identifier: Apache-2.0
/// Text files of line-based formats: whatever their encoding and line ends.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace blysk::scene {

/// The bytes of a file.
/// \throws usage_error if it cannot be read, or is larger than 4 GiB
std::string read_file(const std::string& path);

/// The text as UTF-8 without a byte order mark; UTF-16 is converted, of either byte order, with a mark or without.
/// \throws usage_error if it holds zeros, as a text does not
std::string decoded(const std::string& path, std::string bytes);

/// Lines of a text: ended by LF, CR LF or CR; a backslash at the end joins the next one; blanks around are left out. What is
/// empty then is passed over. "#" begins a comment; behind a keyword that names something, as "usemtl a#1" and
/// "newmtl Material #25" do, only where a blank or nothing is on either side of it.
class text_lines {
 public:
  explicit text_lines(std::string_view text) : rest_(text) {}

  bool next();
  std::size_t number() const { return number_; }  ///< of the line's first part, from 1

  /// The first word, and what follows it without the blanks between.
  std::string_view keyword() const { return keyword_; }
  std::string_view value() const { return value_; }

 private:
  std::string_view take_part();

  std::string_view rest_;
  std::string joined_;
  std::string_view keyword_, value_;
  std::size_t number_ = 0;
  std::size_t next_number_ = 1;
};

/// Cuts the first word off the text; empty if there is none.
std::string_view take_word(std::string_view& text);

/// A decimal number, whatever the locale: infinite if it is too large for a double, 0 if it is too small.
/// \return  none if the word is no number; "nan" and "inf" are none
std::optional<double> number_of(std::string_view word);

}  // namespace blysk::scene
