// SPDX-License-Identifier: Apache-2.0
#include "tb/netlist/block.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace blysk::netlist {

void block::add_trace(const char* name, tracer records) {
  traces_.emplace_back(name, std::move(records));
}

void block::add_assignment(const char* target, shape bits, const std::optional<wire_format>& carries,
                           const expression& value) {
  drives_.push_back({declare(target, declaration::role::output, bits, carries), value});
}

void block::add_register(const sc_core::sc_in<bool>& clk, const sc_core::sc_in<bool>& rst_n,
                         const expression& enable, const expression& d, std::size_t q, std::int64_t reset) {
  registers_.push_back({read(clk), read(rst_n), enable, d, q, reset});
}

expression block::read(const std::string& name, declaration::role where, shape bits,
                       const std::optional<wire_format>& carries) {
  declare(name, where, bits, carries);
  return expression::signal(name, bits.width, bits.is_signed);
}

std::size_t block::declare(const std::string& name, declaration::role where, shape bits,
                           const std::optional<wire_format>& carries, bool is_reg) {
  if (carries && carries->width() != bits.width)
    throw std::logic_error(fmt::format("{} has {} bits, not those of {}", name, bits.width, carries->text()));
  const auto known = std::ranges::find(declarations_, name, &declaration::name);
  if (known != declarations_.end()) {
    known->is_reg |= is_reg;
    if (carries) known->carries = carries;
    return static_cast<std::size_t>(known - declarations_.begin());
  }
  declarations_.push_back({name, where, bits, is_reg, carries});
  return declarations_.size() - 1;
}

bool block::is_clock(const std::string& port) const {
  return std::ranges::any_of(registers_,
                             [&](const flip_flops& flops) { return flops.clk.root()->name == port; });
}

const declaration& block::described(const std::string& port) const {
  const auto found = std::ranges::find(declarations_, port, &declaration::name);
  if (found == declarations_.end()) throw std::logic_error("port " + port + " is not described");
  return *found;
}

std::string block::name(const std::vector<std::string>& ports) const {
  if (kind_.empty()) throw std::logic_error("a block does not say what it is");
  std::string in, out;
  for (const std::string& port : ports) {
    const declaration& each = described(port);
    if (each.carries)
      (each.where == declaration::role::input ? in : out) += fmt::format("_{}", each.carries->name());
  }
  const std::string result = in.empty() || in == out ? out : out.empty() ? in : in + "_to" + out;
  return kind_ + result + (variant_.empty() ? "" : fmt::format("_{}", variant_));
}

}  // namespace blysk::netlist
