// SPDX-License-Identifier: Apache-2.0
#include "tb/cost/figures.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "tb/cost/table.h"
#include "tb/usage_error.h"

namespace blysk::cost {
namespace {

/// The numbers of a text, as they are written there.
std::vector<std::string> numbers_in(const std::string& text) {
  static const std::regex number("(^|[^0-9A-Za-z.])([0-9]+([.][0-9]+)?)(?![0-9A-Za-z])");
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), number), end; at != end; ++at)
    found.push_back((*at)[2].str());
  return found;
}

/// The place of the last digit that a number holds, as a power of ten: all of 0.28 and 4635, 5600 is rounded to hundreds.
/// Two digits it holds at least.
double last_place(const std::string& number) {
  const std::size_t point = number.find('.');
  if (point != std::string::npos) return std::pow(10.0, -static_cast<double>(number.size() - point - 1));
  const std::size_t zeros = number.size() - 1 - std::min(number.find_last_not_of('0'), number.size() - 1);
  return std::pow(10.0, static_cast<double>(std::min(zeros, std::max<std::size_t>(number.size(), 2) - 2)));
}

bool is_written(double value, const std::vector<std::string>& numbers) {
  return std::ranges::any_of(numbers, [value](const std::string& each) {
    constexpr double kHalf = 0.5 + 1e-9;  // a half is rounded either way
    return std::abs(std::stod(each) - value) <= kHalf * last_place(each);
  });
}

double value_of(const std::string& device, const std::vector<std::string>& words,
                const std::vector<configuration>& all) {
  const auto found = std::ranges::find_if(all, [&](const configuration& each) {
    return each.asked.of().name() == device && each.asked.format() == words[1] && each.asked.is_preset();
  });
  if (found == all.end()) throw std::invalid_argument("was not measured");
  const std::array domains{words.size() == 4 ? find_domain(words[3]) : domain::lobe};
  const nlohmann::ordered_json row = json_rows({*found}, domains).front();
  const auto column = row.find(words[2]);
  if (column == row.end() || !column->is_number())
    throw std::invalid_argument("is no number that was measured");
  return column->get<double>();
}

double value_of(const std::vector<std::string>& words, const std::vector<configuration>& all) {
  const std::size_t slash = words[0].find('/');
  const double value = value_of(words[0].substr(0, slash), words, all);
  return slash == std::string::npos ? value : value / value_of(words[0].substr(slash + 1), words, all);
}

}  // namespace

void check_figures(const std::string& path, std::size_t line, const std::string& quoted,
                   const std::string& paragraph, const std::vector<configuration>& all) {
  const std::vector<std::string> numbers = numbers_in(paragraph);
  std::istringstream parts(quoted);
  for (std::string part; std::getline(parts, part, ',');) {
    std::istringstream text(part);
    const std::vector<std::string> words{std::istream_iterator<std::string>(text), {}};
    if (words.size() < 3 || words.size() > 4)
      throw file_error(path, line,
                       fmt::format("'{}' is no figure, expected DEVICE FORMAT COLUMN [DOMAIN]", part));
    const std::string name = fmt::format("{}", fmt::join(words, " "));
    double value = 0;
    try {
      value = value_of(words, all);
    } catch (const std::invalid_argument& error) {
      throw file_error(path, line, fmt::format("{}: {}", name, error.what()));
    }
    if (!is_written(value, numbers))
      throw file_error(path, line, fmt::format("the paragraph does not have {}, expected {}", name, value));
  }
}

}  // namespace blysk::cost
