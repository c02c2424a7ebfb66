// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/devices/quadratic.h"
#include "tb/bench/systemc_engine.h"

namespace blysk::bench {

/// Signals at the pins of a quadratic device of formats F, and the device between them.
/// The names are those of the waves: what the wire carries and its number in [P] fig. 1.
template <class F>
struct quadratic_pins : sc_core::sc_module {
  template <class Q>
  using wire = sc_core::sc_signal<typename Q::raw_t>;

  sc_core::sc_clock clk{"clk", sc_core::sc_time(kClockPeriodNs, sc_core::SC_NS)};
  sc_core::sc_signal<bool> SC_NAMED(rst_n);
  wire<typename F::n> SC_NAMED(n16);
  wire<typename F::cos_delta> SC_NAMED(cos18);
  wire<colour> SC_NAMED(red19);
  wire<colour> SC_NAMED(green21);
  wire<colour> SC_NAMED(blue23);
  sc_core::sc_signal<bool> SC_NAMED(strobe15);
  sc_core::sc_signal<bool> SC_NAMED(strobe17);
  sc_core::sc_signal<bool> SC_NAMED(strobe20);
  sc_core::sc_signal<bool> SC_NAMED(strobe22);
  sc_core::sc_signal<bool> SC_NAMED(strobe24);
  wire<typename F::out> SC_NAMED(out25_red);
  wire<typename F::out> SC_NAMED(out26_green);
  wire<typename F::out> SC_NAMED(out27_blue);
  sc_core::sc_signal<bool> SC_NAMED(valid29);
  quadratic<F> device;

  quadratic_pins(const sc_core::sc_module_name& name, const wired_constants& wired)
      : sc_core::sc_module(name), device("quadratic", wired) {
    // clang-format off
    device.clk(clk);        device.rst_n(rst_n);
    device.n_i(n16);        device.n_we_i(strobe15);
    device.cos_i(cos18);    device.cos_we_i(strobe17);
    device.r_i(red19);      device.r_we_i(strobe20);
    device.g_i(green21);    device.g_we_i(strobe22);
    device.b_i(blue23);     device.b_we_i(strobe24);
    device.r_o(out25_red);  device.g_o(out26_green);  device.b_o(out27_blue);
    device.valid_o(valid29);
    // clang-format on
  }

  /// Pins at the top level, the output of every block under the block's name.
  void record(sc_core::sc_trace_file* file) const {
    using sc_core::sc_trace;
    const auto pin = [file](const auto& signal) { sc_trace(file, signal, signal.basename()); };
    pin(clk), pin(rst_n);
    pin(strobe15), pin(n16), pin(strobe17), pin(cos18), pin(strobe20), pin(red19), pin(strobe22),
        pin(green21);
    pin(strobe24), pin(blue23), pin(out25_red), pin(out26_green), pin(out27_blue), pin(valid29);
    sc_trace(file, device.n, "rg1.q_o");
    sc_trace(file, device.cos_delta, "rg2.q_o");
    sc_trace(file, device.r_ks, "rg3.q_o");
    sc_trace(file, device.g_ks, "rg4.q_o");
    sc_trace(file, device.b_ks, "rg5.q_o");
    sc_trace(file, device.slope, "node31.y_o");
    sc_trace(file, device.offset, "node32.y_o");
    sc_trace(file, device.slope_n, "mul6.p_o");
    sc_trace(file, device.a, "add15.s_o");
    sc_trace(file, device.cos2, "mul7.p_o");
    sc_trace(file, device.cos_inv, "inv8.y_o");
    sc_trace(file, device.cos2_minus_cos, "add9.s_o");
    sc_trace(file, device.a_times_diff, "mul10.p_o");
    sc_trace(file, device.parabola, "add11.s_o");
    sc_trace(file, device.brdf, "quant11.y_o");
    sc_trace(file, out25_red, "mul12.p_o");
    sc_trace(file, out26_green, "mul13.p_o");
    sc_trace(file, out27_blue, "mul14.p_o");
  }
};

/// Host of the device: writes a batch into it, reads the results back at the leading edges of 29.
template <class F>
class quadratic_host : public sc_core::sc_module {
 public:
  explicit quadratic_host(const sc_core::sc_module_name& name, const wired_constants& wired)
      : sc_core::sc_module(name), pins("pins", wired) {
    SC_METHOD(drive);
    sensitive << pins.clk.negedge_event();
    dont_initialize();
    SC_METHOD(capture);
    sensitive << pins.valid29.posedge_event();
    dont_initialize();
  }
  using SC_CURRENT_USER_MODULE = quadratic_host;  // for SC_METHOD of SystemC 2

  void run(const batch& in, results& out) {
    if (cycles_ == 0) start(kResetCycles);
    pins.rst_n.write(true);
    out.resize(in.size());
    in_ = &in;
    out_ = &out;
    next_ = 0;
    start(2 * (in.size() + 1));
    in_ = nullptr;
    writes_ += in.size() + 1;
  }

  std::uint64_t cycles() const { return cycles_; }
  std::uint64_t writes() const { return writes_; }

  quadratic_pins<F> pins;

 private:
  static constexpr std::uint64_t kResetCycles = 2;

  void start(std::uint64_t cycles) {
    sc_core::sc_start(pins.clk.period() * static_cast<double>(cycles));
    cycles_ += cycles;
  }

  // Element i goes out with the i-th pulse of 17; one more pulse confirms the last result. The other strobes go up
  // as 17 goes down, so that all registers change at one edge of clk and the outputs settle once per write.
  void drive() {
    if (in_ == nullptr) return;
    if (!pins.strobe17.read()) {
      pins.strobe17.write(true);
      for (auto* strobe : {&pins.strobe15, &pins.strobe20, &pins.strobe22, &pins.strobe24}) {
        if (strobe->read()) strobe->write(false);
      }
      if (next_ < in_->size()) pins.cos18.write(in_->cos_delta[next_]);
    } else {
      pins.strobe17.write(false);
      if (next_ < in_->size()) {
        put(pins.n16, pins.strobe15, in_->n[next_]);
        put(pins.red19, pins.strobe20, in_->red_ks[next_]);
        put(pins.green21, pins.strobe22, in_->green_ks[next_]);
        put(pins.blue23, pins.strobe24, in_->blue_ks[next_]);
      }
      ++next_;
    }
  }

  // A register that holds the value already is not written again.
  template <class Wire>
  static void put(Wire& data, sc_core::sc_signal<bool>& strobe, unsigned value) {
    if (data.read() != value) {
      data.write(value);
      strobe.write(true);
    }
  }

  void capture() {
    if (next_ == 0) return;  // what this edge confirms belongs to the previous run
    out_->brdf[next_ - 1] = pins.device.brdf.read().to_int64();
    out_->red[next_ - 1] = pins.out25_red.read().to_int64();
    out_->green[next_ - 1] = pins.out26_green.read().to_int64();
    out_->blue[next_ - 1] = pins.out27_blue.read().to_int64();
  }

  const batch* in_ = nullptr;
  results* out_ = nullptr;
  std::size_t next_ = 0;
  std::uint64_t cycles_ = 0;
  std::uint64_t writes_ = 0;
};

/// Defined for every named format and both lobes.
template <class Q, lobe Lobe>
std::unique_ptr<systemc_engine> make_quadratic(const wired_constants& wired);

}  // namespace blysk::bench
