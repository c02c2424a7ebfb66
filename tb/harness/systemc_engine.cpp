// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/systemc_engine.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <systemc>

#include "tb/harness/arguments.h"
#include "tb/harness/host.h"

namespace blysk::harness {
namespace {

/// Ports at the top level under their names of the figure, each block's outputs under the block's path.
void record(const netlist::elaborated& device, sc_core::sc_trace_file* file) {
  for (const auto& each : device.ports()) {
    if (!each->what.is_inner) each->trace(file, each->what.wave);
  }
  for (const sc_core::sc_module* module : device.parts().modules()) {
    for (const auto& [port, trace] : device.parts().find(*module)->traces())
      trace(file, device.path_of(*module) + "." + port);
  }
}

class engine_of_host final : public systemc_engine {
 public:
  explicit engine_of_host(const selection& asked)
      : systemc_engine(columns(asked.of().ports(asked), port::role::result).layout()),
        arguments_(arguments_of(asked)),
        device_(asked.of().elaborate(asked, kClockPeriodNs)),
        host_(make_host(*device_)) {}
  ~engine_of_host() override { engine_of_host::stop_trace(); }

  void trace(const std::string& path) override {
    path_ = path;
    // SystemC appends the ending.
    file_ = sc_core::sc_create_vcd_trace_file(path.substr(0, path.rfind('.')).c_str());
    file_->set_time_unit(1, sc_core::SC_PS);
    file_->write_comment(kWaveComment + arguments_);
    record(*device_, file_);
  }

  bool stop_trace() override {
    if (file_ == nullptr) return true;
    // SystemC writes the state at 0 as time goes on.
    if (host_->cycles() == 0) sc_core::sc_start(1, sc_core::SC_PS);
    sc_core::sc_close_vcd_trace_file(file_);
    file_ = nullptr;
    return ends_at(path_, sc_core::sc_time_stamp() / sc_core::sc_time(1, sc_core::SC_PS));
  }

  std::uint64_t cycles() const override { return host_->cycles(); }
  std::uint64_t writes() const override { return host_->writes(); }

 private:
  void compute(const columns& in, columns& out) override { host_->run(in, out); }

  std::string arguments_;  // that choose the device, for who reads the waves
  std::unique_ptr<netlist::elaborated> device_;
  std::unique_ptr<host> host_;
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
