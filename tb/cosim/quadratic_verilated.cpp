// SPDX-License-Identifier: Apache-2.0
// The classes that Verilator makes of the checked-in devices, in one file: their headers take longer than their code.
#include "Vblysk_quadratic_q10.h"
#include "Vblysk_quadratic_q10___024root.h"
#include "Vblysk_quadratic_q12.h"
#include "Vblysk_quadratic_q12___024root.h"
#include "Vblysk_quadratic_q14.h"
#include "Vblysk_quadratic_q14___024root.h"
#include "Vblysk_quadratic_q16.h"
#include "Vblysk_quadratic_q16___024root.h"
#include "Vblysk_quadratic_q18.h"
#include "Vblysk_quadratic_q18___024root.h"
#include "Vblysk_quadratic_q20.h"
#include "Vblysk_quadratic_q20___024root.h"
#include "Vblysk_quadratic_q22.h"
#include "Vblysk_quadratic_q22___024root.h"
#include "Vblysk_quadratic_q24.h"
#include "Vblysk_quadratic_q24___024root.h"
#include "Vblysk_quadratic_q8.h"
#include "Vblysk_quadratic_q8___024root.h"
#include "tb/cosim/verilated_quadratic.h"

namespace blysk::cosim {

template <int Fraction>
std::unique_ptr<verilator_engine> make_quadratic();

#define BLYSK_DEVICE(Fraction)                                                                \
  namespace {                                                                                 \
  struct device_q##Fraction {                                                                 \
    Vblysk_quadratic_q##Fraction top;                                                         \
    std::int64_t brdf() const { return top.rootp->blysk_quadratic_q##Fraction##__DOT__brdf; } \
  };                                                                                          \
  }                                                                                           \
  template <>                                                                                 \
  std::unique_ptr<verilator_engine> make_quadratic<Fraction>() {                              \
    return std::make_unique<verilated_quadratic<device_q##Fraction>>();                       \
  }

BLYSK_DEVICE(8)
BLYSK_DEVICE(10)
BLYSK_DEVICE(12)
BLYSK_DEVICE(14)
BLYSK_DEVICE(16)
BLYSK_DEVICE(18)
BLYSK_DEVICE(20)
BLYSK_DEVICE(22)
BLYSK_DEVICE(24)

#undef BLYSK_DEVICE

}  // namespace blysk::cosim
