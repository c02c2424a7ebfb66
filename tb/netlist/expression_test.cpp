// SPDX-License-Identifier: Apache-2.0
// What the widths of exported wires rest on, and what the exporter refuses.
#include "tb/netlist/expression.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "tb/catch.h"
#include "tb/export/block_text.h"
#include "tb/netlist/block.h"

using namespace blysk::netlist;
using blysk::verilog::block_text;

namespace {

struct operand {
  expression symbol;
  int low, high;
};

operand make_operand(const std::string& name, int width, bool is_signed) {
  const int codes = 1 << width;
  return {expression::signal(name, width, is_signed), is_signed ? -codes / 2 : 0,
          is_signed ? codes / 2 - 1 : codes - 1};
}

struct binary {
  const char* name;
  std::function<expression(const expression&, const expression&)> symbolic;
  std::function<int(int, int)> concrete;
};

}  // namespace

TEST_CASE("the interval of an operation is that of its values", "[export]") {
  const binary operations[] = {
      {"+", [](auto a, auto b) { return a + b; }, std::plus<>{}},
      {"-", [](auto a, auto b) { return a - b; }, std::minus<>{}},
      {"*", [](auto a, auto b) { return a * b; }, std::multiplies<>{}},
      {"~", [](auto a, auto) { return ~a; }, [](int a, int) { return ~a; }},
      {"<< 2", [](auto a, auto) { return a << 2; }, [](int a, int) { return a * 4; }},
      {">> 2", [](auto a, auto) { return a >> 2; }, [](int a, int) { return a >> 2; }},
      {"&", [](auto a, auto b) { return a & b; }, std::bit_and<>{}},
      {"|", [](auto a, auto b) { return a | b; }, std::bit_or<>{}},
      {"^", [](auto a, auto b) { return a ^ b; }, std::bit_xor<>{}},
      {"& of complements", [](auto a, auto b) { return ~a & ~b; }, [](int a, int b) { return ~a & ~b; }},
      {"| of complements", [](auto a, auto b) { return ~a | ~b; }, [](int a, int b) { return ~a | ~b; }},
      {"lookup",
       [](auto a, auto) {
         return lookup({3, -2, 9}, a & expression(3));
       },
       [](int a, int) {
         return std::array{3, -2, 9, 0}[static_cast<std::size_t>(a & 3)];
       }},
      {"<", [](auto a, auto b) { return a < b; }, std::less<>{}},
      {"==", [](auto a, auto b) { return a == b; }, std::equal_to<>{}},
  };
  for (const binary& each : operations) {
    for (const int signs : {0, 1, 2, 3}) {
      const operand a = make_operand("a", 4, (signs & 1) != 0);
      const operand b = make_operand("b", 3, (signs & 2) != 0);
      int low = std::numeric_limits<int>::max();
      int high = std::numeric_limits<int>::min();
      for (int x = a.low; x <= a.high; ++x) {
        for (int y = b.low; y <= b.high; ++y) {
          low = std::min(low, each.concrete(x, y));
          high = std::max(high, each.concrete(x, y));
        }
      }
      CAPTURE(each.name, signs);
      const auto root = each.symbolic(a.symbol, b.symbol).root();
      CHECK(static_cast<int>(root->low) == low);
      CHECK(static_cast<int>(root->high) == high);
    }
  }
}

TEST_CASE("a node is as wide as its interval needs", "[export]") {
  const auto width_of = [](std::int64_t low_and_high) { return expression(low_and_high).root()->width(); };
  CHECK(width_of(0) == 1);
  CHECK(width_of(1) == 1);
  CHECK(width_of(255) == 8);
  CHECK(width_of(256) == 9);
  CHECK(width_of(-1) == 1);
  CHECK(width_of(-128) == 8);
  CHECK(width_of(-129) == 9);
  const auto mixed = select(expression::signal("s", 1, false), expression(-1), expression(4)).root();
  CHECK(mixed->width() == 4);  // -8..7 holds -1 and 4
}

TEST_CASE("what needs more than 120 bits is refused", "[export]") {
  const expression wide = expression::signal("a", 63, false);
  CHECK_THROWS_AS(wide * wide, std::overflow_error);
  CHECK_NOTHROW(wide * expression::signal("b", 57, false));
}

namespace {

struct half_described : sc_core::sc_module {
  sc_core::sc_in<bool> a_i{"a_i"};
  sc_core::sc_in<bool> b_i{"b_i"};
  sc_core::sc_out<bool> y_o{"y_o"};
  explicit half_described(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {}

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("half", "Half described.");
    reader.drive(y_o, !reader.read(a_i));
  }
};

}  // namespace

TEST_CASE("a table is not read before its start", "[export]") {
  CHECK_THROWS_AS(lookup({1, 2}, expression::signal("a", 2, true)), std::domain_error);
}

TEST_CASE("a port that the description leaves out is refused", "[export]") {
  const half_described module("module");
  block reader;
  module.describe(reader);
  CHECK_THROWS_AS(block_text(reader, "half", "half described", {"a_i", "b_i", "y_o"}), std::logic_error);
  const std::string text = block_text(reader, "half", "half described", {"a_i", "y_o"});
  CHECK(text.find("module half (") != std::string::npos);
  CHECK(text.find("assign y_o = !a_i;") != std::string::npos);
}
