// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/blocks/rom.h"
#include "rtl_sysc/blocks/sign.h"
#include "rtl_sysc/devices/cosine_quadratic/formats.h"
#include "rtl_sysc/devices/specular.h"

namespace blysk {

/// Numbers of [T] fig. 3.1 as its text gives them. It numbers neither the colour multipliers nor the pins of the colours,
/// and says nothing of a strobe of register 1 or of an output that confirms.
struct thesis_figure {
  static constexpr const char* rg_n = "rg2";
  static constexpr const char* rg_cos = "rg1";
  static constexpr const char* mul_red = "mul_red";
  static constexpr const char* mul_green = "mul_green";
  static constexpr const char* mul_blue = "mul_blue";
  static constexpr const char* buf_valid = "buf_valid";

  static constexpr pin n_i{"n_i", "17", "n17", "n"};
  static constexpr pin n_we_i{"n_we_i", "18", "strobe18", "write rg2"};
  static constexpr pin cos_i{"cos_i", "32", "cos32", "cos(gamma), 0..1"};
  static constexpr pin cos_we_i{"cos_we_i", "", "strobe_cos", "write rg1, by its trailing edge"};
  static constexpr pin r_i{"r_i", "", "red", "R k_s"};
  static constexpr pin r_we_i{"r_we_i", "", "strobe_red", "write rg3"};
  static constexpr pin g_i{"g_i", "", "green", "G k_s"};
  static constexpr pin g_we_i{"g_we_i", "", "strobe_green", "write rg4"};
  static constexpr pin b_i{"b_i", "", "blue", "B k_s"};
  static constexpr pin b_we_i{"b_we_i", "", "strobe_blue", "write rg5"};
  static constexpr pin r_o{"r_o", "", "out_red", "red"};
  static constexpr pin g_o{"g_o", "", "out_green", "green"};
  static constexpr pin b_o{"b_o", "", "out_blue", "blue"};
  static constexpr pin valid_o{"valid_o", "", "valid", "the colours are valid at its leading edge"};
};

/// From registers 1 and 2 to multiplier 10 and key block 12 of [T] fig. 3.1; what derives from it drives the net
/// beyond_root and takes the output of key12.
template <class Formats>
struct cosine_quadratic_path : specular_device<Formats, thesis_figure> {
  using base = specular_device<Formats, thesis_figure>;
  template <class Q>
  using net = typename base::template net<Q>;

  constant<typename Formats::minus_one> ones6;
  constant<carry> ground;
  constant<carry> carry29;
  rom<typename Formats::n, typename Formats::slope, typename Formats::slopes> rom33;
  typename Formats::add6 SC_NAMED(add6);
  typename Formats::mul7 SC_NAMED(mul7);
  typename Formats::add8 SC_NAMED(add8);
  typename Formats::quant8 SC_NAMED(quant8);
  typename Formats::mul10 SC_NAMED(mul10);
  typename Formats::key12 SC_NAMED(key12);

  net<typename Formats::minus_one> SC_NAMED(minus_one);
  net<carry> SC_NAMED(grounded);
  net<carry> SC_NAMED(carry29_in);
  net<typename Formats::slope> SC_NAMED(slope);
  net<typename Formats::cos_minus_1> SC_NAMED(cos_minus_1);
  net<typename Formats::product> SC_NAMED(product);
  net<typename Formats::line> SC_NAMED(line);
  net<typename Formats::rounded> SC_NAMED(line_rounded);
  net<typename Formats::square> SC_NAMED(square);
  typename channel_of<Formats, bool>::type SC_NAMED(beyond_root);

  explicit cosine_quadratic_path(const sc_core::sc_module_name& name)
      : base(name), ones6("ones6", -1), ground("ground", 0), carry29("carry29", 1), rom33("rom33", 0) {
    static_assert(Formats::no_overflow());
    // clang-format off
    ones6.y_o(minus_one);         ground.y_o(grounded);       carry29.y_o(carry29_in);
    rom33.a_i(this->n);                                                                    rom33.y_o(slope);
    add6.a_i(this->cos_delta);    add6.b_i(minus_one);        add6.carry_i(grounded);      add6.s_o(cos_minus_1);
    mul7.a_i(slope);              mul7.b_i(cos_minus_1);                                   mul7.p_o(product);
    add8.a_i(product);            add8.b_i(grounded);         add8.carry_i(carry29_in);    add8.s_o(line);
    quant8.a_i(line);                                                                      quant8.y_o(line_rounded);
    mul10.a_i(line_rounded);      mul10.b_i(line_rounded);                                 mul10.p_o(square);
    key12.a_i(square);            key12.off_i(beyond_root);
    // clang-format on
  }

  auto blocks() const {
    return std::tuple_cat(base::blocks(),
                          std::tie(ones6, ground, carry29, rom33, add6, mul7, add8, quant8, mul10, key12));
  }
};

/// The path with what closes key block 12.
template <class Formats, root_gate Gate = Formats::gate>
struct cosine_quadratic_gated;

template <class Formats>
struct cosine_quadratic_gated<Formats, root_gate::sign> : cosine_quadratic_path<Formats> {
  using base = cosine_quadratic_path<Formats>;

  sign<typename Formats::line> SC_NAMED(sign8);

  explicit cosine_quadratic_gated(const sc_core::sc_module_name& name) : base(name) {
    sign8.a_i(this->line);
    sign8.negative_o(this->beyond_root);
  }

  auto blocks() const { return std::tuple_cat(base::blocks(), std::tie(sign8)); }
};

template <class Formats>
struct cosine_quadratic_gated<Formats, root_gate::limit> : cosine_quadratic_path<Formats> {
  using base = cosine_quadratic_path<Formats>;

  rom<typename Formats::n, typename Formats::limit, typename Formats::limits> rom9;
  typename Formats::cmp11 SC_NAMED(cmp11);

  typename base::template net<typename Formats::limit> SC_NAMED(limit);

  explicit cosine_quadratic_gated(const sc_core::sc_module_name& name) : base(name), rom9("rom9", 0) {
    rom9.a_i(this->n);
    rom9.y_o(limit);
    cmp11.a_i(this->square);
    cmp11.b_i(limit);
    cmp11.below_o(this->beyond_root);
  }

  auto blocks() const { return std::tuple_cat(base::blocks(), std::tie(rom9, cmp11)); }
};

/// Specular device of [T] fig. 3.1; numbers are those of the figure.
///   (r_o, g_o, b_o) = brdf * (R, G, B) k_s,   brdf = (m (c - 1) + 1)^2, 0 beyond its root,   m = (n + 1)/3   [T] (2.15)
/// Timing and reset are those of specular_device.
/// \tparam Formats  a cosine_quadratic_formats
template <class Formats, bool HasFactor = Formats::has_factor>
struct cosine_quadratic : cosine_quadratic_gated<Formats> {
  explicit cosine_quadratic(const sc_core::sc_module_name& name, int /*factor*/)
      : cosine_quadratic_gated<Formats>(name) {
    this->key12.y_o(this->brdf);
  }
};

/// The same with an energy factor: a memory and a multiplier, which the figure does not have, between key block 12 and the
/// colour multipliers.   [T] (2.26)
template <class Formats>
struct cosine_quadratic<Formats, true> : cosine_quadratic_gated<Formats> {
  using base = cosine_quadratic_gated<Formats>;
  template <class Q>
  using net = typename base::template net<Q>;

  rom<typename Formats::n, typename Formats::factor, typename Formats::factors> rom_factor;
  typename Formats::mul_factor SC_NAMED(mul_factor);

  net<typename Formats::square> SC_NAMED(lobe);
  net<typename Formats::factor> SC_NAMED(factor);

  /// \param which  0: (n + 6)/24.55, 1: (n + 1)/(8 pi)
  cosine_quadratic(const sc_core::sc_module_name& name, int which)
      : base(name), rom_factor("rom_factor", which) {
    this->key12.y_o(lobe);
    rom_factor.a_i(this->n);
    rom_factor.y_o(factor);
    mul_factor.a_i(lobe);
    mul_factor.b_i(factor);
    mul_factor.p_o(this->brdf);
  }

  auto blocks() const { return std::tuple_cat(base::blocks(), std::tie(rom_factor, mul_factor)); }
};

}  // namespace blysk
