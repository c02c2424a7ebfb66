// SPDX-License-Identifier: Apache-2.0
#include "Vreference_q10.h"
#include "Vreference_q10___024root.h"
#include "Vreference_q12.h"
#include "Vreference_q12___024root.h"
#include "Vreference_q14.h"
#include "Vreference_q14___024root.h"
#include "Vreference_q16.h"
#include "Vreference_q16___024root.h"
#include "Vreference_q18.h"
#include "Vreference_q18___024root.h"
#include "Vreference_q20.h"
#include "Vreference_q20___024root.h"
#include "Vreference_q22.h"
#include "Vreference_q22___024root.h"
#include "Vreference_q24.h"
#include "Vreference_q24___024root.h"
#include "Vreference_q8.h"
#include "Vreference_q8___024root.h"
#include "tb/cosim/verilated_quadratic.h"

namespace blysk::cosim {

template <int Fraction>
std::unique_ptr<verilator_engine> make_reference();

namespace {

template <class Top>
struct reference {
  Top top;
  std::int64_t brdf() const { return top.rootp->reference_quadratic__DOT__brdf; }
};

}  // namespace

#define BLYSK_REFERENCE(Fraction)                                                      \
  template <>                                                                          \
  std::unique_ptr<verilator_engine> make_reference<Fraction>() {                       \
    return std::make_unique<verilated_quadratic<reference<Vreference_q##Fraction>>>(); \
  }

BLYSK_REFERENCE(8)
BLYSK_REFERENCE(10)
BLYSK_REFERENCE(12)
BLYSK_REFERENCE(14)
BLYSK_REFERENCE(16)
BLYSK_REFERENCE(18)
BLYSK_REFERENCE(20)
BLYSK_REFERENCE(22)
BLYSK_REFERENCE(24)

#undef BLYSK_REFERENCE

}  // namespace blysk::cosim
