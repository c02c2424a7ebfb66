// SPDX-License-Identifier: Apache-2.0
#include "tb/cosim/verilator_engine.h"

#include "tb/device.h"

namespace blysk::cosim {

// Defined in quadratic_verilated.cpp and reference_verilated.cpp.
template <int Fraction>
std::unique_ptr<verilator_engine> make_quadratic();
template <int Fraction>
std::unique_ptr<verilator_engine> make_reference();

std::unique_ptr<verilator_engine> make_verilator(const device_options& options) {
  wire_constants(options);  // throws for what no device has
  if (options.coefficient != device_options{}.coefficient || !options.constant.empty() ||
      options.as_published) {
    throw std::invalid_argument(
        "engine verilator has the default coefficient, constant and lobe compiled in; export the device for "
        "others");
  }
  return visit_formats(options, []<class Q, lobe>() { return make_quadratic<Q::frac>(); });
}

std::unique_ptr<verilator_engine> make_reference(const std::string& format) {
  device_options options;
  options.format = format;
  return visit_formats(options, []<class Q, lobe>() { return make_reference<Q::frac>(); });
}

}  // namespace blysk::cosim
