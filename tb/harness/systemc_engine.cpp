// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/systemc_engine.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <systemc>

#include "tb/harness/layout.h"
#include "tb/netlist/elaborated.h"

namespace blysk::harness {
namespace {

using netlist::bound_port;

/// Host of a device: writes a batch into its registers, reads the results back at the leading edges of valid.
class host : public sc_core::sc_module {
 public:
  using SC_CURRENT_USER_MODULE = host;

  host(const sc_core::sc_module_name& name, const netlist::elaborated& device) : sc_core::sc_module(name) {
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
    if (clk_ == nullptr || rst_n_ == nullptr || valid_ == nullptr || trailing_.size() != 1)
      throw std::logic_error("the device's ports are not those of the strobe protocol");
    SC_METHOD(drive);
    sensitive << clk_->control().negedge_event();
    dont_initialize();
    SC_METHOD(capture);
    sensitive << valid_->control().posedge_event();
    dont_initialize();
  }

  void run(const columns& in, columns& out) {
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

  std::uint64_t cycles() const { return cycles_; }
  std::uint64_t writes() const { return writes_; }

 private:
  static constexpr std::uint64_t kResetCycles = 2;

  /// A data port, its column in the stimulus and its strobe.
  struct channel {
    bound_port* data;
    std::size_t column;
    bound_port* strobe;
    std::int64_t value;  // at the data port
    bool is_up;          // the strobe
  };

  void start(std::uint64_t cycles) {
    sc_core::sc_start(sc_core::sc_time(kClockPeriodNs, sc_core::SC_NS) * static_cast<double>(cycles));
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
  }

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

/// Ports at the top level under their names of the figure, each block's outputs under the block's name.
void record(const netlist::elaborated& device, sc_core::sc_trace_file* file) {
  for (const auto& each : device.ports()) {
    if (!each->what.is_inner) each->trace(file, each->what.wave);
  }
  for (const sc_core::sc_module* module : device.parts().modules()) {
    for (const auto& [port, trace] : device.parts().find(*module)->traces())
      trace(file, std::string(module->basename()) + "." + port);
  }
}

class engine_of_host final : public systemc_engine {
 public:
  explicit engine_of_host(const selection& asked)
      : systemc_engine(columns(asked.of().ports(asked), port::role::result).layout()),
        arguments_(arguments_of(asked)),
        device_(asked.of().elaborate(asked, kClockPeriodNs)),
        host_("host", *device_) {}
  ~engine_of_host() override { engine_of_host::stop_trace(); }

  void trace(const std::string& path) override {
    path_ = path + ".vcd";
    file_ = sc_core::sc_create_vcd_trace_file(path.c_str());
    file_->set_time_unit(1, sc_core::SC_PS);
    file_->write_comment(kWaveComment + arguments_);
    record(*device_, file_);
  }

  bool stop_trace() override {
    if (file_ == nullptr) return true;
    // SystemC writes the state at 0 as time goes on.
    if (host_.cycles() == 0) sc_core::sc_start(1, sc_core::SC_PS);
    sc_core::sc_close_vcd_trace_file(file_);
    file_ = nullptr;
    return ends_at(path_, sc_core::sc_time_stamp() / sc_core::sc_time(1, sc_core::SC_PS));
  }

  std::uint64_t cycles() const override { return host_.cycles(); }
  std::uint64_t writes() const override { return host_.writes(); }

 private:
  void compute(const columns& in, columns& out) override { host_.run(in, out); }

  std::string arguments_;  // that choose the device, for who reads the waves
  std::unique_ptr<netlist::elaborated> device_;
  host host_;
  sc_core::sc_trace_file* file_ = nullptr;
  std::string path_;
};

}  // namespace

bool ends_at(const std::string& vcd, double now_ps) {
  std::ifstream file(vcd, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(file.tellg());
  constexpr std::streamoff kTail = 1 << 16;  // the changes of a clock edge are shorter
  file.seekg(-std::min(size, kTail), std::ios::end);
  const std::string tail{std::istreambuf_iterator<char>(file), {}};
  const auto stamp = tail.rfind("\n#");
  if (!tail.ends_with('\n')) return false;
  // The values at 0 stand in $dumpvars, without a time.
  if (stamp == std::string::npos) return now_ps <= 1 && tail.find("$dumpvars") != std::string::npos;
  return std::strtod(tail.c_str() + stamp + 2, nullptr) + kClockPeriodNs * 1e3 >= now_ps;
}

std::unique_ptr<systemc_engine> make_systemc(const selection& asked) {
  return std::make_unique<engine_of_host>(asked);
}

}  // namespace blysk::harness
