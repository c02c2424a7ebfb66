// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/systemc_engine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <systemc>
#include <utility>

#include "tb/harness/arguments.h"
#include "tb/harness/delay_lines.h"
#include "tb/harness/host.h"
#include "tb/harness/value_recorder.h"
#include "tb/wave_values.h"

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

/// \tparam Interface  what the engine is to its user
template <class Interface>
class engine_of_host : public Interface {
 public:
  engine_of_host(const selection& asked, double period_ns, row_watcher watcher = {})
      : Interface(columns(asked.of().ports(asked), port::role::result).layout()),
        asked_(asked),
        period_ns_(period_ns),
        device_(asked.of().elaborate(asked, period_ns)),
        host_(make_host(*device_, period_ns, std::move(watcher))) {}
  ~engine_of_host() override {
    if (file_ != nullptr) sc_core::sc_close_vcd_trace_file(file_);
  }

  void trace(const std::string& path) override {
    path_ = path;
    // SystemC appends the ending.
    file_ = sc_core::sc_create_vcd_trace_file(path.substr(0, path.rfind('.')).c_str());
    file_->set_time_unit(1, sc_core::SC_PS);
    if (this->has_deltas()) file_->delta_cycles(true);
    try {
      file_->write_comment(kWaveComment + arguments_of(asked_));  // opens it
    } catch (const sc_core::sc_report&) {
      throw std::runtime_error(
          fmt::format("the file of the waves cannot be opened ({})", std::strerror(errno)));
    }
    record(*device_, file_);
    values_ = std::make_unique<value_recorder>(
        sc_core::sc_find_object("values") == nullptr ? "values" : sc_core::sc_gen_unique_name("values"),
        *device_, wave_values(asked_.of().ports(asked_), asked_.of().make_golden(asked_)), file_);
  }

  bool stop_trace() override {
    if (file_ == nullptr) return true;
    // SystemC writes the state at 0 as time goes on.
    if (host_->cycles() == 0) sc_core::sc_start(1, sc_core::SC_PS);
    sc_core::sc_close_vcd_trace_file(file_);
    file_ = nullptr;
    return ends_at(path_, sc_core::sc_time_stamp() / sc_core::sc_time(1, sc_core::SC_PS), period_ns_);
  }

  std::uint64_t cycles() const override { return host_->cycles(); }
  std::uint64_t writes() const override { return host_->writes(); }

 protected:
  void compute(const columns& in, columns& out) override { host_->run(in, out); }

  const netlist::elaborated& device() const { return *device_; }

 private:
  selection asked_;
  double period_ns_;
  std::unique_ptr<netlist::elaborated> device_;
  std::unique_ptr<host> host_;
  std::unique_ptr<value_recorder> values_;
  sc_core::sc_trace_file* file_ = nullptr;
  std::string path_;
};

class engine_with_delays final : public engine_of_host<timed_engine> {
 public:
  engine_with_delays(const selection& asked, device_delays delays, double period_ns)
      : engine_of_host(asked, period_ns, [this](std::size_t row) { note(row); }),
        delays_(std::move(delays)),
        lines_("delays"),
        half_period_(static_cast<picoseconds>(std::llround(period_ns * 500))) {
    lines_.delay(device(), delays_);
    for (const auto& each : device().ports()) {
      if (each->what.is == port::role::result && !each->what.is_inner) outputs_.push_back(each->wire());
    }
  }

  const std::vector<write_timing>& timings() const override { return timings_; }

 private:
  void compute(const columns& in, columns& out) override {
    timings_.assign(in.size(), {});
    engine_of_host::compute(in, out);
  }

  void note(std::size_t row) {
    const picoseconds now = now_ps();
    const picoseconds loaded_at = now - half_period_;
    write_timing& timing = timings_.at(row);
    timing.read_at = now;
    lines_.find_activity();
    for (const netlist::any_wire* output : outputs_) {
      const wire_history& history = lines_.history(*output);
      const auto after = [&](picoseconds at) { return at > loaded_at ? at - loaded_at : 0; };
      timing.settled_after = std::max(timing.settled_after, after(history.changed_at));
      timing.busy_for = std::max(timing.busy_for, after(history.busy_until));
    }
  }

  device_delays delays_;
  delay_lines lines_;
  picoseconds half_period_;
  std::vector<const netlist::any_wire*> outputs_;
  std::vector<write_timing> timings_;
};

}  // namespace

bool ends_at(const std::string& vcd, double now_ps, double clock_period_ns) {
  std::ifstream file(vcd, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(file.tellg());
  constexpr std::streamoff kTail = 1 << 16;  // the changes of a clock edge are shorter
  file.seekg(-std::min(size, kTail), std::ios::end);
  const std::string tail{std::istreambuf_iterator<char>(file), {}};
  const auto stamp = tail.rfind("\n#");
  if (!tail.ends_with('\n')) return false;
  // The values at 0 stand in $dumpvars, without a time.
  if (stamp == std::string::npos) return now_ps <= 1 && tail.find("$dumpvars") != std::string::npos;
  return std::strtod(tail.c_str() + stamp + 2, nullptr) + clock_period_ns * 1e3 >= now_ps;
}

std::unique_ptr<systemc_engine> make_systemc(const selection& asked) {
  return std::make_unique<engine_of_host<systemc_engine>>(asked, kClockPeriodNs);
}

std::unique_ptr<timed_engine> make_timed(const selection& asked, device_delays delays, double period_ns) {
  if (protocol_of(asked.of().ports(asked)) != protocol::strobes) {
    throw std::invalid_argument(fmt::format(
        "engine timed shows how outputs settle before a strobe and device {} has none, expected a "
        "device with strobes",
        asked.of().name()));
  }
  return std::make_unique<engine_with_delays>(asked, std::move(delays), period_ns);
}

}  // namespace blysk::harness
