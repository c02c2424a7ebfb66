// SPDX-License-Identifier: Apache-2.0
/// Words and phrases of Verilog.
#pragma once

#include <string>

#include "tb/netlist/block.h"

namespace blysk::verilog {

using netlist::wide_int;

/// "[7:0] ", or nothing for one bit.
std::string range_text(int width);

/// The low `width` bits of a number as a Verilog literal, "8'd255".
std::string literal(wide_int value, int width);

/// A signed one, "-8'sd3".
std::string signed_literal(wide_int value, int width);

/// "  // NOTE", or nothing if there is none.
std::string comment(const std::string& note);

/// Bits of a named net: "a", "a[3]", "a[7:4]".
/// \param width  of the net
std::string slice(const std::string& name, int width, int high, int low);

/// "input  wire signed [14:0] b_i".
std::string declaration_text(const netlist::declaration& name);

/// What all files begin and end with.
std::string file_text(const std::string& title, const std::string& content);

/// A piece of Verilog, with how loosely it binds.
struct phrase {
  enum binding { primary, unary, product, sum, relation, bitwise, conjunction, disjunction, choice };

  std::string text;
  binding rank = primary;
  bool is_concatenation = false;

  std::string within(binding loosest) const;
};

/// {high, low}
phrase concatenate(const phrase& high, const phrase& low);

}  // namespace blysk::verilog
