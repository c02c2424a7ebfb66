// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/rom.h"
#include "rtl_sysc/devices/parabola.h"
#include "rtl_sysc/devices/quadratic_rom/contents.h"

namespace blysk {

/// How the read-only memory is built.
enum class rom_kind {
  logic,   ///< combinational
  clocked  ///< a block RAM: its output follows one clock cycle after register 1
};

/// Nets of the prototype for Q::frac fraction bits of cos(delta). The words of the memory have min(Q::frac, 20) fraction
/// bits, as the coefficient of UA 60553 has.
template <class Q, negative_lobe Lobe>
struct quadratic_rom_formats : parabola_formats<Q, Lobe, min_of(Q::frac, 20)> {
  using base = parabola_formats<Q, Lobe, min_of(Q::frac, 20)>;
  using contents = coefficient_words<base::coefficient_bits>;

  /// No net overflows for any legal input. All three lines rise with n.
  static constexpr bool no_overflow() {
    constexpr std::int64_t last = contents::words[2][1000];
    static_assert(contents::words[0][1000] <= last && contents::words[1][1000] <= last);
    return base::template no_overflow_up_to<last>();
  }
};

/// Specular device of patent UA 22802, the prototype of [P]: [P] fig. 1 with a read-only memory, a for each n, addressed by
/// register 1, in place of multiplier 6 and adder 15.
///   (r_o, g_o, b_o) = brdf * (R, G, B) k_s,   brdf = a (c^2 - c) + c,   a = rom[n]
/// Ports and reset are those of specular_device, the path from a to the outputs is that of parabola_device.
/// Timing  that of specular_device; with a clocked memory, one cycle more between the trailing edge of 17 and the next
///         leading edge of 29.
/// \tparam Formats  a quadratic_rom_formats
template <class Formats, rom_kind Kind>
struct quadratic_rom : parabola_device<Formats> {
  using base = parabola_device<Formats>;
  using memory =
      std::conditional_t<Kind == rom_kind::clocked,
                         rom_clocked<typename Formats::n, typename Formats::a, typename Formats::contents>,
                         rom<typename Formats::n, typename Formats::a, typename Formats::contents>>;

  memory rom6;  // in the place of multiplier 6

  /// \param contents  0: a of (9), 1: S n - 1/2, 2: 0.786 n + 0.5
  quadratic_rom(const sc_core::sc_module_name& name, int contents) : base(name), rom6("rom6", contents) {
    static_assert(Formats::no_overflow());
    if constexpr (Kind == rom_kind::clocked) {
      rom6.clk(this->clk);
      rom6.rst_n(this->rst_n);
    }
    rom6.a_i(this->n);
    rom6.y_o(this->a);
  }

  /// The ports, as specular_device has them.
  template <class Reader>
  static void pins(Reader& reader) {
    base::pins(reader);
    if (Kind == rom_kind::clocked) reader.settles_after(1);
  }

  /// The parts list, for readers of the structure.
  auto blocks() const { return std::tuple_cat(base::blocks(), std::tie(rom6)); }
};

}  // namespace blysk
