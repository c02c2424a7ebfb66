// SPDX-License-Identifier: Apache-2.0
/// Symbolic value: a block's law run on it writes down what the law computes.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace blysk::netlist {

__extension__ typedef __int128 wide_int;  // NOLINT(modernize-use-using): __extension__ takes no alias

enum class operation {
  constant,
  parameter,  ///< constant of an instance
  signal,     ///< port, or wire within a block
  add,
  subtract,
  multiply,
  complement,  ///< ~a
  shift_left,
  shift_right,  ///< arithmetic
  less,
  equal,
  logical_and,
  logical_or,
  logical_not,
  bit_and,
  bit_or,
  bit_xor,
  select,  ///< a ? b : c
  lookup   ///< table[a]
};

/// One step of a law, with the ends of the interval that its exact value lies in.
struct node {
  operation op;
  std::vector<std::shared_ptr<const node>> operands;
  wide_int low;
  wide_int high;
  std::string name = {};  ///< of a signal or parameter
  int distance = 0;       ///< of a shift
  int depth = 0;          ///< an operand's is below its user's
  std::vector<std::int64_t> table = {};

  bool is_signed() const { return low < 0; }

  /// Bits of the two's complement, or of the unsigned number if no value is negative, that hold the interval.
  int width() const;
};

/// Integer of unlimited range as far as the law is concerned; at most 120 bits here.
/// The operators are those of a C++ integer; comparisons and logic give 0 or 1.
/// \throws std::overflow_error from every operation whose result could need more than 120 bits
class expression {
 public:
  explicit expression(std::int64_t value);
  explicit expression(std::shared_ptr<const node> root) : root_(std::move(root)) {}

  static expression signal(const std::string& name, int width, bool is_signed);
  static expression parameter(const std::string& name);

  const std::shared_ptr<const node>& root() const { return root_; }

 private:
  std::shared_ptr<const node> root_;
};

expression operator+(const expression& a, const expression& b);
expression operator-(const expression& a, const expression& b);
expression operator*(const expression& a, const expression& b);
expression operator~(const expression& a);
expression operator<<(const expression& a, int distance);
expression operator>>(const expression& a, int distance);
expression operator<(const expression& a, const expression& b);
expression operator==(const expression& a, const expression& b);
expression operator&&(const expression& a, const expression& b);
expression operator||(const expression& a, const expression& b);
expression operator!(const expression& a);
expression operator&(const expression& a, const expression& b);
expression operator|(const expression& a, const expression& b);
expression operator^(const expression& a, const expression& b);

inline expression operator-(const expression& a) {
  return expression{0} - a;
}
inline expression operator>(const expression& a, const expression& b) {
  return b < a;
}
inline expression operator<=(const expression& a, const expression& b) {
  return !(b < a);
}
inline expression operator>=(const expression& a, const expression& b) {
  return !(a < b);
}
inline expression operator!=(const expression& a, const expression& b) {
  return !(a == b);
}

/// condition ? a : b, found by the laws beside blysk::law::select.
expression select(const expression& condition, const expression& a, const expression& b);

/// table[index], 0 beyond its end, found by the laws beside blysk::law::lookup.
/// \throws std::domain_error for an index that may be negative
expression lookup(std::vector<std::int64_t> table, const expression& index);
template <std::size_t Words>
expression lookup(const std::array<std::int64_t, Words>& table, const expression& index) {
  return lookup(std::vector<std::int64_t>(table.begin(), table.end()), index);
}
/// The same of the table's first `words` words.
template <std::size_t Most>
expression lookup(const std::array<std::int64_t, Most>& table, std::size_t words, const expression& index) {
  return lookup(std::vector<std::int64_t>(table.begin(), table.begin() + static_cast<std::ptrdiff_t>(words)),
                index);
}

}  // namespace blysk::netlist
