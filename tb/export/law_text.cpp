// SPDX-License-Identifier: Apache-2.0
#include "tb/export/law_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tb/export/lexis.h"

namespace blysk::verilog {
namespace {

using netlist::assignment;
using netlist::declaration;
using netlist::expression;
using netlist::flip_flops;
using netlist::node;
using netlist::operation;

const char* word_for(operation op) {
  switch (op) {
    case operation::add:
      return "sum";
    case operation::subtract:
      return "difference";
    case operation::multiply:
      return "product";
    case operation::shift_left:
    case operation::shift_right:
      return "shifted";
    case operation::bit_and:
    case operation::bit_or:
    case operation::bit_xor:
      return "bits";
    case operation::select:
      return "selected";
    case operation::lookup:
      return "word";
    default:
      return "flag";
  }
}

bool is_name(const node& n) {
  return n.op == operation::signal || n.op == operation::parameter;
}

/// Writes the laws down at the widths that they need.
///
/// A result is wanted at some width only, and all operators but comparisons and right shifts find the low w bits of
/// a result from the low w bits of their operands. So widths are handed down from the results, and every operand is
/// cut or extended to what its operator needs: the text has no implicit extension and no mixed signs, but in products.
///
/// The factors of a product keep their own widths and signs, since synthesis tools take the size of a multiplier from
/// them: a product is the whole of an assignment, whose width it takes.
class law_writer {
 public:
  explicit law_writer(const netlist::block& part) {
    for (const declaration& name : part.declarations()) taken_.insert(name.name);
    for (const assignment& drive : part.drives()) {
      const node& root = *drive.value.root();
      want(root, part.declarations()[drive.target].bits.width);
      if (part.declarations()[drive.target].bits.width <= root.width()) assigned_.insert(&root);
    }
    for (const flip_flops& flops : part.registers()) {
      for (const expression* bit : {&flops.clk, &flops.rst_n, &flops.enable}) want(*bit->root(), 1);
      want(*flops.d.root(), part.declarations()[flops.q].bits.width);
    }
    hand_down_widths();
    for (const assignment& drive : part.drives()) assign(part.declarations()[drive.target], drive.value);
    for (const flip_flops& flops : part.registers()) clocked(part.declarations()[flops.q], flops);
  }

  int parameter_width(const std::string& name) const {
    for (const auto& [n, wanted] : uses_) {
      if (n->op == operation::parameter && n->name == name) return wanted.width;
    }
    throw std::logic_error("parameter " + name + " is not used");
  }

  /// Wires, each followed by those of its bits that nothing reads, then the statements.
  std::string text(std::vector<declaration> declarations) {
    std::ranges::sort(declarations, {},
                      &declaration::name);  // compilers differ in the order of a law's arguments
    std::string result;
    for (const declaration& name : declarations) {
      if (name.where == declaration::role::wire) {
        result +=
            "  " + declaration_text(name) + ";" + comment(name.carries ? name.carries->note() : "") + "\n";
      }
      if (name.where != declaration::role::output) result += unused(name.name, name.bits.width);
    }
    for (const wire& each : wires_) {
      result += fmt::format("  wire {}{} = {};\n", range_text(each.width), each.name, each.value);
      result += unused(each.name, each.width);
    }
    return functions_ + result + (result.empty() ? "" : "\n") + statements_;
  }

 private:
  struct use {
    int width = 0;           // that the most demanding user wants
    int count = 0;           // of users
    bool is_sliced = false;  // a user wants other than its low bits
    bool is_factor = false;  // a user is a product
  };
  struct wire {
    std::string name;
    int width;
    std::string value;
  };

  static int own_width(const node& n, const use& wanted) {
    return n.op == operation::parameter ? wanted.width : std::min(wanted.width, n.width());
  }

  int own_width(const node& n) const { return own_width(n, uses_.at(&n)); }

  void want(const node& n, int width, bool is_sliced = false) {
    use& wanted = uses_[&n];
    wanted.width = std::max(wanted.width, width);
    wanted.is_sliced |= is_sliced;
    if (++wanted.count == 1) order_.insert({n.depth, &n});
  }

  // Users come before their operands: an operand is wanted by users of greater depth alone.
  void hand_down_widths() {
    while (!order_.empty()) {
      const node& n = *std::prev(order_.end())->second;
      order_.erase(std::prev(order_.end()));
      for (std::size_t i = 0; i < n.operands.size(); ++i) {
        const int width = operand_width(n, i);
        if (width > 0) want(*n.operands[i], width, n.op == operation::shift_right || threshold_of(n) >= 0);
        if (width > 0 && n.op == operation::multiply) uses_[n.operands[i].get()].is_factor = true;
      }
    }
  }

  int operand_width(const node& n, std::size_t index) const {
    switch (n.op) {
      case operation::shift_left:
        return own_width(n) - n.distance;
      case operation::shift_right:
        return own_width(n) + n.distance;
      case operation::less:
      case operation::equal:
        return compared_width(*n.operands[0], *n.operands[1]);
      case operation::logical_and:
      case operation::logical_or:
      case operation::logical_not:
        return 1;
      case operation::select:
        return index == 0 ? 1 : own_width(n);
      case operation::lookup:
        return n.operands[0]->width();
      default:
        return own_width(n);
    }
  }

  static bool are_signed(const node& a, const node& b) { return a.is_signed() || b.is_signed(); }

  static int compared_width(const node& a, const node& b) {
    const auto width = [&](const node& n) {
      return n.width() + (are_signed(a, b) && !n.is_signed() ? 1 : 0);
    };
    return std::max(width(a), width(b));
  }

  // A wire is needed where Verilog takes bits out of names alone, where two users share a result, for a product inside of
  // an expression, and for a mask that is a factor, since Verilog would widen its operands to the product's width.
  bool needs_wire(const node& n) const {
    if (n.op == operation::constant || is_name(n)) return false;
    if (n.op == operation::multiply && !assigned_.contains(&n)) return true;
    const use& wanted = uses_.at(&n);
    if (n.op == operation::bit_and && wanted.is_factor) return true;
    return wanted.count > 1 || wanted.is_sliced || (n.is_signed() && wanted.width > n.width());
  }

  std::string name_of(const node& n) {
    if (is_name(n)) return n.name;
    const auto known = names_.find(&n);
    if (known != names_.end()) return known->second;
    const phrase value = compute(n);  // first, so that the operands' wires are declared before
    const std::string name = new_name(word_for(n.op));
    wires_.push_back({name, own_width(n), value.text});
    return names_[&n] = name;
  }

  std::string new_name(const std::string& base) {
    std::string name = base;
    for (int i = 2; !taken_.insert(name).second; ++i) name = base + std::to_string(i);
    return name;
  }

  /// The low `width` bits of n.
  phrase bits(const node& n, int width) {
    if (n.op == operation::constant) return {literal(n.low, width)};
    const int own = own_width(n);
    if (is_name(n) || needs_wire(n)) return named_bits(n, name_of(n), own, width);
    const phrase value = compute(n);
    return width > own ? concatenate({fmt::format("{}'b0", width - own)}, value) : value;
  }

  phrase named_bits(const node& n, const std::string& name, int own, int width) {
    const int whole = is_name(n) && n.op == operation::signal ? n.width() : own;
    const int low_bits = std::min(width, whole);
    mark_read(name, low_bits - 1, 0);
    const std::string low = slice(name, whole, low_bits - 1, 0);
    const int missing = width - low_bits;
    if (missing == 0) return {low};
    if (!n.is_signed()) return concatenate({fmt::format("{}'b0", missing)}, {low});
    const std::string sign = slice(name, whole, whole - 1, whole - 1);
    return concatenate({missing == 1 ? sign : fmt::format("{{{}{{{}}}}}", missing, sign)}, {low});
  }

  /// The operator of n on its operands, at n's own width.
  phrase compute(const node& n) {
    const int own = own_width(n);
    const auto operand = [&](std::size_t i) { return bits(*n.operands[i], operand_width(n, i)); };
    const auto binary = [&](const char* symbol, phrase::binding rank, phrase::binding right_rank) {
      const std::string left = operand(0).within(rank);
      return phrase{fmt::format("{} {} {}", left, symbol, operand(1).within(right_rank)), rank};
    };
    switch (n.op) {
      case operation::add:
        return binary("+", phrase::sum, phrase::product);
      case operation::subtract:
        return binary("-", phrase::sum, phrase::product);
      case operation::multiply:
        return product(n);
      case operation::complement:
        return {fmt::format("~{}", operand(0).within(phrase::primary)), phrase::unary};
      case operation::shift_left:
        if (own <= n.distance) return {literal(0, own)};
        return concatenate(operand(0), {fmt::format("{}'b0", n.distance)});
      case operation::shift_right: {
        const node& from = *n.operands[0];
        const std::string name = name_of(from);
        const int high = own + n.distance - 1;
        mark_read(name, high, n.distance);
        return {slice(name, from.op == operation::signal ? from.width() : own_width(from), high, n.distance)};
      }
      case operation::less:
        if (threshold_of(n) >= 0) return below_power(*n.operands[0], threshold_of(n));
        return n.operands[0]->op == operation::constant ? relation(n, 1, ">", 0) : relation(n, 0, "<", 1);
      case operation::equal:
        return relation(n, 0, "==", 1);
      case operation::logical_and:
        return binary("&&", phrase::conjunction, phrase::relation);
      case operation::logical_or:
        return binary("||", phrase::disjunction, phrase::conjunction);
      case operation::logical_not:
        return {fmt::format("!{}", operand(0).within(phrase::primary)), phrase::unary};
      case operation::select: {
        const std::string condition = operand(0).within(phrase::primary);
        const std::string yes = operand(1).within(phrase::disjunction);
        return {fmt::format("{} ? {} : {}", condition, yes, operand(2).text), phrase::choice};
      }
      // Few readers know how & | ^ bind: all operands that are not names stand in parentheses.
      case operation::bit_and:
        return bitwise("&", operand(0), operand(1));
      case operation::bit_or:
        return bitwise("|", operand(0), operand(1));
      case operation::bit_xor:
        return bitwise("^", operand(0), operand(1));
      case operation::lookup:
        return {fmt::format("{}({})", table(n), operand(0).text)};
      case operation::constant:
      case operation::parameter:
      case operation::signal:
        break;
    }
    throw std::logic_error("not an operator");
  }

  /// The threshold of "x < 0" and "x < 2^k", which the upper bits of x decide; -1 for all other nodes.
  static wide_int threshold_of(const node& n) {
    if (n.op != operation::less || n.operands[1]->op != operation::constant) return -1;
    const node& x = *n.operands[0];
    const wide_int threshold = n.operands[1]->low;
    if (x.op == operation::constant || threshold < 0 || threshold > x.high) return -1;
    const bool is_power = (threshold & (threshold - 1)) == 0;
    return is_power && (x.is_signed() || threshold > 0) ? threshold : -1;
  }

  /// x < threshold, a power of two or 0, without a comparator: not all synthesis tools find that they need none.
  phrase below_power(const node& x, wide_int threshold) {
    const std::string name = name_of(x);
    const int whole = is_name(x) ? x.width() : own_width(x);
    const int magnitude = whole - (x.is_signed() ? 1 : 0);
    phrase is_negative;
    if (x.is_signed()) {
      mark_read(name, whole - 1, whole - 1);
      is_negative = {slice(name, whole, whole - 1, whole - 1)};
      if (threshold == 0) return is_negative;
    }
    int place = 0;
    while (wide_int{1} << place < threshold) ++place;
    mark_read(name, magnitude - 1, place);
    const std::string upper = slice(name, whole, magnitude - 1, place);
    const std::string is_below = fmt::format("{} == {}", upper, literal(0, magnitude - place));
    if (!x.is_signed()) return {is_below, phrase::relation};
    return {fmt::format("{} || ({})", is_negative.text, is_below), phrase::disjunction};
  }

  /// Factors whose sign bit is cut off are read as unsigned numbers: the low bits of the product are the same.
  phrase product(const node& n) {
    const int own = own_width(n);
    const auto keeps_sign = [&](std::size_t i) {
      return n.operands[i]->is_signed() && n.operands[i]->width() < own;
    };
    const bool is_signed = keeps_sign(0) || keeps_sign(1);
    const auto factor = [&](std::size_t i, phrase::binding rank) {
      const node& from = *n.operands[i];
      const int width = std::min(own, from.width());
      if (!is_signed) return bits(from, width).within(rank);
      if (!keeps_sign(i) && width < own)
        return fmt::format("$signed({})", concatenate({"1'b0"}, bits(from, width)).text);
      if (from.op == operation::constant) return signed_literal(from.low, width);
      if (from.op == operation::signal && from.is_signed() && width == from.width())
        return bits(from, width).text;
      return fmt::format("$signed({})", bits(from, width).text);
    };
    const std::string left = factor(0, phrase::product);
    return {fmt::format("{} * {}", left, factor(1, phrase::unary)), phrase::product};
  }

  static phrase bitwise(const char* symbol, const phrase& a, const phrase& b) {
    return {fmt::format("{} {} {}", a.within(phrase::unary), symbol, b.within(phrase::unary)),
            phrase::bitwise};
  }

  /// The name of a function that holds the table of n.
  std::string table(const node& n) {
    const int width = own_width(n);
    const int index_width = n.operands[0]->width();
    std::string name = new_name("rom");
    const std::string index = new_name("index");
    functions_ += fmt::format("  function {}{};\n    input {}{};\n    case ({})\n", range_text(width), name,
                              range_text(index_width), index, index);
    for (std::size_t i = 0; i < n.table.size() && static_cast<wide_int>(i) <= n.operands[0]->high; ++i) {
      functions_ += fmt::format("      {}: {} = {};\n", literal(static_cast<wide_int>(i), index_width), name,
                                literal(n.table[i], width));
    }
    functions_ +=
        fmt::format("      default: {} = {};\n    endcase\n  endfunction\n\n", name, literal(0, width));
    return name;
  }

  phrase relation(const node& n, std::size_t left, const char* symbol, std::size_t right) {
    const auto side = [&](std::size_t i) {
      const node& operand = *n.operands[i];
      const int width = operand_width(n, i);
      const bool is_signed = are_signed(*n.operands[0], *n.operands[1]);
      if (is_signed && operand.op == operation::constant) return signed_literal(operand.low, width);
      const std::string text = bits(operand, width).within(phrase::sum);
      return is_signed ? fmt::format("$signed({})", text) : text;
    };
    const std::string first = side(left);
    return {fmt::format("{} {} {}", first, symbol, side(right)), phrase::relation};
  }

  void assign(const declaration& target, const expression& value) {
    statements_ +=
        fmt::format("  assign {} = {};\n", target.name, bits(*value.root(), target.bits.width).text);
  }

  void clocked(const declaration& q, const flip_flops& flops) {
    const std::string clk = bits(*flops.clk.root(), 1).text;
    const std::string rst_n = bits(*flops.rst_n.root(), 1).text;
    const node& enable = *flops.enable.root();
    const bool is_always = enable.op == operation::constant && enable.low == 1;
    const std::string condition = is_always ? "" : fmt::format("if ({}) ", bits(enable, 1).text);
    const std::string d = bits(*flops.d.root(), q.bits.width).text;
    statements_ += fmt::format(
        "  always @(posedge {}) begin\n"
        "    if (!{}) begin\n"
        "      {} <= {};\n"
        "    end else {}begin\n"
        "      {} <= {};\n"
        "    end\n"
        "  end\n",
        clk, rst_n, q.name, literal(flops.reset, q.bits.width), condition, q.name, d);
  }

  void mark_read(const std::string& name, int high, int low) {
    std::set<int>& read = read_[name];
    for (int bit = low; bit <= high; ++bit) read.insert(bit);
  }

  /// Names the bits that nothing reads, which tells lint that they are meant to be left over.
  std::string unused(const std::string& name, int width) const {
    const auto found = read_.find(name);
    if (found == read_.end()) throw std::logic_error(name + " is described, and not used");
    const int lowest = *found->second.begin();
    const int highest = *found->second.rbegin();
    std::string result;
    const auto leave = [&](const char* which, int high, int low, const char* why) {
      result += fmt::format("  wire {}unused_{}_{} = {};  // {}\n", range_text(high - low + 1), name, which,
                            slice(name, width, high, low), why);
    };
    if (highest < width - 1) leave("high", width - 1, highest + 1, "beyond the range of the result");
    if (lowest > 0) leave("low", lowest - 1, 0, "below the last place of the result");
    return result;
  }

  std::set<const node*> assigned_;  // whole right sides of assignments
  std::map<const node*, use> uses_;
  std::set<std::pair<int, const node*>> order_;
  std::map<const node*, std::string> names_;
  std::set<std::string> taken_;
  std::map<std::string, std::set<int>> read_;
  std::vector<wire> wires_;
  std::string functions_;
  std::string statements_;
};

}  // namespace

std::string law_text(const netlist::block& part) {
  return law_writer(part).text(part.declarations());
}

int parameter_width(const netlist::block& part, const std::string& name) {
  return law_writer(part).parameter_width(name);
}

}  // namespace blysk::verilog
