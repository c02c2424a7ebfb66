// SPDX-License-Identifier: Apache-2.0
#include "tb/netlist/elaborated.h"

#include <algorithm>
#include <set>

namespace blysk::netlist {

block& parts_list::new_block(const sc_core::sc_module& part) {
  modules_.push_back(&part);
  return blocks_[&part];
}

const port& port_binder::next_port(const sc_core::sc_object& object) const {
  const port& what = described_.at(ports_.size());
  if (what.name != object.basename())
    throw std::logic_error("pins() calls " + std::string(object.basename()) + " by the name " + what.name);
  return what;
}

const block* parts_list::find(const sc_core::sc_object& module) const {
  const auto found = blocks_.find(&module);
  return found == blocks_.end() ? nullptr : &found->second;
}

std::string elaborated::path_of(const sc_core::sc_module& part) const {
  const std::string whole = part.name();
  const std::string above = std::string(device_->name()) + ".";
  if (!whole.starts_with(above)) throw std::logic_error(whole + " is no part of the device");
  return whole.substr(above.size());
}

bound_port& elaborated::find(const std::string& name) const {
  const auto found = std::ranges::find(ports_, name, [](const auto& each) { return each->what.name; });
  if (found == ports_.end()) throw std::logic_error("the device has no port " + name);
  return **found;
}

std::vector<const sc_core::sc_port_base*> ports_of_module(const sc_core::sc_object& module) {
  std::vector<const sc_core::sc_port_base*> result;
  for (const sc_core::sc_object* child : module.get_child_objects()) {
    if (const auto* port = dynamic_cast<const sc_core::sc_port_base*>(child)) result.push_back(port);
  }
  return result;
}

std::vector<const sc_core::sc_module*> modules_of_module(const sc_core::sc_object& module) {
  std::vector<const sc_core::sc_module*> result;
  for (const sc_core::sc_object* child : module.get_child_objects()) {
    if (const auto* sub = dynamic_cast<const sc_core::sc_module*>(child)) result.push_back(sub);
  }
  return result;
}

std::vector<const sc_core::sc_module*> in_order_of_data(const elaborated& device, registers_are what) {
  using role = declaration::role;
  const auto channels = [&](const sc_core::sc_module& module, role where) {
    std::vector<const sc_core::sc_interface*> found;
    const block& part = *device.parts().find(module);
    for (const sc_core::sc_port_base* port : ports_of_module(module)) {
      if (part.described(port->basename()).where == where) found.push_back(port->get_interface());
    }
    return found;
  };
  std::vector<const sc_core::sc_module*> waiting, ordered;
  std::set<const sc_core::sc_interface*> undriven;
  for (const sc_core::sc_module* module : device.parts().modules()) {
    const bool is_source =
        what == registers_are::sources && !device.parts().find(*module)->registers().empty();
    (is_source ? ordered : waiting).push_back(module);
    if (is_source) continue;
    for (const sc_core::sc_interface* channel : channels(*module, role::output)) undriven.insert(channel);
  }
  while (!waiting.empty()) {
    const auto ready = std::ranges::find_if(waiting, [&](const sc_core::sc_module* module) {
      return std::ranges::none_of(channels(*module, role::input),
                                  [&](const auto* channel) { return undriven.contains(channel); });
    });
    if (ready == waiting.end())
      throw std::logic_error(std::string(waiting.front()->name()) + " is in a loop");
    for (const sc_core::sc_interface* channel : channels(**ready, role::output)) undriven.erase(channel);
    ordered.push_back(*ready);
    waiting.erase(ready);
  }
  return ordered;
}

}  // namespace blysk::netlist
