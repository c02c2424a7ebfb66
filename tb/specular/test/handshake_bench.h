// SPDX-License-Identifier: Apache-2.0
/// A device that shades points, with start, ready and valid, in SystemC, its ports driven one cycle at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <random>
#include <systemc>
#include <vector>

#include "tb/devices/test/asked.h"
#include "tb/netlist/elaborated.h"

namespace blysk::specular {

inline constexpr double kPeriodNs = 10;

/// What is seen at the outputs before a rising edge of clk.
struct outputs {
  bool valid;
  bool ready;
  std::vector<std::int64_t> results;
  bool operator==(const outputs&) const = default;
};

/// A device between signals of its own, its ports driven one cycle at a time. One for each process: SystemC elaborates once.
class handshake_bench {
 public:
  handshake_bench()
      : asked_(test::asked_for()),
        device_(asked_.of().elaborate(asked_, kPeriodNs)),
        bit_(asked_.of().make_bit(asked_)) {
    for (const auto& each : device_->ports()) {
      const port& what = each->what;
      if (what.is == port::role::data) data_.push_back(each.get());
      if (what.is == port::role::result) results_.push_back(each.get());
      if (what.is == port::role::control) stall_ = each.get();
      if (what.is == port::role::valid) latency_ = what.settling_cycles;
    }
    sc_core::sc_start(kPeriodNs / 2, sc_core::SC_NS);  // the first falling edge of clk
    cycle(false, false, true);
  }

  const selection& asked() const { return asked_; }

  /// Clock edges from the one that takes a point to the one that finds its results.
  int latency() const { return latency_; }

  std::vector<std::int64_t> random_point() {
    std::vector<std::int64_t> codes;
    for (const netlist::bound_port* each : data_) {
      const wire_format& format = *each->what.carries;
      codes.push_back(format.min + static_cast<std::int64_t>(
                                       random_() % static_cast<std::uint64_t>(format.max - format.min + 1)));
    }
    // Small exponents and cosines near 1, where the lobe is.
    codes[0] = 1 + static_cast<std::int64_t>(random_() % 30);
    codes[1] = data_[1]->what.carries->max -
               static_cast<std::int64_t>(random_() %
                                         static_cast<std::uint64_t>(data_[1]->what.carries->max / 4 + 1));
    return codes;
  }
  bool one_in(unsigned count) { return random_() % count == 0; }

  void put(const std::vector<std::int64_t>& codes) {
    for (std::size_t i = 0; i < codes.size(); ++i) data_[i]->write(codes[i]);
  }

  /// From one falling edge of clk to the next.
  /// \return  the outputs before the rising edge between them
  outputs cycle(bool start, bool stall = false, bool reset = false) {
    device_->find("start_i").write(start ? 1 : 0);
    if (stall_ != nullptr) stall_->write(stall ? 1 : 0);
    device_->find("rst_n").write(reset ? 0 : 1);
    sc_core::sc_start(kPeriodNs / 4, sc_core::SC_NS);
    const outputs seen = now();
    sc_core::sc_start(kPeriodNs * 3 / 4, sc_core::SC_NS);
    return seen;
  }

  outputs now() const {
    outputs seen{device_->find("valid_o").read() != 0, device_->find("ready_o").read() != 0, {}};
    for (const netlist::bound_port* each : results_) seen.results.push_back(each->read());
    return seen;
  }

  /// What the bit-accurate model makes of a point.
  std::vector<std::int64_t> expected(const std::vector<std::int64_t>& codes) const {
    columns in(asked_.of().ports(asked_), port::role::data);
    columns out;
    in.resize(1);
    for (std::size_t i = 0; i < codes.size(); ++i) in[i].set(0, codes[i]);
    bit_->run(in, out);
    std::vector<std::int64_t> values;
    for (const column& each : out) values.push_back(each.get(0));
    return values;
  }

 private:
  selection asked_;
  std::unique_ptr<netlist::elaborated> device_;
  std::unique_ptr<engine> bit_;
  netlist::bound_port* stall_ = nullptr;  // of a device that has one
  std::vector<netlist::bound_port*> data_, results_;
  int latency_ = 0;
  std::mt19937_64 random_{1};
};

}  // namespace blysk::specular
