// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/range_monitor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>
#include <utility>

namespace blysk::harness {

using netlist::operation;
using netlist::wide_int;

namespace {

using reader = std::int64_t (*)(const sc_core::sc_interface*);

template <class T>
std::int64_t read_as(const sc_core::sc_interface* channel) {
  const T& value = dynamic_cast<const sc_core::sc_signal_in_if<T>&>(*channel).read();
  if constexpr (std::is_same_v<T, bool>) {
    return value ? 1 : 0;
  } else {
    return value.to_int64();
  }
}

template <std::size_t... Width>
constexpr std::array<std::array<reader, 64>, 2> readers_of(std::index_sequence<Width...>) {
  return {{{&read_as<sc_dt::sc_uint<static_cast<int>(Width) + 1>>...},
           {&read_as<sc_dt::sc_int<static_cast<int>(Width) + 1>>...}}};
}
constexpr auto kReaders = readers_of(std::make_index_sequence<64>());

/// A value of a signal's type.
class signal_value {
 public:
  signal_value(const sc_core::sc_interface* channel, netlist::shape bits)
      : channel_(channel),
        read_(dynamic_cast<const sc_core::sc_signal_in_if<bool>*>(channel) != nullptr
                  ? &read_as<bool>
                  : kReaders.at(bits.is_signed ? 1 : 0).at(static_cast<std::size_t>(bits.width) - 1)),
        bits_(bits) {}

  /// The bits of an unsigned one beyond 63 are no sign.
  wide_int read() const {
    const std::int64_t value = read_(channel_);
    return bits_.is_signed ? wide_int{value} : wide_int{static_cast<std::uint64_t>(value)};
  }

 private:
  const sc_core::sc_interface* channel_;
  reader read_;
  netlist::shape bits_;
};

wide_int low_bits(wide_int value, netlist::shape bits) {
  const wide_int span = wide_int{1} << bits.width;
  const wide_int low = value & (span - 1);
  return bits.is_signed && (low >> (bits.width - 1)) != 0 ? low - span : low;
}

wire_format format_or_bits(const netlist::declaration& of) {
  if (of.carries) return *of.carries;
  const int width = of.bits.width - (of.bits.is_signed ? 1 : 0);
  const std::int64_t span = std::int64_t{1} << width;
  return {width, 0, of.bits.is_signed, of.bits.is_signed ? -span : 0, span - 1};
}

}  // namespace

int net_range::bits_needed() const {
  int bits = carries.is_signed ? 1 : 0;
  const auto fits = [&] {
    const wide_int span = wide_int{1} << (carries.is_signed ? bits - 1 : bits);
    return least >= (carries.is_signed ? -span : 0) && greatest < span;
  };
  while (!fits()) ++bits;
  return bits;
}

/// The law of a block as steps on values, each after its operands.
class range_monitor::law {
 public:
  /// \param first  number of its first range among the monitor's
  law(const sc_core::sc_module& module, const netlist::block& part, std::string path, std::size_t first)
      : module_(module), part_(part), path_(std::move(path)), next_range_(first) {
    for (const netlist::assignment& each : part_.drives()) {
      const netlist::declaration& target = part_.declarations()[each.target];
      drives_.push_back({slot_of(*each.value.root()), signal_of(target), target.bits, next_range_++});
    }
    for (const netlist::flip_flops& each : part_.registers()) {
      registers_.push_back({slot_of(*each.rst_n.root()), slot_of(*each.enable.root()),
                            slot_of(*each.d.root()), next_range_++});
    }
  }

  std::vector<net_range> ranges() const {
    std::vector<net_range> all;
    const auto add = [&](std::size_t target) {
      const netlist::declaration& of = part_.declarations()[target];
      all.push_back({path_ + "." + of.name, format_or_bits(of), of.carries.has_value()});
    };
    for (const netlist::assignment& each : part_.drives()) add(each.target);
    for (const netlist::flip_flops& each : part_.registers()) add(each.q);
    return all;
  }

  /// \return  the name of an output whose wire does not carry the low bits of what the law gives, or nothing
  std::string look(std::vector<net_range>& ranges) {
    for (const auto& [signal, slot] : signals_) values_[slot] = signal.read();
    for (const step& each : steps_) values_[each.to] = result_of(each);
    std::string fault;
    for (const drive& each : drives_) {
      const wide_int value = values_[each.value];
      if (low_bits(value, each.bits) != each.wire.read()) fault = ranges[each.range].name;
      widen(ranges[each.range], value);
    }
    for (const flip_flop& each : registers_) {
      if (values_[each.rst_n] != 0 && values_[each.enable] != 0) widen(ranges[each.range], values_[each.d]);
    }
    return fault;
  }

 private:
  struct step {
    operation op;
    std::array<std::size_t, 3> from;
    std::size_t to;
    int distance;
    const std::vector<std::int64_t>* table;
  };
  struct drive {
    std::size_t value;
    signal_value wire;
    netlist::shape bits;
    std::size_t range;
  };
  struct flip_flop {
    std::size_t rst_n, enable, d;
    std::size_t range;
  };

  static void widen(net_range& of, wide_int value) {
    of.least = of.is_seen ? std::min(of.least, value) : value;
    of.greatest = of.is_seen ? std::max(of.greatest, value) : value;
    of.is_seen = true;
  }

  /// What SystemC has under the name: a port's channel or a signal within the block.
  signal_value signal_of(const netlist::declaration& of) const {
    for (const sc_core::sc_object* child : module_.get_child_objects()) {
      if (of.name != child->basename()) continue;
      if (const auto* port = dynamic_cast<const sc_core::sc_port_base*>(child))
        return {port->get_interface(), of.bits};
      if (const auto* signal = dynamic_cast<const sc_core::sc_interface*>(child)) return {signal, of.bits};
    }
    throw std::logic_error(path_ + " has no port or signal " + of.name);
  }

  std::size_t slot_of(const netlist::node& of) {
    const auto known = slots_.find(&of);
    if (known != slots_.end()) return known->second;
    return slots_[&of] = new_slot(of);
  }

  std::size_t new_slot(const netlist::node& of) {
    if (of.op == operation::constant) return add_value(of.low);
    if (of.op == operation::parameter) {
      const auto& parameters = part_.parameters();
      const auto found = std::ranges::find(parameters, of.name, &netlist::instance_parameter::name);
      if (found == parameters.end()) throw std::logic_error("parameter " + of.name + " has no value");
      return add_value(found->value);
    }
    if (of.op == operation::signal) {
      const auto [known, is_new] = names_.try_emplace(of.name, 0);
      if (is_new) {
        known->second = add_value(0);
        signals_.emplace_back(signal_of(part_.described(of.name)), known->second);
      }
      return known->second;
    }
    std::array<std::size_t, 3> from{};
    for (std::size_t i = 0; i < of.operands.size(); ++i) from.at(i) = slot_of(*of.operands[i]);
    const std::size_t to = add_value(0);
    steps_.push_back({of.op, from, to, of.distance, &of.table});
    return to;
  }

  std::size_t add_value(wide_int value) {
    values_.push_back(value);
    return values_.size() - 1;
  }

  wide_int result_of(const step& of) const {
    const wide_int a = values_[of.from[0]];
    const wide_int b = values_[of.from[1]];
    switch (of.op) {
      case operation::add:
        return a + b;
      case operation::subtract:
        return a - b;
      case operation::multiply:
        return a * b;
      case operation::complement:
        return ~a;
      case operation::shift_left:
        return a << of.distance;
      case operation::shift_right:
        return a >> of.distance;
      case operation::less:
        return a < b ? 1 : 0;
      case operation::equal:
        return a == b ? 1 : 0;
      case operation::logical_and:
        return a != 0 && b != 0 ? 1 : 0;
      case operation::logical_or:
        return a != 0 || b != 0 ? 1 : 0;
      case operation::logical_not:
        return a == 0 ? 1 : 0;
      case operation::bit_and:
        return a & b;
      case operation::bit_or:
        return a | b;
      case operation::bit_xor:
        return a ^ b;
      case operation::select:
        return a != 0 ? b : values_[of.from[2]];
      case operation::lookup:
        return a < static_cast<wide_int>(of.table->size())
                   ? wide_int{(*of.table)[static_cast<std::size_t>(a)]}
                   : wide_int{0};
      case operation::constant:
      case operation::parameter:
      case operation::signal:
        break;  // values, no steps
    }
    throw std::logic_error("an operation that the monitor does not know");
  }

  const sc_core::sc_module& module_;
  const netlist::block& part_;
  std::string path_;
  std::size_t next_range_;
  std::vector<wide_int> values_;
  std::vector<step> steps_;
  std::vector<std::pair<signal_value, std::size_t>> signals_;  // and the value that each is read into
  std::map<std::string, std::size_t> names_;
  std::map<const netlist::node*, std::size_t> slots_;
  std::vector<drive> drives_;
  std::vector<flip_flop> registers_;
};

range_monitor::range_monitor(const sc_core::sc_module_name& name, const netlist::elaborated& device)
    : sc_core::sc_module(name), device_(device) {
  SC_METHOD(look);
  for (const auto& each : device_.ports()) {
    if (each->what.is == port::role::clock) sensitive << each->control().posedge_event();
  }
  dont_initialize();
}

range_monitor::~range_monitor() = default;

const std::vector<net_range>& range_monitor::ranges() const {
  if (!fault_.empty()) throw std::logic_error(fault_ + " does not carry what its block's law gives");
  return ranges_;
}

// Ports are bound now.
void range_monitor::start_of_simulation() {
  for (const sc_core::sc_module* module : device_.parts().modules()) {
    laws_.push_back(std::make_unique<law>(*module, *device_.parts().find(*module), device_.path_of(*module),
                                          ranges_.size()));
    std::ranges::move(laws_.back()->ranges(), std::back_inserter(ranges_));
  }
}

void range_monitor::look() {
  if (!is_on_) return;
  ++edges_;
  for (const auto& each : laws_) {
    std::string fault = each->look(ranges_);
    if (fault_.empty()) fault_ = std::move(fault);
  }
}

}  // namespace blysk::harness
