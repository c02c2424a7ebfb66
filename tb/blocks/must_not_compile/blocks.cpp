// SPDX-License-Identifier: Apache-2.0
// What blocks refuse, one case at a time; without BLYSK_CASE this compiles.
#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/compare.h"
#include "rtl_sysc/blocks/inverter_bank.h"
#include "rtl_sysc/blocks/mul.h"
#include "rtl_sysc/blocks/quantise.h"
#include "rtl_sysc/blocks/reg_level.h"
#include "rtl_sysc/blocks/sign.h"

#define NONE 0
#define WRONG_WIDTH 1
#define ADDER_THAT_ROUNDS 2
#define MUL_WITHOUT_HEADROOM 3
#define QUANTISE_WITHOUT_HEADROOM 4
#define TOO_WIDE 5
#define SIGNED_INVERTER 6
#define SIGN_OF_UNSIGNED 7
#define COMPARISON_TOO_WIDE 8
#ifndef BLYSK_CASE
#define BLYSK_CASE NONE
#endif

using namespace blysk;

constexpr std::int64_t one = 1;

// A net binds to a port of its width.
void bind(reg_level<uq<8, 0>>& reg,
          sc_core::sc_signal<sc_dt::sc_uint<BLYSK_CASE == WRONG_WIDTH ? 9 : 8>>& net) {
  reg.q_o(net);
}

// An adder keeps its operands' fraction bits.
using sum = add<uq<1, 4>, uq<1, 4>, uq<2, BLYSK_CASE == ADDER_THAT_ROUNDS ? 3 : 4>>;
static_assert(sum::law(one, one, one) == 3);

// A product of 64 bits rounds off two bits or more, or one if it has 63: one more than a half goes first.
using product = mul<sq<30, 0>, sq<30, 2>, sq<62, BLYSK_CASE == MUL_WITHOUT_HEADROOM ? 1 : 0>>;
static_assert(product::exact::width == 64);
static_assert(product::law(one << 30, one << 2) == one << 30);

// The same of a number that is rounded.
using rounded =
    quantise<sq<61, 2>, sq<62, BLYSK_CASE == QUANTISE_WITHOUT_HEADROOM ? 1 : 0>, overflow::excluded>;
static_assert(rounded::law(sq<61, 2>::max) == one << 61);

// A raw value is an int64_t.
static_assert(uq < 32, BLYSK_CASE == TOO_WIDE ? 32 : 31 > ::max > 0);

// The ones' complement of a signed number is no subtraction.
using inverted =
    inverter_bank<std::conditional_t<BLYSK_CASE == SIGNED_INVERTER, sq<1, 4>, uq<1, 4>>, sq<1, 4>>;
static_assert(inverted::law(one) == -2);

// An unsigned number has no sign.
using sign_of = sign<std::conditional_t<BLYSK_CASE == SIGN_OF_UNSIGNED, uq<2, 4>, sq<1, 4>>>;
static_assert(sign_of::law(-one) == 1);

// Operands of a comparison are aligned within 64 bits.
using compared = compare<uq<33, 0>, uq<1, BLYSK_CASE == COMPARISON_TOO_WIDE ? 31 : 30>>;
static_assert(compared::law(one, one) == 0);
