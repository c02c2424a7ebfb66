// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/vector_text.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <string_view>
#include <utility>

#include "tb/harness/arguments.h"

namespace blysk::cli {
namespace {

constexpr std::string_view kBegin = "# blysk vectors ";
constexpr int kBitsOfDigit = 4;

/// Takes the next word away; empty at the end.
std::string_view take_word(std::string_view& text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  const std::size_t end = std::min(text.find_first_of(" \t", begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

std::string names_of(const std::vector<port>& ports) {
  std::string names;
  for (const port& each : ports) names += (names.empty() ? "" : " ") + each.column;
  return names;
}

/// The bits of a port's wires as a number, two's complement for a signed one.
std::int64_t signed_value(const wire_format& of, std::uint64_t bits) {
  const int unused = 64 - of.width();
  return of.is_signed ? static_cast<std::int64_t>(bits << unused) >> unused : static_cast<std::int64_t>(bits);
}

/// A code as a file of vectors has it, two's complement: what is said of a signed one has its value too.
std::string digits_of(const port& of, std::int64_t code) {
  const int width = of.width();
  const std::uint64_t mask = width == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
  const std::string digits = fmt::format("{:0{}x}", static_cast<std::uint64_t>(code) & mask, (width + 3) / 4);
  return of.carries->is_signed ? fmt::format("{} ({})", digits, code) : digits;
}

std::string legal_codes(const port& of) {
  const wire_format& legal = *of.carries;
  return fmt::format("{} to {}", digits_of(of, legal.min), digits_of(of, legal.max));
}

}  // namespace

std::vector<port> inputs_of(const std::vector<port>& ports) {
  return of_role(ports, port::role::data);
}

std::vector<port> outputs_of(const std::vector<port>& ports) {
  std::vector<port> outputs = of_role(ports, port::role::result);
  std::erase_if(outputs, [](const port& each) { return each.is_inner; });
  return outputs;
}

std::string header_text(const selection& asked, std::uint64_t count) {
  return fmt::format("{}{}; {} vectors of {}", kBegin, harness::arguments_of(asked), count,
                     names_of(inputs_of(asked.of().ports(asked))));
}

std::optional<vector_header> parse_header(std::string_view line) {
  const std::size_t end = line.find("; ");
  if (!line.starts_with(kBegin) || end == std::string_view::npos) return std::nullopt;
  vector_header header{std::string(line.substr(kBegin.size(), end - kBegin.size())), 0, {}};
  const std::string_view rest = line.substr(end + 2);
  const auto [behind, error] = std::from_chars(rest.data(), rest.data() + rest.size(), header.count);
  constexpr std::string_view kColumns = " vectors of ";
  const std::string_view columns(behind, rest.end());
  if (error != std::errc{} || !columns.starts_with(kColumns)) return std::nullopt;
  header.columns = columns.substr(kColumns.size());
  return header;
}

void append_vectors(fmt::memory_buffer& text, const std::vector<port>& inputs, const columns& rows) {
  const auto to = std::back_inserter(text);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      const int width = inputs[i].width();
      const std::uint64_t wires = ~std::uint64_t{0} >> (64 - width);
      fmt::format_to(to, "{:0{}x}{}", static_cast<std::uint64_t>(rows[i].get(row)) & wires,
                     (width + kBitsOfDigit - 1) / kBitsOfDigit, i + 1 < inputs.size() ? ' ' : '\n');
    }
  }
}

answer_reader::answer_reader(line_reader& lines, const selection& asked)
    : lines_(lines),
      device_(harness::arguments_of(asked)),
      in_(inputs_of(asked.of().ports(asked))),
      out_(outputs_of(asked.of().ports(asked))),
      of_(asked.of()) {}

void answer_reader::read(answers& block, std::size_t most) {
  block.in = columns(in_, port::role::data);
  block.in.resize(most);
  block.out.assign(out_.size(), {});
  block.lines.clear();
  block.vectors.clear();
  while ((block.lines.size() < most || missing_ > 0) && lines_.next(block.lines.empty() || missing_ > 0)) {
    std::string_view text = lines_.text();
    const std::string_view first = take_word(text);
    if (first.empty()) continue;
    if (first.starts_with('#')) {
      read_header();
    } else {
      parse(block);
    }
  }
  if (missing_ > 0)
    throw lines_.error(
        fmt::format("is the end of the answers, expected {} pixels more of its vector", missing_));
  const std::size_t vectors = block.vectors.empty() ? 0 : block.vectors.back() + 1;
  block.in.resize(vectors);
  count_ += vectors;
  if (block.lines.empty()) check_end();
}

void answer_reader::read_header() {
  const std::optional<vector_header> found = parse_header(lines_.text());
  if (!found) {
    // Any other comment may stand there; a header that was cut would hide missing answers.
    if (lines_.text().starts_with(kBegin.substr(0, kBegin.size() - 1)))
      throw lines_.error("is no header, expected what blysk vectors wrote in its first line");
    return;
  }
  if (found->device != device_) {
    throw lines_.error(fmt::format("has vectors of {}, expected those of {}", shown(found->device), device_));
  }
  if (found->columns != names_of(in_)) {
    throw lines_.error(fmt::format("has vectors of {}, expected {}", shown(found->columns), names_of(in_)));
  }
  header_ = found;
}

void answer_reader::check_end() const {
  if (header_ && header_->count != count_) {
    throw lines_.error(
        fmt::format("is the end after {} vectors, expected {} as the header says", count_, header_->count));
  }
  if (count_ == 0) {
    throw file_error(lines_.path(), 0,
                     fmt::format("has no vectors, expected lines of {} {}", names_of(in_), names_of(out_)));
  }
}

/// The row of the line's vector, a new one unless the vector before has pixels to come.
std::size_t answer_reader::vector_of_line(answers& block, const std::vector<std::int64_t>& codes) {
  if (missing_ == 0) {
    const std::size_t row = block.vectors.empty() ? 0 : block.vectors.back() + 1;
    for (std::size_t i = 0; i < codes.size(); ++i) block.in[i].set(row, codes[i]);
    missing_ = of_.pixels(block.in, row) - 1;
    return row;
  }
  const std::size_t row = block.vectors.back();
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (block.in[i].get(row) != codes[i])
      throw lines_.error(
          fmt::format("begins another vector, expected {} pixels more of the one before", missing_));
  }
  --missing_;
  return row;
}

void answer_reader::parse(answers& block) {
  std::string_view text = lines_.text();
  const auto take = [&](const port& of) {
    const std::string_view digits = take_word(text);
    if (digits.empty()) {
      throw lines_.error(
          fmt::format("ends before {}, expected {} {}", of.column, names_of(in_), names_of(out_)));
    }
    return parse_code(of, digits);
  };
  std::vector<std::int64_t> codes;
  for (const port& each : in_) {
    const std::int64_t code = take(each);
    const wire_format& legal = *each.carries;
    if (code < legal.min || code > legal.max) {
      throw lines_.error(
          fmt::format("{} is {}, expected {}", each.column, digits_of(each, code), legal_codes(each)));
    }
    codes.push_back(code);
  }
  for (std::size_t i = 0; i < out_.size(); ++i) {
    // A file that was cut ends within a word.
    const std::string_view before = text;
    block.out[i].push_back(take(out_[i]));
    const auto digits = static_cast<std::size_t>(out_[i].width() + 3) / 4;
    if (!lines_.has_end() && text.empty() &&
        before.size() - (before.find_first_not_of(' ') + text.size()) < digits)
      throw lines_.error(
          fmt::format("ends within {}, expected its {} digits or a line feed", out_[i].column, digits));
  }
  if (const std::string_view more = take_word(text); !more.empty()) {
    throw lines_.error(
        fmt::format("has '{}' at its end, expected {} {}", shown(more), names_of(in_), names_of(out_)));
  }
  block.vectors.push_back(vector_of_line(block, codes));
  block.lines.push_back(lines_.number());
}

std::int64_t answer_reader::parse_code(const port& of, std::string_view digits) const {
  const int width = of.width();
  std::uint64_t bits = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), bits, 16);
  const bool fits = width == 64 || bits >> width == 0;
  if (error != std::errc{} || end != digits.data() + digits.size() || !fits) {
    const bool is_unknown =
        digits.find_first_of("xXzZ", digits.starts_with("0x") || digits.starts_with("0X") ? 2 : 0) !=
        std::string_view::npos;
    throw lines_.error(fmt::format("{} is '{}'{}, expected hexadecimal digits of {} bits", of.column,
                                   shown(digits), is_unknown ? ", unknown" : "", width));
  }
  return signed_value(*of.carries, bits);
}

}  // namespace blysk::cli
