// SPDX-License-Identifier: Apache-2.0
/// A leaf block as Verilog.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <systemc>
#include <vector>

#include "tb/export/expression.h"
#include "tb/export/format.h"

namespace blysk::verilog {

/// Bits and sign of what a port or signal carries.
struct shape {
  int width;
  bool is_signed;
};

template <class T>
inline constexpr shape shape_of{};
template <>
inline constexpr shape shape_of<bool>{1, false};
template <int Width>
inline constexpr shape shape_of<sc_dt::sc_uint<Width>>{Width, false};
template <int Width>
inline constexpr shape shape_of<sc_dt::sc_int<Width>>{Width, true};

/// One name of a module, as it is declared: "input  wire signed [14:0] b_i".
struct declaration {
  enum class role { input, output, wire };

  std::string name;
  role where;
  shape bits;
  bool is_reg = false;
  std::optional<wire_format> carries = {};

  std::string text() const;
};

/// What the text of a block asks of its instances.
struct instance_parameter {
  std::string name;
  std::int64_t value;
  std::optional<wire_format> carries;
};

/// Reader of a leaf block: its describe() tells this what the block is, which ports feed the law, and what the law
/// makes of them. Ports that carry numbers come with their Q-format.
class block_reader {
 public:
  /// \param kind     begins the module's name, "mul"
  /// \param words    what it does, a line of its file's head
  /// \param variant  ends the module's name where formats alone do not tell two kinds apart, "clamp"
  void block(const std::string& kind, const std::string& words, const std::string& variant = "") {
    kind_ = kind;
    words_ = words;
    variant_ = variant;
  }

  template <class T, class Format = no_format>
  expression read(const sc_core::sc_in<T>& port, Format format = {}) {
    return read(port.basename(), declaration::role::input, shape_of<T>, format_of(format));
  }
  template <class T, sc_core::sc_writer_policy Policy>
  expression read(const sc_core::sc_signal<T, Policy>& wire) {
    return read(wire.basename(), declaration::role::wire, shape_of<T>, {});
  }

  expression constant(std::int64_t value) { return expression(value); }

  /// A constant that each instance has its own value of.
  template <class Format = no_format>
  expression parameter(const std::string& name, std::int64_t value, Format format = {}) {
    parameters_.push_back({name, value, format_of(format)});
    return expression::parameter(name);
  }

  /// target = value, its low bits if the value has more than the target.
  template <class T, class Format = no_format>
  void drive(const sc_core::sc_out<T>& target, const expression& value, Format format = {}) {
    const auto index = declare(target.basename(), declaration::role::output, shape_of<T>, format_of(format));
    drives_.push_back({index, value});
  }

  /// At each rising edge of clk: q = rst_n ? (enable ? d : q) : reset.
  template <class Q, class Format = no_format>
  void reg(const sc_core::sc_in<bool>& clk, const sc_core::sc_in<bool>& rst_n, const expression& enable,
           const expression& d, const Q& q, Format format = {}, std::int64_t reset = 0) {
    registers_.push_back({read(clk), read(rst_n), enable, d, declare_register(q, format_of(format)), reset});
  }

  const std::string& words() const { return words_; }

  /// "mul_uq10_0_uq0_12_to_uq10_12": kind, formats of inputs and outputs in the order of the ports, variant.
  /// \throws std::logic_error if the block does not say what it is
  std::string name(const std::vector<std::string>& ports) const;

  const std::vector<declaration>& declarations() const { return declarations_; }
  const std::vector<instance_parameter>& parameters() const { return parameters_; }

  /// The module, its ports in the order given.
  /// \throws std::logic_error for a port that is not described, or not used
  std::string text(const std::string& module_name, const std::string& title,
                   const std::vector<std::string>& ports) const;

  /// True if the port clocks registers.
  bool is_clock(const std::string& port) const;

  /// Bits of the named parameter that the block uses.
  int parameter_width(const std::string& name) const;

 private:
  class body;

  struct assignment {
    std::size_t target;  // in declarations_
    expression value;
  };
  struct flip_flops {
    expression clk;
    expression rst_n;
    expression enable;
    expression d;
    std::size_t q;
    std::int64_t reset;
  };

  template <class T>
  std::size_t declare_register(const sc_core::sc_out<T>& q, const std::optional<wire_format>& carries) {
    return declare(q.basename(), declaration::role::output, shape_of<T>, carries, true);
  }
  template <class T, sc_core::sc_writer_policy Policy>
  std::size_t declare_register(const sc_core::sc_signal<T, Policy>& q,
                               const std::optional<wire_format>& carries) {
    return declare(q.basename(), declaration::role::wire, shape_of<T>, carries, true);
  }

  expression read(const std::string& name, declaration::role where, shape bits,
                  const std::optional<wire_format>& carries);
  std::size_t declare(const std::string& name, declaration::role where, shape bits,
                      const std::optional<wire_format>& carries, bool is_reg = false);
  const declaration& described(const std::string& port) const;

  std::string kind_, words_, variant_;
  std::vector<declaration> declarations_;
  std::vector<instance_parameter> parameters_;
  std::vector<assignment> drives_;
  std::vector<flip_flops> registers_;
};

/// "[7:0] ", or nothing for one bit.
std::string range_text(int width);

/// The low `width` bits of a number as a Verilog literal, "8'd255".
std::string literal(wide_int value, int width);

/// A signed one, "-8'sd3".
std::string signed_literal(wide_int value, int width);

/// "  // NOTE", or nothing if there is none.
std::string comment(const std::string& note);

/// The ports, a line each with the note of its name, or its format.
std::string port_list(const std::vector<declaration>& ports, const std::map<std::string, std::string>& notes);

/// What all files begin and end with.
std::string file_text(const std::string& title, const std::string& content);

}  // namespace blysk::verilog
