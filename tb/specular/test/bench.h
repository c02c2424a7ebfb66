// SPDX-License-Identifier: Apache-2.0
/// A device of the specular family in SystemC, its ports driven one cycle at a time.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <systemc>
#include <vector>

#include "tb/device.h"
#include "tb/netlist/elaborated.h"
#include "tb/specular/specular.h"

namespace blysk::specular::test {

constexpr double kPeriodNs = 10;
constexpr std::size_t kRegisters = 5;

/// Codes of the data ports, or what the registers hold: n, cos, r, g, b.
using codes = std::array<std::int64_t, kRegisters>;

/// One strobe for each data port.
using strobes = std::array<bool, kRegisters>;
constexpr strobes kNone{};
constexpr strobes kAll{true, true, true, true, true};

constexpr strobes only(std::size_t column) {
  strobes one{};
  one.at(column) = true;
  return one;
}

class bench {
 public:
  explicit bench(const selection& asked)
      : asked_(asked), device_(asked.of().elaborate(asked, kPeriodNs)), bit_(asked.of().make_bit(asked)) {
    for (const auto& each : device_->ports()) {
      const port& what = each->what;
      if (what.is == port::role::data) data_.push_back(each.get());
      if (what.is == port::role::result) results_.push_back(each.get());
      if (what.is == port::role::reset) reset_ = each.get();
      if (what.is == port::role::valid) valid_ = each.get();
    }
    for (const auto& each : device_->ports()) {
      if (each->what.is != port::role::strobe) continue;
      for (std::size_t i = 0; i < data_.size(); ++i) {
        if (each->what.writes == data_[i]->what.name) strobes_.at(i) = each.get();
      }
    }
    if (data_.size() != kRegisters || reset_ == nullptr || valid_ == nullptr)
      throw std::logic_error("the ports are not those of the specular family");
    for (std::size_t i = 0; i < kRegisters; ++i) {
      if (strobes_.at(i) == nullptr || strobes_.at(i)->what.edge != edge(i))
        throw std::logic_error(data_[i]->what.name + " lacks its strobe");
    }
  }

  const selection& asked() const { return asked_; }

  /// [P] fig. 3: 17 writes by its trailing edge, the other strobes by their level.
  static write_edge edge(std::size_t column) {
    return column == kCos ? write_edge::trailing : write_edge::level;
  }

  void put(const codes& data, const strobes& levels) {
    for (std::size_t i = 0; i < kRegisters; ++i) {
      data_[i]->write(data.at(i));
      strobes_.at(i)->write(levels.at(i) ? 1 : 0);
    }
  }
  void put_reset(bool is_active) { reset_->write(is_active ? 0 : 1); }

  /// Some eighths of a period; falling edges of clk are between two cycles, its rising edge is after the fourth.
  static void wait(int eighths) {
    sc_core::sc_start(sc_core::sc_time(kPeriodNs / 8, sc_core::SC_NS) * eighths);
  }
  static void cycle() { wait(8); }

  /// Cycles more that the results need after a register has changed.
  int settling_cycles() const { return valid_->what.settling_cycles; }
  void settle() const {
    for (int i = 0; i < settling_cycles(); ++i) cycle();
  }

  /// One cycle of reset, from the first falling edge of clk on.
  void reset() {
    put_reset(true);
    put({}, kNone);
    if (sc_core::sc_time_stamp() == sc_core::SC_ZERO_TIME) wait(4);
    cycle();
    put_reset(false);
  }

  /// Writes all registers and lets the outputs settle.
  void load(const codes& data) {
    put(data, kAll);
    cycle();
    put(data, kNone);
    cycle();
    settle();
  }

  bool valid() const { return valid_->read() != 0; }

  /// BRDF, red, green, blue.
  std::vector<std::int64_t> actual() const {
    std::vector<std::int64_t> values;
    for (const netlist::bound_port* each : results_) values.push_back(each->read());
    return values;
  }

  /// What the bit-accurate model makes of the registers.
  std::vector<std::int64_t> expected(const codes& held) const {
    columns in(asked_.of().ports(asked_), port::role::data);
    columns out;
    in.resize(1);
    for (std::size_t i = 0; i < kRegisters; ++i) in[i].set(0, held.at(i));
    bit_->run(in, out);
    std::vector<std::int64_t> values;
    for (const column& each : out) values.push_back(each.get(0));
    return values;
  }

  bool is_legal(const codes& held) const {
    for (std::size_t i = 0; i < kRegisters; ++i) {
      const wire_format& format = *data_[i]->what.carries;
      if (held.at(i) < format.min || held.at(i) > format.max) return false;
    }
    return true;
  }

  const wire_format& format(std::size_t column) const { return *data_.at(column)->what.carries; }

  /// A net of the device by its name.
  std::int64_t net(const std::string& name) const {
    for (const sc_core::sc_object* child : device_->device().get_child_objects()) {
      if (name != child->basename()) continue;
      std::ostringstream text;
      child->print(text);  // a signal prints its value
      return std::stoll(text.str());
    }
    throw std::logic_error("the device has no net " + name);
  }

  /// The registers' outputs.
  codes held() const { return {net("n"), net("cos_delta"), net("r_ks"), net("g_ks"), net("b_ks")}; }

 private:
  selection asked_;
  std::unique_ptr<netlist::elaborated> device_;
  std::unique_ptr<engine> bit_;
  std::vector<netlist::bound_port*> data_, results_;
  std::array<netlist::bound_port*, kRegisters> strobes_{};
  netlist::bound_port* reset_ = nullptr;
  netlist::bound_port* valid_ = nullptr;
};

}  // namespace blysk::specular::test
