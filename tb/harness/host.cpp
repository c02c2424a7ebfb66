// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/host.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <systemc>
#include <utility>
#include <vector>

#include "tb/engine.h"

namespace blysk::harness {
namespace {

using netlist::bound_port;

/// Writes a batch into the device's registers by their strobes, reads the results back at the leading edges of valid.
class strobe_host final : public sc_core::sc_module, public host {
 public:
  using SC_CURRENT_USER_MODULE = strobe_host;

  strobe_host(const sc_core::sc_module_name& name, const netlist::elaborated& device, double clock_period_ns,
              row_watcher watcher)
      : sc_core::sc_module(name), period_(clock_period_ns, sc_core::SC_NS), watcher_(std::move(watcher)) {
    for (const auto& each : device.ports()) {
      switch (each->what.is) {
        case port::role::clock:
          clk_ = each.get();
          break;
        case port::role::reset:
          rst_n_ = each.get();
          break;
        case port::role::valid:
          valid_ = each.get();
          break;
        case port::role::result:
          results_.push_back(each.get());
          break;
        case port::role::data:
          data_.push_back({each.get(), data_.size(), nullptr, 0, false});
          break;
        case port::role::strobe:
        case port::role::control:
        case port::role::start:
        case port::role::ready:
          break;
      }
    }
    for (const auto& each : device.ports()) {
      if (each->what.is != port::role::strobe) continue;
      const auto written =
          std::ranges::find(data_, each->what.writes, [](const channel& of) { return of.data->what.name; });
      if (written == data_.end()) throw std::logic_error(each->what.name + " writes no data port");
      written->strobe = each.get();
      (each->what.edge == write_edge::trailing ? trailing_ : level_).push_back(*written);
    }
    SC_METHOD(drive);
    sensitive << clk_->control().negedge_event();
    dont_initialize();
    SC_METHOD(capture);
    sensitive << valid_->control().posedge_event();
    dont_initialize();
  }

  void run(const columns& in, columns& out) override {
    if (cycles_ == 0) start(kResetCycles);
    rst_n_->write(1);
    in_ = &in;
    out_ = &out;
    next_ = 0;
    waits_ = 0;
    start((2 + settling_cycles()) * (in.size() + 1));
    in_ = nullptr;
    writes_ += in.size() + 1;
  }

  std::uint64_t cycles() const override { return cycles_; }
  std::uint64_t writes() const override { return writes_; }

 private:
  /// A data port, its column in the stimulus and its strobe.
  struct channel {
    bound_port* data;
    std::size_t column;
    bound_port* strobe;
    std::int64_t value;  // at the data port
    bool is_up;          // the strobe
  };

  void start(std::uint64_t cycles) {
    sc_core::sc_start(period_ * static_cast<double>(cycles));
    cycles_ += cycles;
  }

  // Row i goes out with the i-th pulse of the trailing strobe; one more pulse confirms the last result. The other
  // strobes go up as it goes down, so that all registers change at one edge of clk and the outputs settle once per write.
  void drive() {
    if (in_ == nullptr) return;
    channel& confirming = trailing_.front();
    if (waits_ > 0) {  // the outputs have not settled
      --waits_;
      for (channel& each : level_) strobe(each, false);
    } else if (!confirming.is_up) {
      strobe(confirming, true);
      for (channel& each : level_) strobe(each, false);
      if (next_ < in_->size()) confirming.data->write((*in_)[confirming.column].get(next_));
    } else {
      strobe(confirming, false);
      if (next_ < in_->size()) {
        for (channel& each : level_) put(each, (*in_)[each.column].get(next_));
      }
      ++next_;
      waits_ = settling_cycles();
    }
  }

  std::uint64_t settling_cycles() const { return static_cast<std::uint64_t>(valid_->what.settling_cycles); }

  // Signals are written when they change only: SystemC's kernel takes most of the time.
  static void strobe(channel& of, bool up) {
    if (of.is_up == up) return;
    of.strobe->write(up ? 1 : 0);
    of.is_up = up;
  }

  // A register that holds the value already is not written again.
  static void put(channel& to, std::int64_t value) {
    if (to.value == value) return;
    to.data->write(value);
    to.value = value;
    strobe(to, true);
  }

  void capture() {
    if (next_ == 0) return;  // what this edge confirms belongs to the previous run
    for (std::size_t i = 0; i < results_.size(); ++i) (*out_)[i].set(next_ - 1, results_[i]->read());
    if (watcher_) watcher_(next_ - 1);
  }

  sc_core::sc_time period_;
  row_watcher watcher_;

  bound_port* clk_ = nullptr;
  bound_port* rst_n_ = nullptr;
  bound_port* valid_ = nullptr;
  std::vector<channel> data_, trailing_, level_;
  std::vector<bound_port*> results_;
  const columns* in_ = nullptr;
  columns* out_ = nullptr;
  std::size_t next_ = 0;
  std::uint64_t waits_ = 0;
  std::uint64_t cycles_ = 0;
  std::uint64_t writes_ = 0;
};

/// Offers a row as soon as the device is ready, collects a row while valid is at one. Changes the inputs and looks at the
/// outputs at the falling edge of the clock.
class handshake_host final : public sc_core::sc_module, public host {
 public:
  using SC_CURRENT_USER_MODULE = handshake_host;

  handshake_host(const sc_core::sc_module_name& name, const netlist::elaborated& device,
                 double clock_period_ns)
      : sc_core::sc_module(name), period_(clock_period_ns, sc_core::SC_NS) {
    for (const auto& each : device.ports()) {
      const port::role role = each->what.is;
      if (role == port::role::clock) clk_ = each.get();
      if (role == port::role::reset) rst_n_ = each.get();
      if (role == port::role::start) start_ = each.get();
      if (role == port::role::ready) ready_ = each.get();
      if (role == port::role::valid) valid_ = each.get();
      if (role == port::role::data) data_.push_back(each.get());
      if (role == port::role::result) results_.push_back(each.get());
    }
    SC_METHOD(step);
    sensitive << clk_->control().negedge_event();
    dont_initialize();
  }

  void run(const columns& in, columns& out) override {
    if (cycles_ == 0) sc_core::sc_start(period_ * static_cast<double>(kResetCycles));
    rst_n_->write(1);
    in_ = &in;
    out_ = &out;
    taken_ = delivered_ = 0;
    idle_ = 0;
    waited_ = 0;
    sc_core::sc_start();  // until step() pauses
    in_ = nullptr;
    if (waited_ > kPatienceCycles)
      throw std::runtime_error("the device takes no row any more and does not come to its end");
    out.resize(delivered_);
    writes_ += taken_;
  }

  std::uint64_t cycles() const override { return cycles_; }
  std::uint64_t writes() const override { return writes_; }

 private:
  void step() {
    ++cycles_;
    if (in_ == nullptr) return;
    ++waited_;
    if (valid_->read() != 0) deliver();
    if (is_offered_) {
      ++taken_;
      waited_ = 0;
    }
    const bool is_ready = ready_->read() != 0;
    const bool is_offered = is_ready && taken_ < in_->size();
    if (is_offered) {
      for (std::size_t i = 0; i < data_.size(); ++i) data_[i]->write((*in_)[i].get(taken_));
    }
    if (is_offered != is_offered_) start_->write(is_offered ? 1 : 0);
    is_offered_ = is_offered;
    idle_ = is_ready && taken_ == in_->size() ? idle_ + 1 : 0;
    if (idle_ > valid_->what.settling_cycles || waited_ > kPatienceCycles) sc_core::sc_pause();
  }

  void deliver() {
    if (delivered_ == out_->size()) out_->resize(2 * delivered_ + 1);
    for (std::size_t i = 0; i < results_.size(); ++i) (*out_)[i].set(delivered_, results_[i]->read());
    ++delivered_;
  }

  sc_core::sc_time period_;
  bound_port* clk_ = nullptr;
  bound_port* rst_n_ = nullptr;
  bound_port* start_ = nullptr;
  bound_port* ready_ = nullptr;
  bound_port* valid_ = nullptr;
  std::vector<bound_port*> data_, results_;
  const columns* in_ = nullptr;
  columns* out_ = nullptr;
  bool is_offered_ = false;
  std::size_t taken_ = 0;
  std::size_t delivered_ = 0;
  int idle_ = 0;              // cycles in which the device had nothing to take
  std::uint64_t waited_ = 0;  // cycles since it took a row
  std::uint64_t cycles_ = 0;
  std::uint64_t writes_ = 0;
};

}  // namespace

std::unique_ptr<host> make_host(const netlist::elaborated& device, double clock_period_ns,
                                row_watcher watcher) {
  std::vector<port> ports;
  for (const auto& each : device.ports()) ports.push_back(each->what);
  // A second device of the process has a host of its own.
  const char* const name =
      sc_core::sc_find_object("host") == nullptr ? "host" : sc_core::sc_gen_unique_name("host");
  switch (protocol_of(ports)) {
    case protocol::strobes:
      return std::make_unique<strobe_host>(name, device, clock_period_ns, std::move(watcher));
    case protocol::handshake:
      return std::make_unique<handshake_host>(name, device, clock_period_ns);
    case protocol::none:
      break;
  }
  throw std::logic_error("the device's ports are not those of a protocol");
}

}  // namespace blysk::harness
