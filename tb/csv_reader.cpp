// SPDX-License-Identifier: Apache-2.0
#include "tb/csv_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace blysk {
namespace {

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

// Fields are a few characters long: the loops here are faster than the searches of the library.
std::string_view trim(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool is_comment(std::string_view trimmed) {
  return trimmed.starts_with('#');
}

/// "sep=;", which spreadsheets read as a note of what separates columns; the header says it anyway.
bool is_note_of_separator(std::string_view line) {
  if (line.size() > 1 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
  constexpr std::string_view kNote = "sep=";
  return line.starts_with(kNote) && line.size() <= kNote.size() + 1;  // a tab was trimmed
}

/// A quoted field, from its quote to the one that ends it.
struct quoted_field {
  std::string_view inside;
  std::size_t size = 0;  ///< of the text, quotes included; 0 if no quote ends it
  bool has_quotes = false;
};

quoted_field read_quoted(std::string_view text) {
  quoted_field field;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] != '"') continue;
    if (i + 1 < text.size() && text[i + 1] == '"') {
      field.has_quotes = true;
      ++i;
    } else {
      field.inside = text.substr(1, i - 1);
      field.size = i + 1;
      break;
    }
  }
  return field;
}

std::string without_doubled_quotes(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    result += text[i];
    if (text[i] == '"') ++i;
  }
  return result;
}

constexpr std::array kSeparators{',', ';', '\t', ' '};

/// Empty fields at the end, beyond `least`: what a comma at the end of a line leaves.
void drop_empty_ends(std::vector<std::string_view>& fields, std::size_t least) {
  while (fields.size() > least && fields.back().empty()) fields.pop_back();
}

}  // namespace

csv_reader::csv_reader(const std::string& path, std::string_view header) : lines_(path, "a CSV file") {
  read_header(header);
}

void csv_reader::read_header(std::string_view header) {
  std::vector<std::string_view> wanted;
  split(header, ',', wanted);
  names_.assign(wanted.begin(), wanted.end());
  bool is_found = false;
  while (lines_.next()) {
    const std::string_view line = trim(text());
    if (lines_.number() == 1 && (line.starts_with("\xFF\xFE") || line.starts_with("\xFE\xFF")))
      throw error("is UTF-16, expected text in UTF-8");
    if (line.empty() || (lines_.number() == 1 && is_note_of_separator(line))) continue;
    if (is_comment(line)) {
      is_found =
          find_columns(trim(line.substr(std::min(line.find_first_not_of('#'), line.size())))) || is_found;
      continue;
    }
    // A table of numbered rows, separated by tabs, begins with an empty name.
    const std::string_view whole = text();
    if (find_columns(whole.starts_with('\t') ? whole : line)) return;
    if (!is_found) {
      const std::string twice = repeated_name(line);
      throw error(fmt::format("header is '{}'{}, expected {}", shown(text()),
                              twice.empty() ? "" : fmt::format(" with column {} twice", twice), header));
    }
    lines_.put_back();  // the first row below a header behind #
    return;
  }
  if (lines_.number() == 0)
    throw file_error(lines_.path(), 1, fmt::format("is empty, expected the header {}", header));
  if (!is_found) throw error(fmt::format("is no header, expected {}", header));
}

// The first of the wanted columns that a line has more than once, by any separator; empty if there is none.
std::string csv_reader::repeated_name(std::string_view line) {
  for (const char separator : kSeparators) {
    std::vector<std::string_view> columns;
    if (!split(line, separator, columns)) continue;
    const auto found = std::ranges::find_if(
        names_, [&](const std::string& name) { return std::ranges::count(columns, name) > 1; });
    if (found != names_.end()) return *found;
  }
  return "";
}

// Takes the line as the header if it is one.
bool csv_reader::find_columns(std::string_view line) {
  for (const char separator : kSeparators) {
    std::vector<std::string_view> columns;
    if (!split(line, separator, columns)) continue;
    drop_empty_ends(columns, 0);
    std::vector<std::size_t> places;
    for (const std::string& name : names_) {
      if (std::count(columns.begin(), columns.end(), name) != 1) break;
      places.push_back(
          static_cast<std::size_t>(std::find(columns.begin(), columns.end(), name) - columns.begin()));
    }
    if (places.size() != names_.size()) continue;
    separator_ = separator;
    places_ = std::move(places);
    all_names_.assign(columns.begin(), columns.end());
    is_plain_ = separator == ',' && all_names_ == names_;
    return true;
  }
  return false;
}

bool csv_reader::next() {
  return next_row(true);
}

bool csv_reader::next_at_hand() {
  return next_row(false);
}

bool csv_reader::next_row(bool may_wait) {
  for (;;) {
    if (!lines_.next(may_wait)) return false;
    const std::string_view line = trim(text());
    const bool is_empty =
        std::ranges::all_of(line, [this](char c) { return c == separator_ || is_blank(c); });
    if (!is_empty && !is_comment(line)) break;
  }
  fields_.clear();
  return true;
}

const std::vector<std::string_view>& csv_reader::fields() {
  if (!fields_.empty()) return fields_;
  if (!split(text(), separator_, all_fields_)) {
    throw error(
        fmt::format("row '{}' has a quote out of place, expected fields such as 1 or \"1\"", shown(text())));
  }
  drop_empty_ends(all_fields_, all_names_.size());
  if (all_fields_.size() != all_names_.size()) {
    throw error(fmt::format("row has {} fields, expected {}: {}", all_fields_.size(), all_names_.size(),
                            shown(fmt::format("{}", fmt::join(all_names_, ",")))));
  }
  for (const std::size_t place : places_) fields_.push_back(all_fields_[place]);
  return fields_;
}

// False if a quote has no end, or text behind it.
bool csv_reader::split(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  const bool by_blanks = separator == ' ';
  const auto ends = [=](char c) { return by_blanks ? is_blank(c) : c == separator; };
  const auto skips = [=](char c) { return !by_blanks && is_blank(c) && c != separator; };
  if (by_blanks) line = trim(line);
  unescaped_.clear();
  fields.clear();
  std::size_t at = 0;
  for (;;) {
    while (at < line.size() && skips(line[at])) ++at;
    if (at < line.size() && line[at] == '"') {
      const quoted_field field = read_quoted(line.substr(at));
      if (field.size == 0) return false;
      fields.push_back(field.has_quotes ? unescaped_.emplace_back(without_doubled_quotes(field.inside))
                                        : trim(field.inside));
      at += field.size;
      while (at < line.size() && skips(line[at])) ++at;
      if (at < line.size() && !ends(line[at])) return false;
    } else {
      const std::size_t begin = at;
      while (at < line.size() && !ends(line[at])) ++at;
      fields.push_back(trim(line.substr(begin, at - begin)));
    }
    if (at == line.size()) return true;
    ++at;
    while (by_blanks && is_blank(line[at])) ++at;  // the line's last character is none
  }
}

usage_error csv_reader::error(std::size_t column, std::string_view expected) const {
  return error(fmt::format("{} is '{}', expected {}", names_[column], shown(fields_[column]), expected));
}

usage_error csv_reader::error(std::string_view what) const {
  return lines_.error(what);
}

}  // namespace blysk
