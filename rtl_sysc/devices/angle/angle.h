// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/blocks/scan_control.h"
#include "rtl_sysc/devices/angle/formats.h"
#include "rtl_sysc/pin.h"

#include <tuple>

namespace blysk {

/// The parts of patent UA 71489; what derives from it takes the output of rom1 and drives the net brdf.
template <class Formats>
struct angle_path : sc_core::sc_module {
  template <class Q>
  using in = sc_core::sc_in<typename Q::raw_t>;
  template <class Q>
  using out = sc_core::sc_out<typename Q::raw_t>;
  template <class Q>
  using net = sc_core::sc_signal<typename Q::raw_t>;
  template <class Q>
  using reg = reg_level<Q>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  in<typename Formats::n> SC_NAMED(n_i);
  in<typename Formats::intensity> SC_NAMED(intensity_i);
  in<typename Formats::start> SC_NAMED(angle_i);
  in<typename Formats::step> SC_NAMED(step_i);
  in<typename Formats::count> SC_NAMED(count_i);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_out<bool> SC_NAMED(ready_o);
  out<typename Formats::out> SC_NAMED(out_o);
  sc_core::sc_out<bool> SC_NAMED(valid_o);

  scan_control SC_NAMED(control);
  reg<typename Formats::intensity> SC_NAMED(rg1);
  reg<typename Formats::step> SC_NAMED(rg2);
  reg<typename Formats::start> SC_NAMED(rg3);
  reg<typename Formats::angle> SC_NAMED(rg4);
  reg<typename Formats::n> SC_NAMED(rg5);
  typename Formats::cnt SC_NAMED(cnt);
  typename Formats::dec dec;
  constant<carry> ground;
  typename Formats::add4 SC_NAMED(add4);
  typename Formats::mux SC_NAMED(mux);
  typename Formats::mag4 SC_NAMED(mag4);
  typename Formats::limit4 SC_NAMED(limit4);
  typename Formats::rom2 rom2;
  typename Formats::mul2 SC_NAMED(mul2);
  typename Formats::quant2 SC_NAMED(quant2);
  typename Formats::rom1 rom1;
  typename Formats::mul1 SC_NAMED(mul1);

  sc_core::sc_signal<bool> SC_NAMED(load);
  sc_core::sc_signal<bool> SC_NAMED(first);
  sc_core::sc_signal<bool> SC_NAMED(advance);
  sc_core::sc_signal<bool> SC_NAMED(last);
  net<carry> SC_NAMED(ground_in);
  net<typename Formats::intensity> SC_NAMED(intensity);
  net<typename Formats::step> SC_NAMED(step);
  net<typename Formats::start> SC_NAMED(start_angle);
  net<typename Formats::n> SC_NAMED(n);
  net<typename Formats::part> SC_NAMED(part);
  net<typename Formats::angle> SC_NAMED(sum);
  net<typename Formats::angle> SC_NAMED(next_angle);
  net<typename Formats::angle> SC_NAMED(current_angle);
  net<typename Formats::distance> SC_NAMED(distance);
  net<typename Formats::limited> SC_NAMED(limited);
  net<typename Formats::factor> SC_NAMED(factor);
  net<typename Formats::turned> SC_NAMED(turned);
  net<typename Formats::place> SC_NAMED(place);
  net<typename Formats::brdf> SC_NAMED(brdf);

  /// What the two memories hold.
  struct contents {
    int powers;  ///< k of [A], 1..kMostPowers
    typename Formats::rom1::memory rom1;
    typename Formats::rom2::memory rom2;
  };

  /// \param words  of Formats' widths
  angle_path(const sc_core::sc_module_name& name, const contents& words)
      : sc_core::sc_module(name),
        dec("dec", words.powers),
        ground("ground", 0),
        rom2("rom2", words.rom2),
        rom1("rom1", words.rom1, static_cast<std::size_t>(words.powers) << Formats::address_bits) {
    static_assert(Formats::no_overflow());
    // clang-format off
    control.clk(clk);  control.rst_n(rst_n);  control.start_i(start_i);  control.carry_i(last);
    control.load_o(load);  control.first_o(first);  control.step_o(advance);  control.draw_o(valid_o);
    control.ready_o(ready_o);
    cnt.clk(clk);  cnt.rst_n(rst_n);  cnt.load_i(load);  cnt.count_i(valid_o);
    cnt.d_i(count_i);                                                                        cnt.carry_o(last);
    rg1.clk(clk);  rg1.rst_n(rst_n);  rg1.d_i(intensity_i);  rg1.we_i(load);                 rg1.q_o(intensity);
    rg2.clk(clk);  rg2.rst_n(rst_n);  rg2.d_i(step_i);       rg2.we_i(load);                 rg2.q_o(step);
    rg3.clk(clk);  rg3.rst_n(rst_n);  rg3.d_i(angle_i);      rg3.we_i(load);                 rg3.q_o(start_angle);
    rg4.clk(clk);  rg4.rst_n(rst_n);  rg4.d_i(next_angle);   rg4.we_i(advance);              rg4.q_o(current_angle);
    rg5.clk(clk);  rg5.rst_n(rst_n);  rg5.d_i(n_i);          rg5.we_i(load);                 rg5.q_o(n);
    ground.y_o(ground_in);
    add4.a_i(current_angle);  add4.b_i(step);           add4.carry_i(ground_in);             add4.s_o(sum);
    mux.a_i(sum);             mux.b_i(start_angle);     mux.select_b_i(first);               mux.y_o(next_angle);
    mag4.a_i(current_angle);                                                                 mag4.y_o(distance);
    limit4.a_i(distance);                                                                    limit4.y_o(limited);
    rom2.a_i(n);                                                                             rom2.y_o(factor);
    mul2.a_i(limited);        mul2.b_i(factor);                                              mul2.p_o(turned);
    quant2.a_i(turned);                                                                      quant2.y_o(place);
    dec.n_i(n);                                                                              dec.part_o(part);
    rom1.part_i(part);        rom1.a_i(place);
    mul1.a_i(brdf);           mul1.b_i(intensity);                                           mul1.p_o(out_o);
    // clang-format on
  }

  /// The ports and what they are for; [P] gives them no numbers. ready_o is the output "end" of the figure.
  template <class Reader>
  static void pins(Reader& reader) {
    using d = angle_path;
    reader.clock(&d::clk, {"clk", "", "clk", "clock"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "synchronous, active low"});
    reader.data(&d::n_i, {"n_i", "", "exponent", "n, to register 5"}, typename Formats::n{}, "n");
    reader.data(&d::intensity_i, {"intensity_i", "", "light", "intensity, to register 1"},
                typename Formats::intensity{}, "intensity");
    reader.data(&d::angle_i, {"angle_i", "", "angle_start", "angle of the first pixel, rad, to register 3"},
                typename Formats::start{}, "start");
    reader.data(&d::step_i, {"step_i", "", "angle_step", "from pixel to pixel, rad, to register 2"},
                typename Formats::step{}, "step");
    reader.data(&d::count_i, {"count_i", "", "pixels", "pixels of the line, to the counter"},
                typename Formats::count{}, "count");
    reader.start(&d::start_i, {"start_i", "", "start", "takes the inputs while ready_o is one"});
    reader.ready(&d::ready_o, {"ready_o", "", "ready", "the line has ended, start_i takes the next"});
    reader.inner_result(&d::current_angle, {"current_angle", "", "angle", "angle of the pixel, rad"},
                        typename Formats::angle{}, "angle");
    const char* const reflectance =
        Formats::has_energy ? "what ROM 1 gives, times its factor" : "what ROM 1 gives";
    reader.inner_result(&d::brdf, {"brdf", "", "reflectance", reflectance}, typename Formats::brdf{}, "brdf");
    reader.result(&d::out_o, {"out_o", "", "out_intensity", "intensity of the pixel"},
                  typename Formats::out{}, "out");
    reader.valid(&d::valid_o, {"valid_o", "", "valid", "a pixel is at the output"});
  }

  /// The leaf parts, for the same readers.
  auto blocks() const {
    return std::tie(control, rg1, rg2, rg3, rg4, rg5, cnt, dec, ground, add4, mux, mag4, limit4, rom2, mul2,
                    quant2, rom1, mul1);
  }
};

/// Specular device of patent UA 71489 with the function of [A]: the angle from the lobe's axis runs along a scan line.
///   angle of pixel i = start + i step,   brdf = cos^k(factor |angle|), 0 where factor |angle| >= pi/2
///   factor = acos(Q^(1/k)) / acos(Q^(1/n)) for n > k; for n <= k the factor is 1 and the power n: cos^n itself
///   out_o = brdf intensity
/// Instances are called by the ordinal numbers that [P] gives the parts of UA 71489 (rg4 is the fourth register). mag4,
/// limit4 and quant2 are not in the figure: it says nothing of widths and of angles below 0.
///
/// Formats  Formats: an angle_formats.
/// Timing   takes its inputs at a rising edge of clk that sees start_i and ready_o at one; two cycles later the first pixel
///          is at the output; valid_o is one for count_i cycles, one pixel each.
/// Reset    rst_n low at a rising edge of clk: ready, all registers 0.
template <class Formats, bool HasEnergy = Formats::has_energy>
struct angle : angle_path<Formats> {
  using contents = typename angle_path<Formats>::contents;

  angle(const sc_core::sc_module_name& name, const contents& words) : angle_path<Formats>(name, words) {
    this->rom1.y_o(this->brdf);
  }
};

/// The same with the normalising coefficient of [A]: a memory and a multiplier, which UA 71489 does not have, between ROM 1 and
/// multiplier 1.
///   brdf = energy[n] cos^k(factor |angle|)
template <class Formats>
struct angle<Formats, true> : angle_path<Formats> {
  using base = angle_path<Formats>;
  template <class Q>
  using net = typename base::template net<Q>;

  /// What the three memories hold.
  struct contents : base::contents {
    typename Formats::rom_energy::memory rom_energy;
  };

  typename Formats::rom_energy rom_energy;
  typename Formats::mul_energy SC_NAMED(mul_energy);

  net<typename Formats::lobe> SC_NAMED(lobe);
  net<typename Formats::energy> SC_NAMED(energy);

  angle(const sc_core::sc_module_name& name, const contents& words)
      : base(name, words), rom_energy("rom_energy", words.rom_energy) {
    this->rom1.y_o(lobe);
    rom_energy.a_i(this->n);
    rom_energy.y_o(energy);
    mul_energy.a_i(lobe);
    mul_energy.b_i(energy);
    mul_energy.p_o(this->brdf);
  }

  auto blocks() const { return std::tuple_cat(base::blocks(), std::tie(rom_energy, mul_energy)); }
};

}  // namespace blysk
