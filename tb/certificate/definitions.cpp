// SPDX-License-Identifier: Apache-2.0
#include "tb/certificate/definitions.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

namespace blysk {
namespace {

/// An expression from left to right.
class expression_reader {
 public:
  expression_reader(const std::string& text, const named_numbers& known) : text_(text), known_(known) {}

  long double whole() {
    const long double value = sum();
    skip_blanks();
    if (at_ != text_.size()) fail();
    return value;
  }

 private:
  [[noreturn]] void fail() const { throw std::logic_error("no expression: " + text_); }

  void skip_blanks() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
  }

  bool takes(char wanted) {
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }

  std::string word(int (*belongs)(int)) {
    std::string found;
    while (at_ < text_.size() && (belongs(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_'))
      found += text_[at_++];
    if (found.empty()) fail();
    return found;
  }

  int integer() {
    const bool is_negative = takes('-');
    const int value = std::stoi(word(std::isdigit));
    return is_negative ? -value : value;
  }

  long double sum() {
    long double value = product();
    while (true) {
      if (takes('+')) {
        value += product();
      } else if (takes('-')) {
        value -= product();
      } else {
        return value;
      }
    }
  }

  long double product() {
    long double value = factor();
    while (true) {
      if (takes('*')) {
        value *= factor();
      } else if (takes('/')) {
        value /= factor();
      } else {
        return value;
      }
    }
  }

  long double in_brackets() {
    const long double value = sum();
    if (!takes(')')) fail();
    return value;
  }

  long double factor() {
    if (takes('-')) return -factor();
    if (takes('(')) return in_brackets();
    skip_blanks();
    if (at_ == text_.size()) fail();
    if (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) {
      const long double value = std::stold(word(std::isdigit));
      return takes('b') ? std::ldexp(value, integer()) : value;
    }
    const std::string name = word(std::isalnum);
    if (name == "int") return floored(0);
    if (name != "fixed") {
      const auto found = known_.find(name);
      if (found == known_.end()) fail();
      return found->second;
    }
    if (!takes('<')) fail();
    const int place = integer();
    if (!takes(',')) fail();
    return floored(place, "dn>(");
  }

  /// What stands in brackets, rounded down.
  long double floored(int place, const char* before = "<dn>(") {
    for (; *before != 0; ++before) {
      if (!takes(*before)) fail();
    }
    return std::ldexp(std::floor(std::ldexp(in_brackets(), -place)), place);
  }

  const std::string& text_;
  const named_numbers& known_;
  std::size_t at_ = 0;
};

long double value_of(const std::string& text, const named_numbers& known) {
  return expression_reader(text, known).whole();
}

/// "brdf_1 >= 0b-8"
bool holds(const std::string& condition, const named_numbers& known) {
  const std::size_t sign = condition.find_first_of("<>");
  if (sign == std::string::npos) throw std::logic_error("no condition: " + condition);
  const long double left = value_of(condition.substr(0, sign), known);
  const long double right = value_of(condition.substr(sign + 2), known);
  return condition[sign] == '<' ? left <= right : left >= right;
}

}  // namespace

std::optional<long double> compute(const netlist::gappa_netlist& of, const named_numbers& given,
                                   const std::string& result) {
  std::optional<long double> found;
  for (const netlist::gappa_path& path : of.paths) {
    named_numbers known = given;
    const auto add_nets = [&] {
      for (const netlist::normalised_net& each : of.normalised) {
        if (known.contains(each.net + "_any") || !known.contains(each.from)) continue;
        // from = mantissa 2^(-zeros - 1); 1 has the mantissa 2, and 0 none.
        const auto code = static_cast<std::int64_t>(std::ldexp(known.at(each.from), each.frac));
        std::int64_t zeros = 0;
        while (code != 0 && zeros + 1 < each.frac && code >> (each.frac - 1 - zeros) == 0) ++zeros;
        const std::int64_t mantissa = code >> each.frac != 0 ? code : code << zeros;
        known[each.net + "_any"] = static_cast<long double>(each.is_mantissa ? mantissa : zeros);
      }
      for (const netlist::memory_net& memory : of.memories) {
        if (known.contains(memory.net) || !known.contains(memory.index)) continue;
        const auto address = static_cast<std::size_t>(known.at(memory.index));
        // On a way that is not taken an address may lie beyond the words.
        const std::int64_t word = address < memory.words.size() ? memory.words[address] : 0;
        known[memory.net] = std::ldexp(static_cast<long double>(word), -memory.frac);
      }
    };
    for (const std::string& line : path.definitions) {
      const std::size_t sign = line.find(" = ");
      if (sign == std::string::npos || !line.ends_with(';')) throw std::logic_error("no definition: " + line);
      const std::string name = line.substr(0, sign);
      if (!known.contains(name)) known[name] = value_of(line.substr(sign + 3, line.size() - sign - 4), known);
      add_nets();
    }
    if (!std::ranges::all_of(path.conditions, [&](const std::string& each) { return holds(each, known); }))
      continue;
    if (found) throw std::logic_error("the conditions of two paths hold");
    found = known.at(result);
  }
  return found;
}

}  // namespace blysk
