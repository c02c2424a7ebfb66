// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/constant.h"
#include "rtl_sysc/blocks/inverter_bank.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/devices/specular.h"

namespace blysk {

/// What becomes of the parabola's negative values, 0 < c < 1 - 1/a (spec erratum E4).
enum class negative_lobe {
  clamped,      ///< the BRDF is clamped to [0, 1]
  as_published  ///< they go through, down to -a/4, about -196 at n = 1000
};

/// Fraction bits of c^2 and c^2 - c for `frac` fraction bits of c. All of the square's up to 12; from 14 on it keeps
/// frac + 12 bits (24: 35), since a < 2^10 makes its rounding cost at most 2^10 * 2^-(frac+13) = 1/8 ulp of the BRDF
/// (24: 1/4), and no sum needs more than 64 bits.
constexpr int square_bits(int frac) {
  return min_of(min_of(2 * frac, frac + 12), 35);
}

/// Nets between the coefficient a, cos(delta) and the outputs of [P] fig. 1, for Q::frac fraction bits of cos(delta) and
/// `CoefficientBits` of a. The BRDF has Q::frac fraction bits again.
template <class Q, negative_lobe Lobe, int CoefficientBits>
struct parabola_formats {
  static constexpr negative_lobe lobe = Lobe;
  static constexpr int cos_bits = Q::frac;
  static constexpr int coefficient_bits = CoefficientBits;
  static constexpr int diff_bits = square_bits(Q::frac);

  using n = exponent;
  using cos_delta = unit<cos_bits>;
  using a = uq<10, coefficient_bits>;
  using cos2 = uq<1, diff_bits>;                       // multiplier 7
  using cos_inv = sq<1, diff_bits>;                    // inverter bank 8
  using diff = sq<-2, diff_bits>;                      // adder 9: cos^2 - cos, [-1/4, 0]
  using a_diff = sq<8, coefficient_bits + diff_bits>;  // multiplier 10
  using parabola = a_diff;                             // adder 11
  using brdf = std::conditional_t<Lobe == negative_lobe::clamped, unit<cos_bits>, sq<8, cos_bits>>;
  using out =
      std::conditional_t<Lobe == negative_lobe::clamped, uq<8, cos_bits>, sq<16, cos_bits>>;  // 12..14

  using mul7 = mul<cos_delta, cos_delta, cos2>;
  using inv8 = inverter_bank<cos_delta, cos_inv>;
  using add9 = add<cos2, cos_inv, diff>;
  using mul10 = mul<a, diff, a_diff>;
  using add11 = add<a_diff, cos_delta, parabola>;
  using quant11 =
      quantise<parabola, brdf, Lobe == negative_lobe::clamped ? overflow::clamp : overflow::excluded>;
  using mul_colour = mul<brdf, colour, out>;

  /// No net overflows for any legal input whose a is at most LargestA (raw): the laws themselves, taken at the ends of
  /// their operands. c^2 - c has its minimum -1/4 at c = 1/2.
  template <std::int64_t LargestA>
  static constexpr bool no_overflow_up_to() {
    using std::int64_t;
    constexpr int64_t one = cos_delta::max;
    constexpr int64_t half = one / 2;
    constexpr int64_t cos2_hi = mul7::law(one, one);
    constexpr int64_t diff_lo = add9::law(mul7::law(half, half), inv8::law(half), int64_t(1));
    constexpr int64_t diff_hi = add9::law(cos2_hi, inv8::law(one), int64_t(1));
    constexpr int64_t a_diff_lo = mul10::law(LargestA, diff_lo);
    constexpr int64_t parabola_hi = add11::law(int64_t(0), one, int64_t(0));
    constexpr int64_t brdf_lo = quant11::law(a_diff_lo);
    constexpr int64_t brdf_hi = quant11::law(parabola_hi);
    static_assert(fits<a>(0, LargestA));
    static_assert(fits<cos2>(0, cos2_hi));
    static_assert(fits<cos_inv>(inv8::law(one), inv8::law(int64_t(0))));
    static_assert(fits<diff>(diff_lo, diff_hi) && diff_hi == 0);
    static_assert(fits<a_diff>(a_diff_lo, 0));
    static_assert(fits<parabola>(a_diff_lo, parabola_hi));
    static_assert(fits<brdf>(brdf_lo, brdf_hi));
    static_assert(fits<out>(mul_colour::law(brdf_lo, colour::max), mul_colour::law(brdf_hi, colour::max)));
    return true;
  }
};

/// What UA 60553 and its prototype UA 22802 share: the parabola brdf = a (c^2 - c) + c between registers and colour
/// multipliers. Numbers are those of [P] fig. 1. A device derives from it and drives the net a from the net n.
///
/// Formats  Formats: a parabola_formats.
/// \tparam Base  specular_device, or pipelined_device with these levels: 0 mul6 mul7, 1 add15 inv8 add9, 2 mul10, 3 add11,
///               4 quant11, 5 mul12 mul13 mul14
template <class Formats, class Base = specular_device<Formats>>
struct parabola_device : Base {
  using base = Base;
  template <class Q>
  using staged = typename base::template staged<Q>;
  template <class Q>
  using net = typename base::template net<Q>;

  constant<carry> carry28;
  constant<carry> carry30;
  typename Formats::mul7 SC_NAMED(mul7);
  typename Formats::inv8 SC_NAMED(inv8);
  typename Formats::add9 SC_NAMED(add9);
  typename Formats::mul10 SC_NAMED(mul10);
  typename Formats::add11 SC_NAMED(add11);
  typename Formats::quant11 SC_NAMED(quant11);

  net<carry> SC_NAMED(carry28_in);
  net<carry> SC_NAMED(carry30_in);
  net<typename Formats::a> SC_NAMED(a);
  net<typename Formats::cos2> SC_NAMED(cos2);
  net<typename Formats::cos_inv> SC_NAMED(cos_inv);
  net<typename Formats::diff> SC_NAMED(cos2_minus_cos);
  net<typename Formats::a_diff> SC_NAMED(a_times_diff);
  net<typename Formats::parabola> SC_NAMED(parabola);

  staged<typename Formats::cos_delta> cos_1{"pipe_cos", "cos_1", 0, 1};
  staged<typename Formats::cos_delta> cos_3{"pipe_cos_late", "cos_3", 1, 3};
  staged<typename Formats::cos2> cos2_1{"pipe_cos2", "cos2_1", 0, 1};
  staged<typename Formats::a> a_2{"pipe_a", "a_2", 1, 2};
  staged<typename Formats::diff> diff_2{"pipe_diff", "diff_2", 1, 2};
  staged<typename Formats::a_diff> a_diff_3{"pipe_a_diff", "a_diff_3", 2, 3};
  staged<typename Formats::parabola> parabola_4{"pipe_parabola", "parabola_4", 3, 4};

  /// \param cuts  of a pipelined_device
  template <class... Cuts>
  explicit parabola_device(const sc_core::sc_module_name& name, const Cuts&... cuts)
      : base(name, cuts...), carry28("carry28", 1), carry30("carry30", 0) {
    auto& cos_early = this->at(cos_1, this->cos_delta);
    auto& cos_late = this->at(cos_3, cos_early);
    // clang-format off
    carry28.y_o(carry28_in);      carry30.y_o(carry30_in);
    mul7.a_i(this->cos_delta);    mul7.b_i(this->cos_delta);                                   mul7.p_o(cos2);
    inv8.a_i(cos_early);                                                                       inv8.y_o(cos_inv);
    add9.a_i(this->at(cos2_1, cos2));
                                  add9.b_i(cos_inv);           add9.carry_i(carry28_in);       add9.s_o(cos2_minus_cos);
    mul10.a_i(this->at(a_2, a));  mul10.b_i(this->at(diff_2, cos2_minus_cos));                 mul10.p_o(a_times_diff);
    add11.a_i(this->at(a_diff_3, a_times_diff));
                                  add11.b_i(cos_late);         add11.carry_i(carry30_in);      add11.s_o(parabola);
    quant11.a_i(this->at(parabola_4, parabola));
                                                               quant11.y_o(this->before(this->brdf_first, this->brdf));
    // clang-format on
  }

  /// The parts list, for readers of the structure.
  auto blocks() const {
    return std::tuple_cat(base::blocks(),
                          std::tie(carry28, carry30, mul7, inv8, add9, mul10, add11, quant11, cos_1.registers,
                                   cos_3.registers, cos2_1.registers, a_2.registers, diff_2.registers,
                                   a_diff_3.registers, parabola_4.registers));
  }
};

}  // namespace blysk
