// SPDX-License-Identifier: Apache-2.0
/// A leaf block of a device as data: ports, and what its law makes of them.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <systemc>
#include <vector>

#include "tb/format.h"
#include "tb/netlist/expression.h"

namespace blysk::netlist {

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

/// One name of a module.
struct declaration {
  enum class role { input, output, wire };

  std::string name;
  role where;
  shape bits;
  bool is_reg = false;
  std::optional<wire_format> carries = {};
};

/// What the text of a block asks of its instances.
struct instance_parameter {
  std::string name;
  std::int64_t value;
  std::optional<wire_format> carries;
};

/// target = value, its low bits if the value has more than the target.
struct assignment {
  std::size_t target;  ///< in the block's declarations
  expression value;
};

/// At each rising edge of clk: q = rst_n ? (enable ? d : q) : reset.
struct flip_flops {
  expression clk;
  expression rst_n;
  expression enable;
  expression d;
  std::size_t q;  ///< in the block's declarations
  std::int64_t reset;
};

/// Records the waves of a port under a name.
using tracer = std::function<void(sc_core::sc_trace_file*, const std::string& name)>;

/// Reader of a leaf block: its describe() tells this what the block is, which ports feed the law, and what the law makes
/// of them. Ports that carry numbers come with their Q-format.
class block {
 public:
  /// \param kind     begins the module's name, "mul"
  /// \param words    what it does, one line
  /// \param variant  ends the module's name where formats alone do not tell two kinds apart, "clamp"
  void block_is(const std::string& kind, const std::string& words, const std::string& variant = "") {
    kind_ = kind;
    words_ = words;
    variant_ = variant;
  }

  /// \param variant  a number that tells instances of one type apart
  void block_is(const std::string& kind, const std::string& words, int variant) {
    block_is(kind, words, std::to_string(variant));
  }

  template <class T>
  expression read(const sc_core::sc_in<T>& port) {
    return read(port.basename(), declaration::role::input, shape_of<T>, {});
  }
  template <class T, class Format>
  expression read(const sc_core::sc_in<T>& port, Format format) {
    return read(port.basename(), declaration::role::input, shape_of<T>, format_of(format));
  }
  template <class T, sc_core::sc_writer_policy Policy>
  expression read(const sc_core::sc_signal<T, Policy>& wire) {
    return read(wire.basename(), declaration::role::wire, shape_of<T>, {});
  }

  expression constant(std::int64_t value) { return expression(value); }

  /// A constant that each instance has its own value of.
  template <class Format>
  expression parameter(const std::string& name, std::int64_t value, Format format) {
    parameters_.push_back({name, value, format_of(format)});
    return expression::parameter(name);
  }

  /// target = value.
  template <class T>
  void drive(const sc_core::sc_out<T>& target, const expression& value) {
    add_drive(target, value, {});
  }
  template <class T, class Format>
  void drive(const sc_core::sc_out<T>& target, const expression& value, Format format) {
    add_drive(target, value, format_of(format));
  }

  /// At each rising edge of clk: q = rst_n ? (enable ? d : q) : reset. q is a port or a signal of the block.
  template <class Q>
  void reg(const sc_core::sc_in<bool>& clk, const sc_core::sc_in<bool>& rst_n, const expression& enable,
           const expression& d, const Q& q, std::int64_t reset = 0) {
    add_register(clk, rst_n, enable, d, declare_register(q, std::nullopt), reset);
  }
  template <class Q, class Format>
  void reg(const sc_core::sc_in<bool>& clk, const sc_core::sc_in<bool>& rst_n, const expression& enable,
           const expression& d, const Q& q, Format format, std::int64_t reset = 0) {
    add_register(clk, rst_n, enable, d, declare_register(q, format_of(format)), reset);
  }

  const std::string& words() const { return words_; }
  const std::vector<declaration>& declarations() const { return declarations_; }
  const std::vector<instance_parameter>& parameters() const { return parameters_; }
  const std::vector<assignment>& drives() const { return drives_; }
  const std::vector<flip_flops>& registers() const { return registers_; }

  /// What records the block's output ports.
  const std::vector<std::pair<std::string, tracer>>& traces() const { return traces_; }

  /// "mul_uq10_0_uq0_12_to_uq10_12": kind, formats of inputs and outputs in the order of the ports, variant.
  /// \throws std::logic_error if the block does not say what it is
  std::string name(const std::vector<std::string>& ports) const;

  /// \throws std::logic_error for a port that is not described
  const declaration& described(const std::string& port) const;

  /// True if the port clocks registers.
  bool is_clock(const std::string& port) const;

 private:
  template <class T>
  void trace(const sc_core::sc_out<T>& port) {
    add_trace(port.basename(), [&port](sc_core::sc_trace_file* file, const std::string& name) {
      sc_core::sc_trace(file, port, name);
    });
  }
  template <class T>
  void add_drive(const sc_core::sc_out<T>& target, const expression& value,
                 const std::optional<wire_format>& carries) {
    add_assignment(target.basename(), shape_of<T>, carries, value);
    trace(target);
  }
  template <class T>
  std::size_t declare_register(const sc_core::sc_out<T>& q, const std::optional<wire_format>& carries) {
    trace(q);
    return declare(q.basename(), declaration::role::output, shape_of<T>, carries, true);
  }
  template <class T, sc_core::sc_writer_policy Policy>
  std::size_t declare_register(const sc_core::sc_signal<T, Policy>& q,
                               const std::optional<wire_format>& carries) {
    return declare(q.basename(), declaration::role::wire, shape_of<T>, carries, true);
  }

  // Not of the ports' types: compiled once for all blocks.
  void add_trace(const char* name, tracer records);
  void add_assignment(const char* target, shape bits, const std::optional<wire_format>& carries,
                      const expression& value);
  void add_register(const sc_core::sc_in<bool>& clk, const sc_core::sc_in<bool>& rst_n,
                    const expression& enable, const expression& d, std::size_t q, std::int64_t reset);
  expression read(const std::string& name, declaration::role where, shape bits,
                  const std::optional<wire_format>& carries);
  std::size_t declare(const std::string& name, declaration::role where, shape bits,
                      const std::optional<wire_format>& carries, bool is_reg = false);

  std::string kind_, words_, variant_;
  std::vector<declaration> declarations_;
  std::vector<instance_parameter> parameters_;
  std::vector<assignment> drives_;
  std::vector<flip_flops> registers_;
  std::vector<std::pair<std::string, tracer>> traces_;
};

}  // namespace blysk::netlist
