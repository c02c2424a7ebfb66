// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/settling_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <systemc>
#include <utility>

#include "tb/harness/delay_lines.h"
#include "tb/netlist/elaborated.h"

namespace blysk::harness {

using netlist::bound_port;

/// Moves clock and strobes by hand, as the host of the SystemC engine does by a clock.
class settling_bench::driver final : public sc_core::sc_module {
 public:
  using SC_CURRENT_USER_MODULE = driver;

  driver(const selection& asked, device_delays delays)
      : sc_core::sc_module(sc_core::sc_module_name("driver")),
        delays_(std::move(delays)),
        device_(asked.of().elaborate(asked, 0)),
        lines_("delays") {
    if (protocol_of(asked.of().ports(asked)) != protocol::strobes) {
      throw std::invalid_argument(fmt::format(
          "device {} has no strobe that its outputs settle before, expected a device with strobes",
          asked.of().name()));
    }
    lines_.delay(*device_, delays_);
    for (const auto& each : device_->ports()) {
      if (each->what.is == port::role::clock) clk_ = each.get();
      if (each->what.is == port::role::reset) rst_n_ = each.get();
      if (each->what.is == port::role::valid) valid_ = each.get();
      if (each->what.is == port::role::data) data_.push_back(each.get());
      if (each->what.is == port::role::result && !each->what.is_inner) results_.push_back(each.get());
      if (each->what.is == port::role::strobe)
        (each->what.edge == write_edge::trailing ? trailing_ : level_).push_back(each.get());
    }
    SC_METHOD(capture);
    sensitive << valid_->control().posedge_event();
    dont_initialize();
  }

  /// \param gap_ps  0: the strobe is not raised before all is quiet
  void write(const write_codes& codes, std::uint64_t gap_ps) {
    if (writes_ == 0) reset();
    for (std::size_t i = 0; i < data_.size(); ++i) data_[i]->write(codes.at(i));
    raise(trailing_, true);
    cycle();
    raise(trailing_, false);
    raise(level_, true);
    run(kPausePs);
    for (int more = valid_->what.settling_cycles; more > 0; --more) {
      rise();
      raise(level_, false);
      settle();
      fall();
    }
    rise();
    loaded_at_ = now_ps();
    if (gap_ps > 0) {
      run(gap_ps);
      raise(trailing_, true);
      run(kPausePs);
      settle();
      raise(trailing_, false);
      raise(level_, false);
      // The trailing edge belongs to the same data: the clock does not see this strobe.
      run(kPausePs);
    } else {
      settle();
      raise(level_, false);
    }
    fall();
    ++writes_;
  }

  settled_write history() {
    settled_write result;
    lines_.find_activity();
    for (const bound_port* each : results_) {
      const wire_history& of = lines_.history(*each->wire());
      if (of.busy_until > loaded_at_) result.busy_for = std::max(result.busy_for, of.busy_until - loaded_at_);
      if (of.changed_at <= loaded_at_ || of.changed_at - loaded_at_ <= result.after) continue;
      result.after = of.changed_at - loaded_at_;
      result.output = each->what.wave;
      result.bit = 63 - std::countl_zero(of.changed_bits);
    }
    return result;
  }

  std::vector<std::int64_t> outputs() const {
    std::vector<std::int64_t> values;
    for (const bound_port* each : results_) values.push_back(each->read());
    return values;
  }

  const std::vector<std::int64_t>& captured() const { return captured_; }
  std::uint64_t writes() const { return writes_; }

 private:
  static constexpr std::uint64_t kPausePs = 100;

  void capture() { captured_ = outputs(); }

  static void raise(const std::vector<bound_port*>& strobes, bool up) {
    for (bound_port* each : strobes) each->write(up ? 1 : 0);
  }
  static void run(std::uint64_t ps) {
    sc_core::sc_start(sc_core::sc_time(static_cast<double>(ps), sc_core::SC_PS));
  }
  void rise() { clk_->write(1); }
  void fall() {
    clk_->write(0);
    run(kPausePs);
  }
  void cycle() {
    run(kPausePs);
    rise();
    settle();
    fall();
  }

  /// Goes on until nothing is pending.
  void settle() {
    run(1);
    for (picoseconds next = lines_.next(); next != kNothing; next = lines_.next())
      run(next > now_ps() ? next - now_ps() + 1 : 1);
  }

  void reset() {
    rst_n_->write(0);
    clk_->write(0);
    settle();
    cycle();
    cycle();
    rst_n_->write(1);
  }

  static constexpr picoseconds kNothing = std::numeric_limits<picoseconds>::max();

  device_delays delays_;
  std::unique_ptr<netlist::elaborated> device_;
  delay_lines lines_;
  bound_port* clk_ = nullptr;
  bound_port* rst_n_ = nullptr;
  bound_port* valid_ = nullptr;
  std::vector<bound_port*> data_, results_, trailing_, level_;
  std::vector<std::int64_t> captured_;
  picoseconds loaded_at_ = 0;
  std::uint64_t writes_ = 0;
};

settling_bench::settling_bench(const selection& asked, device_delays delays)
    : driver_(std::make_unique<driver>(asked, std::move(delays))) {}
settling_bench::~settling_bench() = default;

settled_write settling_bench::write(const write_codes& codes) {
  driver_->write(codes, 0);
  return driver_->history();
}

std::vector<std::int64_t> settling_bench::read_after(const write_codes& codes, std::uint64_t gap_ps) {
  driver_->write(codes, gap_ps);
  return driver_->captured();
}

std::vector<std::int64_t> settling_bench::outputs() const {
  return driver_->outputs();
}

std::uint64_t settling_bench::writes() const {
  return driver_->writes();
}

}  // namespace blysk::harness
