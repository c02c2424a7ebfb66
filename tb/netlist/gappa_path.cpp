// SPDX-License-Identifier: Apache-2.0
#include "tb/netlist/gappa_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
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

  void read(const std::string& result) {
    const auto modules = in_order_of_data(device_, registers_are::transparent);
    std::set<channel> nets{find_channel(result)};
    const std::set<const sc_core::sc_module*> wanted = cone_of(modules, nets);
    for (const auto& port : device_.ports()) {
      if (port->what.is_input() && nets.contains(find_channel(port->what.name))) add_input(*port);
    }
    for (const sc_core::sc_module* module : modules) {
      if (!wanted.contains(module)) continue;
      translate(*module, *device_.parts().find(*module));
    }
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

  /// The modules that the nets depend on; the nets between them are added.
  std::set<const sc_core::sc_module*> cone_of(const std::vector<const sc_core::sc_module*>& modules,
                                              std::set<channel>& nets) const {
    std::set<const sc_core::sc_module*> cone;
    for (auto each = modules.rbegin(); each != modules.rend(); ++each) {
      const block& part = *device_.parts().find(**each);
      const auto outputs = channels(**each, part, declaration::role::output);
      if (std::ranges::none_of(outputs, [&](channel of) { return nets.contains(of); })) continue;
      cone.insert(*each);
      for (channel of : channels(**each, part, declaration::role::input)) nets.insert(of);
    }
    return cone;
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

  void translate(const sc_core::sc_module& module, const block& part) {
    part_ = &part;
    names_.clear();
    nodes_.clear();
    instance_ = module.basename();
    for (const sc_core::sc_port_base* port : ports_of_module(module)) {
      const declaration& described = part.described(port->basename());
      if (described.where == declaration::role::input)
        names_[described.name] = values_.at(port->get_interface());
    }
    for (const sc_core::sc_port_base* port : ports_of_module(module)) {
      const declaration& described = part.described(port->basename());
      if (described.where == declaration::role::output)
        values_[port->get_interface()] = net_of(port->get_interface(), described);
    }
  }

  /// Defines the net that an output drives.
  number net_of(channel of, const declaration& described) {
    const std::string net = name_of(of);
    target_ = net;
    frac_ = described.carries ? described.carries->frac : 0;
    const number value = is_divider() ? quotient() : value_of_name(described.name);
    if (!value.is_known || !value.if_one.empty()) return value;
    // Carries and other integers stay numbers; a number with a name is what hints speak of.
    if (value.constant && frac_ == 0) return value;
    std::string text = value.constant ? dyadic(*value.constant, frac_)
                                      : at_scale({.text = value.text, .scale = value.scale}, frac_);
    if (text != net) path.definitions.push_back(fmt::format("{} = {};", net, text));
    return {.text = net, .scale = frac_, .floored = value.scale == frac_ ? value.floored : ""};
  }

  bool is_divider() const { return part_->words().starts_with("Divider:"); }

  number quotient() {
    const number& a = names_.at("a_i");
    const number& b = names_.at("b_i");
    return rounded_down(fmt::format("({} / {})", a.text, b.text), frac_);
  }

  /// Names a value that is rounded down to a number of fraction bits.
  number rounded_down(const std::string& what, int frac) {
    const std::string name = new_name();
    path.definitions.push_back(fmt::format("{} = fixed<{},dn>({});", name, -frac, what));
    return {.text = name, .scale = frac, .floored = what};
  }

  std::string new_name() { return fmt::format("{}_{}", target_, ++counter_); }

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
    const auto known = names_.find(name);
    if (known != names_.end()) return known->second;
    const auto has_name = [&](const auto& target) { return part_->declarations()[target].name == name; };
    const auto driven = std::ranges::find_if(part_->drives(), has_name, &assignment::target);
    const auto kept = std::ranges::find_if(part_->registers(), has_name, &flip_flops::q);
    if (driven == part_->drives().end() && kept == part_->registers().end())
      throw std::logic_error(name + " is driven by nothing");
    return names_[name] = value_of(*(driven != part_->drives().end() ? driven->value : kept->d).root());
  }

  number value_of(const node& of) {
    const auto known = nodes_.find(&of);
    if (known != nodes_.end()) return known->second;
    const number value = new_value(of);
    return nodes_[&of] = value;
  }

  number new_value(const node& of) {
    if (of.op == operation::constant) return constant_of(static_cast<std::int64_t>(of.low));
    if (of.op == operation::signal) return value_of_name(of.name);
    if (of.op == operation::parameter) {
      const auto found = std::ranges::find(part_->parameters(), of.name, &instance_parameter::name);
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
    throw std::logic_error(fmt::format("block {} has a law that cannot be told to Gappa", instance_));
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

  bool chooses(const number& bit) {
    if (bit.constant) return *bit.constant != 0;
    if (bit.if_one.empty())
      throw std::logic_error(fmt::format("block {} selects by a number that is no comparison", instance_));
    if (asked_ == choices_.size()) choices_.push_back(true);
    const bool is_one = choices_[asked_++];
    path.conditions.push_back(is_one ? bit.if_one : bit.if_zero);
    return is_one;
  }

  number word(const node& of, const number& index) {
    if (!is_name(index.text))
      throw std::logic_error(fmt::format("memory {} has no plain address", instance_));
    const auto found = std::ranges::find(memories, target_, &memory_net::net);
    if (found == memories.end()) {
      memory_net made{target_, index.text, frac_, of.table};
      for (std::int64_t& each : made.words) each = narrowed(each, 64);
      memories.push_back(made);
    }
    return {.text = target_, .scale = frac_};
  }

  const elaborated& device_;
  const planted_fault fault_;
  std::vector<bool>& choices_;
  std::size_t asked_ = 0;
  std::map<channel, number> values_;
  const block* part_ = nullptr;
  std::string instance_, target_;  // the block and the net that are read
  int frac_ = 0;                   // of the net
  int counter_ = 0;
  std::map<std::string, number> names_;
  std::map<const node*, number> nodes_;
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
    all.facts = one.facts;
    all.memories = one.memories;
    all.paths.push_back(one.path);
    while (!choices.empty() && !choices.back()) choices.pop_back();
    if (choices.empty()) return all;
    choices.back() = false;
  }
}

}  // namespace blysk::netlist
