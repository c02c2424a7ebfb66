// SPDX-License-Identifier: Apache-2.0
#include <stdexcept>

#include "Vreference_q10.h"
#include "Vreference_q10___024root.h"
#include "Vreference_q12.h"
#include "Vreference_q12___024root.h"
#include "Vreference_q8.h"
#include "Vreference_q8___024root.h"
#include "tb/cosim/verilated_quadratic.h"

namespace blysk::cosim {
namespace {

template <class Top>
struct reference {
  Top top;
  std::int64_t brdf() const { return top.rootp->reference_quadratic__DOT__brdf; }
};

}  // namespace

std::unique_ptr<verilator_engine> make_reference(const std::string& format) {
  if (format == "q8") return std::make_unique<verilated_quadratic<reference<Vreference_q8>>>();
  if (format == "q10") return std::make_unique<verilated_quadratic<reference<Vreference_q10>>>();
  if (format == "q12") return std::make_unique<verilated_quadratic<reference<Vreference_q12>>>();
  throw std::invalid_argument("no reference of format " + format + ", expected q8, q10 or q12");
}

}  // namespace blysk::cosim
