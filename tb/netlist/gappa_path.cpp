// SPDX-License-Identifier: Apache-2.0
#include "tb/netlist/gappa_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

namespace blysk::netlist {
namespace {

using channel = const sc_core::sc_interface*;

/// An integer of a law: text 2^scale, the text a real number for Gappa. A bit has the two conditions that make it one and
/// zero instead.
struct number {
  std::string text = {};
  int scale = 0;
  std::optional<std::int64_t> constant = {};  ///< the integer itself
  std::string floored = {};                   ///< the text is this, rounded down; empty if it is not rounded
  std::string if_one = {}, if_zero = {};
  bool is_known = true;  ///< false: it follows from a strobe or reset
};

std::string dyadic(std::int64_t value, int scale) {
  return fmt::format("{}b{}", value, -scale);
}

number constant_of(std::int64_t value) {
  number made;
  made.constant = value;
  made.text = dyadic(value, 0);
  return made;
}

const number kUnknown{.is_known = false};

/// The text at a scale that is not below its own.
std::string at_scale(const number& of, int scale) {
  if (of.constant) return dyadic(*of.constant, scale);
  return of.scale == scale ? of.text : fmt::format("({} * {})", of.text, dyadic(1, scale - of.scale));
}

int common_scale(const number& a, const number& b) {
  if (a.constant) return b.scale;
  if (b.constant) return a.scale;
  return std::max(a.scale, b.scale);
}

bool is_name(const std::string& text) {
  return std::ranges::all_of(
             text, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }) &&
         std::isalpha(static_cast<unsigned char>(text.front())) != 0;
}

/// One way through the netlist: each selection asks `choices` for the next answer, and adds one where there is none.
class reader {
 public:
  reader(const elaborated& device, planted_fault fault, std::vector<bool>& choices)
      : device_(device), fault_(fault), choices_(choices) {}

  gappa_path path;
  std::vector<std::string> facts;
  std::vector<memory_net> memories;
  std::vector<normalised_net> normalised;

  void read(const std::string& result) {
    // For its check: no loop.
    in_order_of_data(device_, registers_are::transparent);
    for (const auto& port : device_.ports()) {
      if (port->what.is_input()) inputs_[find_channel(port->what.name)] = port.get();
    }
    for (const sc_core::sc_module* module : device_.parts().modules()) {
      for (channel of : channels(*module, *device_.parts().find(*module), declaration::role::output))
        drivers_[of] = module;
    }
    value_of_net(find_channel(result));
  }

 private:
  static channel channel_of(const sc_core::sc_object& object) {
    if (const auto* port = dynamic_cast<const sc_core::sc_port_base*>(&object)) return port->get_interface();
    return dynamic_cast<const sc_core::sc_interface*>(&object);
  }

  channel find_channel(const std::string& name) const {
    for (const sc_core::sc_object* child : device_.device().get_child_objects()) {
      if (name == child->basename()) return channel_of(*child);
    }
    throw std::logic_error("the device has no port or net " + name);
  }

  std::string name_of(channel of) const {
    for (const sc_core::sc_object* child : device_.device().get_child_objects()) {
      if (channel_of(*child) == of) return child->basename();
    }
    throw std::logic_error("a net has no name");
  }

  static std::vector<channel> channels(const sc_core::sc_module& module, const block& part,
                                       declaration::role where) {
    std::vector<channel> found;
    for (const sc_core::sc_port_base* port : ports_of_module(module)) {
      if (part.described(port->basename()).where == where) found.push_back(port->get_interface());
    }
    return found;
  }

  /// What a port or a block drives. A net that no selection of this way asks for is never read.
  number value_of_net(channel of) {
    const auto known = values_.find(of);
    if (known != values_.end()) return known->second;
    const auto input = inputs_.find(of);
    if (input != inputs_.end()) {
      add_input(*input->second);
      return values_.at(of);
    }
    const auto driver = drivers_.find(of);
    if (driver == drivers_.end()) throw std::logic_error("a net is driven by nothing");
    // A block asks for others in the middle of its own law.
    reading outer;
    std::swap(outer, now_);
    const number value = driven_by(*driver->second, of);
    std::swap(outer, now_);
    return values_[of] = value;
  }

  void add_input(const bound_port& port) {
    const channel of = find_channel(port.what.name);
    if (port.what.is != port::role::data || !port.what.carries) {
      values_[of] = kUnknown;
      return;
    }
    const wire_format& format = *port.what.carries;
    const std::string& name = port.what.name;
    path.definitions.push_back(fmt::format("{0}_code = int<dn>({0}_any);", name));
    path.definitions.push_back(fmt::format("{0} = {0}_code * {1};", name, dyadic(1, format.frac)));
    facts.push_back(fmt::format("{}_code in [{},{}]", name, format.min, format.max));
    values_[of] = {.text = name, .scale = format.frac};
  }

  number driven_by(const sc_core::sc_module& module, channel of) {
    now_.part = device_.parts().find(module);
    now_.instance = module.basename();
    const declaration* output = nullptr;
    for (const sc_core::sc_port_base* port : ports_of_module(module)) {
      const declaration& described = now_.part->described(port->basename());
      if (described.where == declaration::role::input) {
        now_.inputs[described.name] = port->get_interface();
      } else if (port->get_interface() == of) {
        output = &described;
      }
    }
    return net_of(of, *output);
  }

  /// Defines the net that an output drives.
  number net_of(channel of, const declaration& described) {
    const std::string net = name_of(of);
    now_.target = net;
    now_.frac = described.carries ? described.carries->frac : 0;
    const number value = value_of_output(described.name);
    if (!value.is_known || !value.if_one.empty()) return value;
    // Carries and other integers stay numbers; a number with a name is what hints speak of.
    if (value.constant && now_.frac == 0) return value;
    std::string text = value.constant ? dyadic(*value.constant, now_.frac)
                                      : at_scale({.text = value.text, .scale = value.scale}, now_.frac);
    if (text != net) path.definitions.push_back(fmt::format("{} = {};", net, text));
    number made{.text = net, .scale = now_.frac};
    if (value.scale == now_.frac) made.floored = value.floored;
    // A quotient of 0 needs no divisor.
    if (value.constant && *value.constant == 0) made.constant = 0;
    return made;
  }

  /// Blocks whose laws are many selections are taken by their words.
  number value_of_output(const std::string& name) {
    if (now_.part->words().starts_with("Divider:")) return quotient();
    if (now_.part->words().starts_with("Normaliser:")) return of_normaliser(name);
    if (now_.part->words().starts_with("Barrel shifter:")) return shifted_by_number();
    return value_of_name(name);
  }

  number quotient() {
    const number a = value_of_name("a_i");
    if (a.constant && *a.constant == 0) return a;
    const number b = value_of_name("b_i");
    return rounded_down(fmt::format("({} / {})", a.text, b.text), now_.frac);
  }

  /// a_i = m_o 2^(-zeros_o - 1): mantissa and zeros are free within their formats, which is more than there is.
  number of_normaliser(const std::string& name) {
    const number a = value_of_name("a_i");
    if (name == "zero_o") {
      number bit;
      bit.if_one = fmt::format("{} <= 0", a.text);
      bit.if_zero = fmt::format("{} >= {}", a.text, dyadic(1, a.scale));
      return bit;
    }
    const wire_format& format = *now_.part->described(name).carries;
    const bool is_mantissa = name == "m_o";
    const std::string code = now_.target + "_code";
    path.definitions.push_back(fmt::format("{0} = int<dn>({1}_any);", code, now_.target));
    facts.push_back(is_mantissa ? fmt::format("{} in [1b{},2b{}]", code, format.frac, format.frac)
                                : fmt::format("{} in [{},{}]", code, format.min, format.max));
    normalised.push_back({now_.target, a.text, a.scale, is_mantissa});
    return {.text = fmt::format("({} * {})", code, dyadic(1, format.frac)), .scale = format.frac};
  }

  /// a_i 2^-places_i: a way for each number of places, of which "<net>_weight" is the 2^-places_i. What was rounded down to
  /// the last place before is rounded down once for both.
  number shifted_by_number() {
    const std::int64_t most = now_.part->described("places_i").carries->max;
    const number places = value_of_name("places_i");
    std::int64_t taken = 0;
    while (taken < most && !chooses_next()) ++taken;
    path.conditions.push_back(fmt::format("{} >= {}", places.text, taken));
    path.conditions.push_back(fmt::format("{} <= {}", places.text, taken));
    path.definitions.push_back(fmt::format("{}_weight = 1b-{};", places.text, taken));
    const number a = value_of_name("a_i");
    const std::string& exact = a.floored.empty() ? a.text : a.floored;
    return rounded_down(fmt::format("({} * {})", exact, dyadic(1, static_cast<int>(taken))), now_.frac);
  }

  /// Names a value that is rounded down to a number of fraction bits.
  number rounded_down(const std::string& what, int frac) {
    const std::string name = new_name();
    path.definitions.push_back(fmt::format("{} = fixed<{},dn>({});", name, -frac, what));
    return {.text = name, .scale = frac, .floored = what};
  }

  std::string new_name() { return fmt::format("{}_{}", now_.target, ++counter_); }

  std::string named(const std::string& text) {
    if (is_name(text)) return text;
    const auto [known, is_new] = defined_.try_emplace(text);
    if (is_new) {
      known->second = new_name();
      path.definitions.push_back(fmt::format("{} = {};", known->second, text));
    }
    return known->second;
  }

  number value_of_name(const std::string& name) {
    const auto known = now_.names.find(name);
    if (known != now_.names.end()) return known->second;
    const auto input = now_.inputs.find(name);
    if (input != now_.inputs.end()) return now_.names[name] = value_of_net(input->second);
    const auto has_name = [&](const auto& target) { return now_.part->declarations()[target].name == name; };
    const auto driven = std::ranges::find_if(now_.part->drives(), has_name, &assignment::target);
    const auto kept = std::ranges::find_if(now_.part->registers(), has_name, &flip_flops::q);
    if (driven == now_.part->drives().end() && kept == now_.part->registers().end())
      throw std::logic_error(name + " is driven by nothing");
    return now_.names[name] =
               value_of(*(driven != now_.part->drives().end() ? driven->value : kept->d).root());
  }

  number value_of(const node& of) {
    const auto known = now_.nodes.find(&of);
    if (known != now_.nodes.end()) return known->second;
    const number value = new_value(of);
    return now_.nodes[&of] = value;
  }

  number new_value(const node& of) {
    if (of.op == operation::constant) return constant_of(static_cast<std::int64_t>(of.low));
    if (of.op == operation::signal) return value_of_name(of.name);
    if (of.op == operation::parameter) {
      const auto found = std::ranges::find(now_.part->parameters(), of.name, &instance_parameter::name);
      return constant_of(narrowed(found->value, found->carries ? found->carries->width() : 1));
    }
    std::vector<number> from;
    for (const auto& operand : of.operands) {
      if (of.op == operation::select && from.size() == 1) break;
      from.push_back(value_of(*operand));
      if (!from.back().is_known) return kUnknown;
    }
    switch (of.op) {
      case operation::add:
        return sum(from[0], from[1]);
      case operation::subtract:
        return difference(from[0], from[1]);
      case operation::multiply:
        if (from[0].constant && from[1].constant) return constant_of(*from[0].constant * *from[1].constant);
        return {.text = fmt::format("({} * {})", from[0].text, from[1].text),
                .scale = from[0].scale + from[1].scale};
      case operation::complement:
        if (from[0].constant) return constant_of(~*from[0].constant);
        return {.text = fmt::format("(- {} - {})", from[0].text, dyadic(1, from[0].scale)),
                .scale = from[0].scale};
      case operation::shift_left:
        return shifted_left(from[0], of.distance);
      case operation::shift_right:
        return shifted_right(*of.operands[0], from[0], of.distance);
      case operation::less:
        return below(from[0], from[1]);
      case operation::equal:
        return is_zero(from[0], from[1]);
      case operation::logical_or:
        return constant_of(chooses(from[0]) || chooses(from[1]) ? 1 : 0);
      case operation::bit_and:
        return lowest_bits(from[0], from[1]);
      case operation::logical_not: {
        if (from[0].constant) return constant_of(*from[0].constant == 0 ? 1 : 0);
        number made = from[0];
        std::swap(made.if_one, made.if_zero);
        return made;
      }
      case operation::select:
        return value_of(*of.operands[chooses(from[0]) ? 1 : 2]);
      case operation::lookup:
        return word(of, from[0]);
      default:
        break;
    }
    throw std::logic_error(fmt::format("block {} has a law that cannot be told to Gappa", now_.instance));
  }

  std::int64_t narrowed(std::int64_t value, int width) const {
    constexpr int kLost = 2;
    if (fault_ != planted_fault::narrow_words || width <= 2 * kLost) return value;
    return value >> kLost << kLost;
  }

  static number sum(const number& a, const number& b) {
    if (a.constant && b.constant) return constant_of(*a.constant + *b.constant);
    if (b.constant && *b.constant == 0) return a;
    if (a.constant && *a.constant == 0) return b;
    const int scale = common_scale(a, b);
    return {.text = fmt::format("({} + {})", at_scale(a, scale), at_scale(b, scale)), .scale = scale};
  }

  static number difference(const number& a, const number& b) {
    if (a.constant && b.constant) return constant_of(*a.constant - *b.constant);
    const int scale = common_scale(a, b);
    return {.text = fmt::format("({} - {})", at_scale(a, scale), at_scale(b, scale)), .scale = scale};
  }

  static number shifted_left(number a, int distance) {
    if (a.constant) return constant_of(*a.constant << distance);
    a.scale += distance;
    a.floored.clear();  // no longer to the last place
    return a;
  }

  /// What the rounding of x + k drops is that of x: k is an integer of the law.
  number shifted_right(const node& operand, const number& whole, int distance) {
    if (whole.constant) return constant_of(*whole.constant >> distance);
    std::string exact = whole.floored.empty() ? whole.text : whole.floored;
    std::string added;
    if (operand.op == operation::add) {
      for (int i = 0; i < 2; ++i) {
        const number k = value_of(*operand.operands[i == 0 ? 1 : 0]);
        const number x = value_of(*operand.operands[i == 0 ? 0 : 1]);
        if (!k.constant || x.constant) continue;
        exact = x.floored.empty() ? x.text : x.floored;
        added = dyadic(*k.constant, x.scale);
        break;
      }
    }
    if (fault_ == planted_fault::no_rounding) added.clear();
    exact = named(exact);
    const int frac = whole.scale - distance;
    if (added.empty()) return rounded_down(exact, frac);
    const std::string half_up = fmt::format("({} + {})", exact, added);
    number rounded = rounded_down(half_up, frac);
    path.hints.push_back(fmt::format("{0} - {1} -> ({0} - {2}) + {3};", rounded.text, exact, half_up, added));
    return rounded;
  }

  /// a < b as conditions on one side: integers differ by one at least.
  number below(const number& a, const number& b) {
    if (a.constant && b.constant) return constant_of(*a.constant < *b.constant ? 1 : 0);
    number made;
    if (b.constant) {
      const std::string name = named(a.text);
      made.if_one = fmt::format("{} <= {}", name, dyadic(*b.constant - 1, a.scale));
      made.if_zero = fmt::format("{} >= {}", name, dyadic(*b.constant, a.scale));
    } else if (a.constant) {
      const std::string name = named(b.text);
      made.if_one = fmt::format("{} >= {}", name, dyadic(*a.constant + 1, b.scale));
      made.if_zero = fmt::format("{} <= {}", name, dyadic(*a.constant, b.scale));
    } else {
      const number gap = difference(a, b);
      const std::string name = named(gap.text);
      made.if_one = fmt::format("{} <= {}", name, dyadic(-1, gap.scale));
      made.if_zero = fmt::format("{} >= {}", name, dyadic(0, gap.scale));
    }
    return made;
  }

  /// a == 0 for a number that is not negative.
  number is_zero(const number& a, const number& zero) const {
    if (!zero.constant || *zero.constant != 0 || a.constant)
      throw std::logic_error(fmt::format("block {} compares with what is not 0", now_.instance));
    number made;
    made.if_one = fmt::format("{} <= 0", a.text);
    made.if_zero = fmt::format("{} >= {}", a.text, dyadic(1, a.scale));
    return made;
  }

  /// a & (2^width - 1): what a is above its upper bits.
  number lowest_bits(const number& a, const number& mask) {
    if (a.constant && mask.constant) return constant_of(*a.constant & *mask.constant);
    if (!mask.constant || (*mask.constant & (*mask.constant + 1)) != 0)
      throw std::logic_error(fmt::format("block {} takes some bits of a number", now_.instance));
    int width = 0;
    while (*mask.constant >> width != 0) ++width;
    const std::string whole = named(a.floored.empty() ? a.text : a.floored);
    const std::string above = rounded_down(whole, a.scale - width).text;
    // What is cut below is not what is cut above.
    if (!a.floored.empty())
      path.hints.push_back(fmt::format("({0} - {1}) - {2} -> ({0} - {2}) - {1};", a.text, above, whole));
    return {.text = fmt::format("({} - {})", a.text, above), .scale = a.scale};
  }

  bool chooses_next() {
    if (asked_ == choices_.size()) choices_.push_back(true);
    return choices_[asked_++];
  }

  bool chooses(const number& bit) {
    if (bit.constant) return *bit.constant != 0;
    if (bit.if_one.empty())
      throw std::logic_error(
          fmt::format("block {} selects by a number that is no comparison", now_.instance));
    const bool is_one = chooses_next();
    path.conditions.push_back(is_one ? bit.if_one : bit.if_zero);
    return is_one;
  }

  number word(const node& of, const number& index) {
    if (!is_name(index.text))
      throw std::logic_error(fmt::format("memory {} has no plain address", now_.instance));
    const auto found = std::ranges::find(memories, now_.target, &memory_net::net);
    if (found == memories.end()) {
      memory_net made{now_.target, index.text, now_.frac, of.table};
      for (std::int64_t& each : made.words) each = narrowed(each, 64);
      memories.push_back(made);
    }
    return {.text = now_.target, .scale = now_.frac};
  }

  const elaborated& device_;
  const planted_fault fault_;
  std::vector<bool>& choices_;
  std::size_t asked_ = 0;
  std::map<channel, number> values_;
  std::map<channel, const bound_port*> inputs_;
  std::map<channel, const sc_core::sc_module*> drivers_;

  /// The block and the net that are read.
  struct reading {
    const block* part = nullptr;
    std::string instance, target;
    int frac = 0;  // of the net
    std::map<std::string, channel> inputs;
    std::map<std::string, number> names;
    std::map<const node*, number> nodes;
  };
  reading now_;
  int counter_ = 0;
  std::map<std::string, std::string> defined_;  // names by text
};

}  // namespace

gappa_netlist read_gappa(const elaborated& device, const std::string& result, planted_fault fault) {
  if (!sc_core::sc_start_of_simulation_invoked()) sc_core::sc_start(sc_core::SC_ZERO_TIME);
  gappa_netlist all;
  std::vector<bool> choices;
  while (true) {
    reader one(device, fault, choices);
    one.read(result);
    one.path.facts = one.facts;
    for (const memory_net& each : one.memories) {
      if (std::ranges::find(all.memories, each.net, &memory_net::net) == all.memories.end())
        all.memories.push_back(each);
    }
    for (const normalised_net& each : one.normalised) {
      if (std::ranges::find(all.normalised, each.net, &normalised_net::net) == all.normalised.end())
        all.normalised.push_back(each);
    }
    all.paths.push_back(one.path);
    while (!choices.empty() && !choices.back()) choices.pop_back();
    if (choices.empty()) return all;
    choices.back() = false;
  }
}

}  // namespace blysk::netlist
