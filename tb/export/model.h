// SPDX-License-Identifier: Apache-2.0
/// A device between signals of its own: what the exporter reads, and what a bench can run.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <systemc>
#include <type_traits>
#include <vector>

#include "tb/export/netlist.h"

namespace blysk::verilog {

/// A port of the device, and the signal bound to it.
struct pin {
  std::string name;
  std::string note;  ///< number in the figure, meaning, format
  bool is_input;
  shape bits;
  std::optional<wire_format> carries;
  std::function<std::int64_t()> read;
  std::function<void(std::int64_t)> write;
};

/// What a device's pins() talk to.
class pin_reader {
 public:
  /// \param note    number in the figure and meaning
  /// \param format  Q-format of what the pin carries, if it is a number
  template <class T, class Format = no_format>
  void pin(sc_core::sc_in<T>& port, const std::string& note, Format format = {}) {
    add<T>(port, true, note, format_of(format));
  }
  template <class T, class Format = no_format>
  void pin(sc_core::sc_out<T>& port, const std::string& note, Format format = {}) {
    add<T>(port, false, note, format_of(format));
  }

  const std::vector<verilog::pin>& pins() const { return pins_; }

 private:
  template <class T, class Port>
  void add(Port& port, bool is_input, const std::string& note, const std::optional<wire_format>& carries) {
    auto signal = std::make_shared<sc_core::sc_signal<T>>(sc_core::sc_gen_unique_name("pin"));
    port(*signal);
    const auto read = [signal]() -> std::int64_t {
      if constexpr (std::is_same_v<T, bool>) {
        return signal->read() ? 1 : 0;
      } else {
        return signal->read().to_int64();
      }
    };
    pins_.push_back({port.basename(), note + (carries ? ", " + carries->note() : ""), is_input, shape_of<T>,
                     carries, read, [signal](std::int64_t value) { signal->write(static_cast<T>(value)); }});
  }

  std::vector<verilog::pin> pins_;
};

/// An elaborated device. SystemC elaborates once: a process has one, and no other module.
class model {
 public:
  /// \param device   has pins() and blocks() as quadratic.h has
  /// \param options  what the device is besides its name and format, in words
  template <class Device>
  model(std::unique_ptr<Device> device, const std::string& options) : options_(options) {
    device->pins(pins_);
    sc_core::sc_start(sc_core::SC_ZERO_TIME);  // elaborates
    parts_ = std::make_unique<parts_list>(device->blocks());
    device_ = std::move(device);
  }

  const sc_core::sc_module& device() const { return *device_; }
  const parts_list& parts() const { return *parts_; }
  const std::vector<pin>& pins() const { return pins_.pins(); }
  const std::string& options() const { return options_; }

 private:
  std::string options_;
  pin_reader pins_;
  std::unique_ptr<parts_list> parts_;
  std::unique_ptr<sc_core::sc_module> device_;  // last: it goes before the signals bound to it
};

}  // namespace blysk::verilog
