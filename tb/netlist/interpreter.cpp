// SPDX-License-Identifier: Apache-2.0
#include "tb/netlist/interpreter.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>

namespace blysk::netlist {
namespace {

constexpr std::size_t kRows =
    256;  // of one pass over the steps: a value's rows stay in the first-level cache

using slot = std::size_t;
constexpr slot kUnknown = std::numeric_limits<slot>::max();  // what follows from a port without a column

/// Operations on values, each a block of rows. Equal operations on the same values are one step.
/// \tparam T  std::int64_t or wide_int
template <class T>
class program {
 public:
  slot input() { return add_slot(); }

  slot constant(wide_int value) {
    const auto [known, is_new] = constants_.try_emplace(value, kUnknown);
    if (is_new) {
      known->second = add_slot();
      std::fill_n(rows(known->second), kRows, static_cast<T>(value));
    }
    return known->second;
  }

  slot apply(operation op, std::array<slot, 3> from, int distance = 0, std::vector<std::int64_t> table = {}) {
    const auto [known, is_new] = results_.try_emplace({op, from, distance, table}, kUnknown);
    if (is_new) {
      known->second = add_slot();
      steps_.push_back({op, from, known->second, distance, std::move(table)});
    }
    return known->second;
  }

  /// The value's low bits.
  slot wrap(slot value, shape bits) {
    const int above = static_cast<int>(8 * sizeof(T)) - bits.width;
    if (!bits.is_signed)
      return apply(operation::bit_and, {value, constant((wide_int{1} << bits.width) - 1), 0});
    return apply(operation::shift_right, {apply(operation::shift_left, {value, 0, 0}, above), 0, 0}, above);
  }

  T* rows(slot value) { return memory_.data() + value * kRows; }

  void run() {
    for (const step& each : steps_) run(each);
  }

 private:
  struct step {
    operation op;
    std::array<slot, 3> from;
    slot to;
    int distance;
    std::vector<std::int64_t> table;
  };

  slot add_slot() {
    memory_.resize(memory_.size() + kRows);
    return memory_.size() / kRows - 1;
  }

  template <class Law>
  void for_rows(const step& of, Law law) {
    const T* const a = rows(of.from[0]);
    T* const to = rows(of.to);
    for (std::size_t i = 0; i < kRows; ++i) to[i] = static_cast<T>(law(a[i]));
  }
  template <class Law>
  void for_pairs(const step& of, Law law) {
    const T* const a = rows(of.from[0]);
    const T* const b = rows(of.from[1]);
    T* const to = rows(of.to);
    for (std::size_t i = 0; i < kRows; ++i) to[i] = static_cast<T>(law(a[i], b[i]));
  }

  void run(const step& each) {
    const int distance = each.distance;
    switch (each.op) {
      case operation::add:
        return for_pairs(each, [](T a, T b) { return a + b; });
      case operation::subtract:
        return for_pairs(each, [](T a, T b) { return a - b; });
      case operation::multiply:
        return for_pairs(each, [](T a, T b) { return a * b; });
      case operation::complement:
        return for_rows(each, [](T a) { return ~a; });
      case operation::shift_left:
        return for_rows(each, [distance](T a) { return a << distance; });
      case operation::shift_right:
        return for_rows(each, [distance](T a) { return a >> distance; });
      case operation::less:
        return for_pairs(each, [](T a, T b) { return a < b; });
      case operation::equal:
        return for_pairs(each, [](T a, T b) { return a == b; });
      case operation::logical_not:
        return for_rows(each, [](T a) { return a ^ 1; });
      case operation::logical_and:  // operands of logic are 0 or 1
      case operation::bit_and:
        return for_pairs(each, [](T a, T b) { return a & b; });
      case operation::logical_or:
      case operation::bit_or:
        return for_pairs(each, [](T a, T b) { return a | b; });
      case operation::bit_xor:
        return for_pairs(each, [](T a, T b) { return a ^ b; });
      case operation::select: {
        const T* const condition = rows(each.from[0]);
        const T* const a = rows(each.from[1]);
        const T* const b = rows(each.from[2]);
        T* const to = rows(each.to);
        for (std::size_t i = 0; i < kRows; ++i) to[i] = condition[i] != 0 ? a[i] : b[i];
        return;
      }
      case operation::lookup:
        return for_rows(each, [&table = each.table](T a) {
          return a < static_cast<T>(table.size()) ? table[static_cast<std::size_t>(a)] : 0;
        });
      case operation::constant:
      case operation::parameter:
      case operation::signal:
        break;  // values, no steps
    }
    throw std::logic_error("an operation that the interpreter does not know");
  }

  std::vector<T> memory_;
  std::vector<step> steps_;
  std::map<wide_int, slot> constants_;
  std::map<std::tuple<operation, std::array<slot, 3>, int, std::vector<std::int64_t>>, slot> results_;
};

using channel = const sc_core::sc_interface*;

/// Translates the blocks of a device, each after what drives its inputs.
template <class T>
class translator {
 public:
  explicit translator(program<T>& steps) : steps_(steps) {}

  void drive(channel of, slot value) { values_[of] = value; }

  /// \throws std::logic_error if nothing drives it
  slot value_of(channel of, const std::string& reader) const {
    const auto found = values_.find(of);
    if (found == values_.end()) throw std::logic_error(reader + " is driven by nothing");
    return found->second;
  }

  void translate(const sc_core::sc_module& module, const block& part) {
    names_.clear();
    nodes_.clear();
    part_ = &part;
    std::map<std::string, channel> outputs;
    for (const sc_core::sc_port_base* port : ports_of_module(module)) {
      const declaration& described = part.described(port->basename());
      if (described.where == declaration::role::output) outputs[described.name] = port->get_interface();
      if (described.where == declaration::role::input)
        names_[described.name] = {value_of(port->get_interface(), port->name()), true};
    }
    for (const auto& [name, driven] : outputs) drive(driven, value_of_name(name));
  }

 private:
  struct named_value {
    slot value = kUnknown;
    bool is_done = false;
  };

  /// What a name of the block carries: an input, a drive or a register's d.
  slot value_of_name(const std::string& name) {
    const auto [known, is_new] = names_.try_emplace(name);
    if (!is_new) {
      if (!known->second.is_done) throw std::logic_error(name + " is in a loop");
      return known->second.value;
    }
    const auto has_name = [&](const auto& target) { return part_->declarations()[target].name == name; };
    const auto driven = std::ranges::find_if(part_->drives(), has_name, &assignment::target);
    const auto kept = std::ranges::find_if(part_->registers(), has_name, &flip_flops::q);
    if (driven == part_->drives().end() && kept == part_->registers().end())
      throw std::logic_error(name + " is driven by nothing");
    const node& root = *(driven != part_->drives().end() ? driven->value : kept->d).root();
    const slot whole = translate(root);
    const slot value = whole == kUnknown ? whole : fitted(whole, root, part_->described(name).bits);
    names_[name] = {value, true};
    return value;
  }

  slot fitted(slot value, const node& of, shape bits) {
    const wide_int span = wide_int{1} << (bits.is_signed ? bits.width - 1 : bits.width);
    const bool fits = of.low >= (bits.is_signed ? -span : 0) && of.high < span;
    return fits ? value : steps_.wrap(value, bits);
  }

  slot translate(const node& of) {
    const auto known = nodes_.find(&of);
    if (known != nodes_.end()) return known->second;
    return nodes_[&of] = translate_new(of);
  }

  slot translate_new(const node& of) {
    if (of.op == operation::constant) return steps_.constant(of.low);
    if (of.op == operation::parameter) {
      const auto& parameters = part_->parameters();
      const auto found = std::ranges::find(parameters, of.name, &instance_parameter::name);
      if (found == parameters.end()) throw std::logic_error("parameter " + of.name + " has no value");
      return steps_.constant(found->value);
    }
    if (of.op == operation::signal) return value_of_name(of.name);
    std::array<slot, 3> from{};
    for (std::size_t i = 0; i < of.operands.size(); ++i) {
      from.at(i) = translate(*of.operands[i]);
      if (from.at(i) == kUnknown) return kUnknown;
    }
    return steps_.apply(of.op, from, of.distance, of.table);
  }

  program<T>& steps_;
  std::map<channel, slot> values_;
  const block* part_ = nullptr;
  std::map<std::string, named_value> names_;
  std::map<const node*, slot> nodes_;
};

/// What the device's port or net of that name is bound to.
channel channel_of(const elaborated& device, const std::string& name) {
  for (const sc_core::sc_object* child : device.device().get_child_objects()) {
    if (name != child->basename()) continue;
    if (const auto* port = dynamic_cast<const sc_core::sc_port_base*>(child)) return port->get_interface();
    if (const auto* signal = dynamic_cast<const sc_core::sc_interface*>(child)) return signal;
  }
  throw std::logic_error("the device has no port or net " + name);
}

std::vector<port> ports_of(const elaborated& device) {
  std::vector<port> ports;
  for (const auto& each : device.ports()) ports.push_back(each->what);
  return ports;
}

template <class T>
class interpreter final : public engine {
 public:
  explicit interpreter(const elaborated& device)
      : engine(columns(ports_of(device), port::role::result).layout()) {
    translator<T> reader(steps_);
    for (const auto& each : device.ports()) {
      if (!each->what.is_input()) continue;
      slot value = kUnknown;
      if (each->what.is == port::role::data) {
        inputs_.push_back({steps_.input(), 0});
        value = inputs_.back().wrapped = steps_.wrap(inputs_.back().raw, each->bits);
      }
      reader.drive(channel_of(device, each->what.name), value);
    }
    for (const sc_core::sc_module* module : in_order_of_data(device, registers_are::transparent))
      reader.translate(*module, *device.parts().find(*module));
    for (const auto& each : device.ports()) {
      if (each->what.is != port::role::result) continue;
      const std::string& name = each->what.name;
      const slot value = reader.value_of(channel_of(device, name), name);
      if (value == kUnknown)
        throw std::logic_error(name + " depends on a port that is no column of the stimulus");
      results_.push_back(value);
    }
  }

 private:
  struct input {
    slot raw;
    slot wrapped;
  };

  void compute(const columns& in, columns& out) override {
    for (std::size_t first = 0; first < in.size(); first += kRows) {
      const std::size_t size = std::min(kRows, in.size() - first);
      for (std::size_t i = 0; i < inputs_.size(); ++i) {
        T* const to = steps_.rows(inputs_[i].raw);
        in[i].visit([&](const auto& codes) {
          for (std::size_t row = 0; row < size; ++row) to[row] = static_cast<T>(codes[first + row]);
        });
      }
      steps_.run();
      for (std::size_t i = 0; i < results_.size(); ++i) {
        const T* const from = steps_.rows(results_[i]);
        out[i].visit([&](auto& codes) {
          using code = typename std::remove_reference_t<decltype(codes)>::value_type;
          for (std::size_t row = 0; row < size; ++row) codes[first + row] = static_cast<code>(from[row]);
        });
      }
    }
  }

  program<T> steps_;
  std::vector<input> inputs_;
  std::vector<slot> results_;
};

/// Whether 64-bit integers hold every value of a law.
class width_check {
 public:
  bool fits(const node& of) {
    if (!seen_.insert(&of).second) return true;
    return of.low >= std::numeric_limits<std::int64_t>::min() &&
           of.high <= std::numeric_limits<std::int64_t>::max() &&
           std::ranges::all_of(of.operands, [this](const auto& operand) { return fits(*operand); });
  }
  bool fits(const block& part) {
    return std::ranges::all_of(part.drives(),
                               [this](const assignment& each) { return fits(*each.value.root()); }) &&
           std::ranges::all_of(part.registers(),
                               [this](const flip_flops& each) { return fits(*each.d.root()); });
  }

 private:
  std::set<const node*> seen_;
};

/// An engine on a device that it keeps.
class engine_with_device final : public engine {
 public:
  engine_with_device(std::vector<storage> results, std::unique_ptr<elaborated> device)
      : engine(std::move(results)), device_(std::move(device)), steps_(make_interpreter(*device_)) {}

 private:
  void compute(const columns& in, columns& out) override { steps_->run(in, out); }

  std::unique_ptr<elaborated> device_;
  std::unique_ptr<engine> steps_;
};

}  // namespace

std::unique_ptr<engine> make_interpreter(const elaborated& device) {
  // Elaboration binds ports of blocks to the channels behind the device's ports.
  if (!sc_core::sc_start_of_simulation_invoked()) sc_core::sc_start(sc_core::SC_ZERO_TIME);
  width_check check;
  const bool is_narrow = std::ranges::all_of(device.parts().modules(), [&](const sc_core::sc_module* module) {
    return check.fits(*device.parts().find(*module));
  });
  if (is_narrow) return std::make_unique<interpreter<std::int64_t>>(device);
  return std::make_unique<interpreter<wide_int>>(device);
}

std::unique_ptr<engine> make_interpreter(const selection& asked) {
  return std::make_unique<engine_with_device>(columns(asked.of().ports(asked), port::role::result).layout(),
                                              asked.of().elaborate(asked, 0));
}

}  // namespace blysk::netlist
