// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/value_recorder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <span>
#include <string>
#include <utility>

namespace blysk::harness {

value_recorder::value_recorder(const sc_core::sc_module_name& name, const netlist::elaborated& device,
                               wave_values values, sc_core::sc_trace_file* file)
    : sc_core::sc_module(name),
      device_(device),
      values_(std::move(values)),
      levels_(device.ports().size()),
      shown_(values_.names().size()) {
  for (std::size_t i = 0; i < shown_.size(); ++i)
    sc_core::sc_trace(file, shown_[i], std::string(kValueScope) + "." + values_.names()[i]);
  SC_METHOD(rise);
  for (const auto& each : device.ports()) {
    if (each->what.is == port::role::clock) sensitive << each->control().posedge_event();
  }
  dont_initialize();
  SC_METHOD(show);
  for (const sc_core::sc_object* object : device.device().get_child_objects()) {
    const auto known = std::ranges::find(device.ports(), std::string(object->basename()),
                                         [](const auto& each) { return each->what.name; });
    if (known == device.ports().end()) continue;
    const port& what = (*known)->what;
    if (value_name(what).empty() && what.is != port::role::valid) continue;
    if (const auto* const bound = dynamic_cast<const sc_core::sc_port_base*>(object)) sensitive << *bound;
    if (const auto* const net = dynamic_cast<const sc_core::sc_interface*>(object)) sensitive << *net;
  }
}

const std::vector<std::int64_t>& value_recorder::levels() {
  std::ranges::transform(device_.ports(), levels_.begin(), [](const auto& each) { return each->read(); });
  return levels_;
}

void value_recorder::rise() {
  values_.rise(levels());
  show();
}

void value_recorder::show() {
  const std::span<const double> now = values_.at(levels());
  std::ranges::copy(now.first(now.size() - 1), shown_.begin());
  if (now.back() == error_) return;
  error_ = now.back();
  shown_.back() = std::strtod(fmt::format("{:.6g}", error_).c_str(), nullptr);
}

}  // namespace blysk::harness
