// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>

#include "tb/cosim/verilator_engine.h"

namespace blysk::cosim {

/// Engine on the class that Verilator makes of a device with the ports of fig. 1.
/// \tparam Device  has the member `top`, that class, and brdf(), the net between quant11 and multipliers 12..14
template <class Device, class Base = verilator_engine>
class verilated_quadratic : public Base {
 public:
  void run(const batch& in, results& out) override {
    out.resize(in.size());
    if (cycles_ == 0) reset();
    device_.top.rst_n = 1;
    for (std::size_t i = 0; i < in.size(); ++i) {
      lead(in.cos_delta[i]);
      if (i > 0) capture(out, i - 1);
      finish_cycle();
      trail(in, i);
      finish_cycle();
    }
    lead(0);
    if (in.size() > 0) capture(out, in.size() - 1);
    finish_cycle();
    device_.top.cos_we_i = 0;
    clock(false);
    finish_cycle();
    writes_ += in.size() + 1;
  }

  outputs apply(const pins& values) override {
    auto& top = device_.top;
    top.clk = values.clk;
    top.rst_n = values.rst_n;
    top.n_i = values.n_i;
    top.n_we_i = values.n_we_i;
    top.cos_i = static_cast<std::remove_cvref_t<decltype(top.cos_i)>>(values.cos_i);
    top.cos_we_i = values.cos_we_i;
    top.r_i = values.r_i;
    top.r_we_i = values.r_we_i;
    top.g_i = values.g_i;
    top.g_we_i = values.g_we_i;
    top.b_i = values.b_i;
    top.b_we_i = values.b_we_i;
    top.eval();
    return {top.r_o, top.g_o, top.b_o, top.valid_o != 0};
  }

  std::uint64_t cycles() const override { return cycles_; }
  std::uint64_t writes() const override { return writes_; }

 protected:
  Device device_;

 private:
  static constexpr int kResetCycles = 2;

  void clock(bool level) {
    device_.top.clk = level;
    device_.top.eval();
  }

  void finish_cycle() {
    clock(true);
    ++cycles_;
  }

  void reset() {
    apply({});
    for (int i = 0; i < kResetCycles; ++i) {
      finish_cycle();
      clock(false);
    }
  }

  // The first half of a write: 17 goes up, which confirms what the write before has made.
  void lead(std::uint32_t cos_delta) {
    auto& top = device_.top;
    top.cos_we_i = 1;
    top.n_we_i = top.r_we_i = top.g_we_i = top.b_we_i = 0;
    top.cos_i = static_cast<std::remove_cvref_t<decltype(top.cos_i)>>(cos_delta);
    clock(false);
  }

  // The second half: 17 goes down, the other strobes go up, so that all registers change at one edge of clk.
  void trail(const batch& in, std::size_t i) {
    auto& top = device_.top;
    top.cos_we_i = 0;
    top.n_we_i = top.r_we_i = top.g_we_i = top.b_we_i = 1;
    top.n_i = in.n[i];
    top.r_i = in.red_ks[i];
    top.g_i = in.green_ks[i];
    top.b_i = in.blue_ks[i];
    clock(false);
  }

  void capture(results& out, std::size_t i) const {
    out.brdf[i] = device_.brdf();
    out.red[i] = static_cast<std::int64_t>(device_.top.r_o);
    out.green[i] = static_cast<std::int64_t>(device_.top.g_o);
    out.blue[i] = static_cast<std::int64_t>(device_.top.b_o);
  }

  std::uint64_t cycles_ = 0;
  std::uint64_t writes_ = 0;
};

}  // namespace blysk::cosim
