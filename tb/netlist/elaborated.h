// SPDX-License-Identifier: Apache-2.0
/// A device in SystemC between signals of its own: what every reader of its structure starts from.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <systemc>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "tb/netlist/block.h"
#include "tb/netlist/wire.h"
#include "tb/port.h"

namespace blysk::netlist {

/// The leaf blocks of a device, each described by itself.
class parts_list {
 public:
  /// \param blocks  a device's blocks(): a tie of its leaf modules
  template <class... Blocks>
  explicit parts_list(const std::tuple<Blocks&...>& blocks) {
    std::apply([this](const auto&... part) { (this->add(part), ...); }, blocks);
  }

  /// The block's description, or null for what is no leaf.
  const block* find(const sc_core::sc_object& module) const;

  /// The leaf modules in the order of blocks().
  const std::vector<const sc_core::sc_module*>& modules() const { return modules_; }

 private:
  template <class Block>
  requires std::is_base_of_v<sc_core::sc_module, Block>
  void add(const Block& part) { part.describe(new_block(part)); }
  /// Registers that a pipeline may have.
  template <class Block>
  void add(const std::unique_ptr<Block>& part) {
    if (part) add(*part);
  }
  void add(std::nullptr_t) {}
  block& new_block(const sc_core::sc_module& part);

  std::map<const sc_core::sc_object*, block> blocks_;
  std::vector<const sc_core::sc_module*> modules_;
};

/// A port of an elaborated device with the signal bound to it, or a net inside the device.
class bound_port {
 public:
  bound_port(port described, shape carried) : what(std::move(described)), bits(carried) {}
  virtual ~bound_port() = default;
  bound_port(const bound_port&) = delete;
  bound_port& operator=(const bound_port&) = delete;

  const port what;
  const shape bits;

  virtual std::int64_t read() const = 0;
  /// \throws std::logic_error for a net inside the device and a clock that runs by itself
  virtual void write(std::int64_t value) = 0;
  virtual void trace(sc_core::sc_trace_file* file, const std::string& name) const = 0;

  /// The wire, or null for a plain signal.
  virtual const any_wire* wire() const = 0;

  /// The signal of a port that carries one bit and no number; its events wake a test bench.
  /// \throws std::logic_error for any other port
  virtual const sc_core::sc_signal<bool>& control() const {
    throw std::logic_error(what.name + " carries a number");
  }
};

/// An elaborated device. SystemC elaborates once: a process has one, and no other module that is not made before the
/// first sc_start().
class elaborated {
 public:
  /// \param device           has pins() and blocks() as the devices of rtl_sysc have
  /// \param clock_period_ns  of the clock at its clock port, whose first rising edge is at 0; 0: a plain signal
  /// \param described        its ports, where they tell more than its type knows
  template <class Device>
  elaborated(std::unique_ptr<Device> device, double clock_period_ns,
             std::vector<port> described = ports_of<Device>());

  const sc_core::sc_module& device() const { return *device_; }
  const parts_list& parts() const { return *parts_; }

  /// A block's name within the device, "mul10" or "red.rg_sum".
  std::string path_of(const sc_core::sc_module& part) const;

  /// In the order of the device's pins().
  const std::vector<std::unique_ptr<bound_port>>& ports() const { return ports_; }

  /// \throws std::logic_error if the device has no such port
  bound_port& find(const std::string& name) const;

 private:
  template <class Device>
  class binder;

  std::vector<std::unique_ptr<bound_port>> ports_;
  std::unique_ptr<parts_list> parts_;
  std::unique_ptr<sc_core::sc_module> device_;  // last: it goes before the signals bound to it
};

/// A signal that belongs to the bound port, or a net of the device.
template <class T>
class bound_signal final : public bound_port {
 public:
  bound_signal(port described, sc_core::sc_signal<T>& signal, std::unique_ptr<sc_core::sc_signal<T>> owned,
               bool is_driven)
      : bound_port(std::move(described), shape_of<T>),
        signal_(signal),
        owned_(std::move(owned)),
        is_driven_(is_driven) {}

  std::int64_t read() const override {
    if constexpr (std::is_same_v<T, bool>) {
      return signal_.read() ? 1 : 0;
    } else {
      return signal_.read().to_int64();
    }
  }
  void write(std::int64_t value) override {
    if (!is_driven_) throw std::logic_error(what.name + " is not driven from outside");
    if constexpr (std::is_same_v<T, bool>) {
      signal_.write(value != 0);
    } else {
      signal_.write(value);
    }
  }
  void trace(sc_core::sc_trace_file* file, const std::string& name) const override {
    sc_core::sc_trace(file, signal_, name);
  }
  const any_wire* wire() const override { return dynamic_cast<const any_wire*>(&signal_); }
  const sc_core::sc_signal<bool>& control() const override {
    if constexpr (std::is_same_v<T, bool>) {
      return signal_;
    } else {
      return bound_port::control();
    }
  }

 private:
  sc_core::sc_signal<T>& signal_;
  std::unique_ptr<sc_core::sc_signal<T>> owned_;
  bool is_driven_;
};

/// What binds signals to ports, whatever the device is: compiled once for each type of a port.
class port_binder {
 protected:
  port_binder(std::vector<port> described, std::vector<std::unique_ptr<bound_port>>& ports)
      : ports_(ports), described_(std::move(described)) {}

  template <class T>
  void bind(sc_core::sc_in<T>& to) {
    bind(to, make_signal<T>(), true);
  }
  template <class T>
  void bind(sc_core::sc_out<T>& to) {
    bind(to, make_signal<T>(), false);
  }
  template <class T, class Port>
  void bind(Port& to, std::unique_ptr<sc_core::sc_signal<T>> signal, bool is_driven) {
    to(*signal);
    sc_core::sc_signal<T>& bound = *signal;
    add(bound, std::move(signal), to, is_driven);
  }

  /// A net of the device, which it owns.
  template <class T>
  void add_inner(sc_core::sc_signal<T>& net) {
    add<T>(net, nullptr, net, false);
  }

  template <class T>
  void add(sc_core::sc_signal<T>& signal, std::unique_ptr<sc_core::sc_signal<T>> owned,
           const sc_core::sc_object& object, bool is_driven) {
    ports_.push_back(
        std::make_unique<bound_signal<T>>(next_port(object), signal, std::move(owned), is_driven));
  }

 private:
  template <class T>
  static std::unique_ptr<sc_core::sc_signal<T>> make_signal() {
    return std::make_unique<netlist::wire<T>>(sc_core::sc_gen_unique_name("pin"));
  }

  /// \throws std::logic_error if the device calls it by another name
  const port& next_port(const sc_core::sc_object& object) const;

  std::vector<std::unique_ptr<bound_port>>& ports_;
  std::vector<port> described_;
};

/// Reader of a device's pins() that binds a signal to each port.
template <class Device>
class elaborated::binder : private port_binder {
 public:
  binder(Device& device, double clock_period_ns, std::vector<port> described,
         std::vector<std::unique_ptr<bound_port>>& ports)
      : port_binder(std::move(described), ports), device_(device), clock_period_ns_(clock_period_ns) {}

  template <class Member>
  void clock(Member member, const pin&) {
    if (clock_period_ns_ > 0) {
      bind<bool>(device_.*member,
                 std::make_unique<sc_core::sc_clock>(sc_core::sc_gen_unique_name("clk"),
                                                     sc_core::sc_time(clock_period_ns_, sc_core::SC_NS)),
                 false);
    } else {
      bind(device_.*member);
    }
  }
  template <class Member>
  void reset(Member member, const pin&) {
    bind(device_.*member);
  }
  template <class Member, class Format>
  void data(Member member, const pin&, Format, const char*) {
    bind(device_.*member);
  }
  template <class Member>
  void strobe(Member member, const pin&, const char*, write_edge) {
    bind(device_.*member);
  }
  template <class Member>
  void start(Member member, const pin&) {
    bind(device_.*member);
  }
  template <class Member>
  void control(Member member, const pin&) {
    bind(device_.*member);
  }
  template <class Member>
  void ready(Member member, const pin&) {
    bind(device_.*member);
  }
  template <class Member, class Format>
  void result(Member member, const pin&, Format, const char*) {
    bind(device_.*member);
  }
  template <class Member, class Format>
  void inner_result(Member member, const pin&, Format, const char*) {
    add_inner(device_.*member);
  }
  template <class Member>
  void valid(Member member, const pin&) {
    bind(device_.*member);
  }
  void settles_after(int) {}

 private:
  Device& device_;
  double clock_period_ns_;
};

template <class Device>
elaborated::elaborated(std::unique_ptr<Device> device, double clock_period_ns, std::vector<port> described) {
  binder<Device> reader(*device, clock_period_ns, std::move(described), ports_);
  Device::pins(reader);
  parts_ = std::make_unique<parts_list>(device->blocks());
  device_ = std::move(device);
}

/// Ports and direct submodules of a module, in the order of their making.
std::vector<const sc_core::sc_port_base*> ports_of_module(const sc_core::sc_object& module);
std::vector<const sc_core::sc_module*> modules_of_module(const sc_core::sc_object& module);

/// What an order of data makes of registers.
enum class registers_are { sources, transparent };

/// The leaf modules so that each comes after what drives its inputs. Registers come first as sources; transparent, they
/// come after their inputs like any other block. After elaboration.
/// \throws std::logic_error for a loop
std::vector<const sc_core::sc_module*> in_order_of_data(const elaborated& device, registers_are what);

}  // namespace blysk::netlist
