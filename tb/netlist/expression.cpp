// SPDX-License-Identifier: Apache-2.0
#include "tb/netlist/expression.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace blysk::netlist {
namespace {

constexpr int kMaxWidth = 120;

int unsigned_width(wide_int value) {
  int width = 0;
  for (; value != 0; value >>= 1) ++width;
  return width;
}

expression make(operation op, std::initializer_list<expression> operands, wide_int low, wide_int high,
                int distance = 0, std::vector<std::int64_t> table = {}) {
  auto made = std::make_shared<node>(node{
      .op = op, .operands = {}, .low = low, .high = high, .distance = distance, .table = std::move(table)});
  for (const expression& operand : operands) {
    made->operands.push_back(operand.root());
    made->depth = std::max(made->depth, operand.root()->depth + 1);
  }
  if (made->width() > kMaxWidth) throw std::overflow_error("a law computes with more than 120 bits");
  return expression(std::move(made));
}

// Constants are folded, so that T{1} << k is one number in the text.
bool is_constant(const expression& a) {
  return a.root()->op == operation::constant;
}

bool is_zero(const expression& a) {
  return is_constant(a) && a.root()->low == 0;
}

expression make_constant(wide_int value) {
  return make(operation::constant, {}, value, value);
}

expression truth(const expression& a) {
  const node& root = *a.root();
  return root.low == 0 && root.high <= 1 ? a : !(a == expression{0});
}

// Ones only come in with |: it is no less than either operand, unless that one alone is not negative.
std::pair<wide_int, wide_int> or_interval(wide_int a_low, wide_int a_high, wide_int b_low, wide_int b_high) {
  const bool is_negative = a_high < 0 || b_high < 0;
  const bool have_one_sign = (a_low >= 0 && b_low >= 0) || (a_high < 0 && b_high < 0);
  const wide_int ones = (wide_int{1} << unsigned_width(std::max({a_high, b_high, wide_int{0}}))) - 1;
  return {have_one_sign ? std::max(a_low, b_low) : std::min(a_low, b_low), is_negative ? -1 : ones};
}

}  // namespace

int node::width() const {
  if (!is_signed()) return std::max(1, unsigned_width(high));
  return 1 + std::max(unsigned_width(~low), high < 0 ? 0 : unsigned_width(high));
}

expression::expression(std::int64_t value) : expression(make_constant(value)) {}

expression expression::signal(const std::string& name, int width, bool is_signed) {
  const wide_int span = wide_int{1} << (is_signed ? width - 1 : width);
  return expression(std::make_shared<node>(node{.op = operation::signal,
                                                .operands = {},
                                                .low = is_signed ? -span : 0,
                                                .high = span - 1,
                                                .name = name}));
}

expression expression::parameter(const std::string& name) {
  const wide_int span = wide_int{1} << 63;
  return expression(std::make_shared<node>(
      node{.op = operation::parameter, .operands = {}, .low = -span, .high = span - 1, .name = name}));
}

expression operator+(const expression& a, const expression& b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  return make(operation::add, {a, b}, a.root()->low + b.root()->low, a.root()->high + b.root()->high);
}

expression operator-(const expression& a, const expression& b) {
  return make(operation::subtract, {a, b}, a.root()->low - b.root()->high, a.root()->high - b.root()->low);
}

expression operator*(const expression& a, const expression& b) {
  const node& x = *a.root();
  const node& y = *b.root();
  if (x.width() + y.width() > kMaxWidth) throw std::overflow_error("a law multiplies more than 120 bits");
  const auto [low, high] = std::minmax({x.low * y.low, x.low * y.high, x.high * y.low, x.high * y.high});
  return make(operation::multiply, {a, b}, low, high);
}

expression operator~(const expression& a) {
  return make(operation::complement, {a}, ~a.root()->high, ~a.root()->low);
}

expression operator<<(const expression& a, int distance) {
  const node& x = *a.root();
  if (distance == 0) return a;
  if (x.width() + distance > kMaxWidth) throw std::overflow_error("a law shifts beyond 120 bits");
  const wide_int scale = wide_int{1} << distance;
  if (is_constant(a)) return make_constant(x.low * scale);
  return make(operation::shift_left, {a}, x.low * scale, x.high * scale, distance);
}

expression operator>>(const expression& a, int distance) {
  const node& x = *a.root();
  if (distance == 0) return a;
  if (is_constant(a)) return make_constant(x.low >> distance);
  if (distance >= x.width()) return x.is_signed() ? a >> (x.width() - 1) : expression{0};
  return make(operation::shift_right, {a}, x.low >> distance, x.high >> distance, distance);
}

expression operator<(const expression& a, const expression& b) {
  return make(operation::less, {a, b}, 0, 1);
}

expression operator==(const expression& a, const expression& b) {
  return make(operation::equal, {a, b}, 0, 1);
}

expression operator&&(const expression& a, const expression& b) {
  return make(operation::logical_and, {truth(a), truth(b)}, 0, 1);
}

expression operator||(const expression& a, const expression& b) {
  return make(operation::logical_or, {truth(a), truth(b)}, 0, 1);
}

expression operator!(const expression& a) {
  return make(operation::logical_not, {truth(a)}, 0, 1);
}

expression operator&(const expression& a, const expression& b) {
  const node& x = *a.root();
  const node& y = *b.root();
  const auto [low, high] = or_interval(~x.high, ~x.low, ~y.high, ~y.low);  // a & b = ~(~a | ~b)
  // What is not negative bounds the result, whatever the sign of the other.
  wide_int least = ~high;
  wide_int most = ~low;
  for (const node* each : {&x, &y}) {
    if (each->low < 0) continue;
    least = std::max(least, wide_int{0});
    most = std::min(most, each->high);
  }
  return make(operation::bit_and, {a, b}, least, most);
}

expression operator|(const expression& a, const expression& b) {
  if (is_zero(a)) return b;
  if (is_zero(b)) return a;
  const node& x = *a.root();
  const node& y = *b.root();
  const auto [low, high] = or_interval(x.low, x.high, y.low, y.high);
  return make(operation::bit_or, {a, b}, low, high);
}

expression operator^(const expression& a, const expression& b) {
  const node& x = *a.root();
  const node& y = *b.root();
  const bool is_signed = x.is_signed() || y.is_signed();
  const auto magnitude = [](const node& n) {
    return std::max(unsigned_width(n.is_signed() ? ~n.low : 0), n.high < 0 ? 0 : unsigned_width(n.high));
  };
  const wide_int span = wide_int{1} << std::max(magnitude(x), magnitude(y));
  return make(operation::bit_xor, {a, b}, is_signed ? -span : 0, span - 1);
}

expression select(const expression& condition, const expression& a, const expression& b) {
  return make(operation::select, {truth(condition), a, b}, std::min(a.root()->low, b.root()->low),
              std::max(a.root()->high, b.root()->high));
}

expression lookup(std::vector<std::int64_t> table, const expression& index) {
  if (index.root()->is_signed())
    throw std::domain_error("a law looks up a table at an index that may be negative");
  auto [low, high] = std::ranges::minmax(table);
  if (index.root()->high >= static_cast<wide_int>(table.size())) {
    low = std::min<std::int64_t>(low, 0);
    high = std::max<std::int64_t>(high, 0);
  }
  return make(operation::lookup, {index}, low, high, 0, std::move(table));
}

}  // namespace blysk::netlist
