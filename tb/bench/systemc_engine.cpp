// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/systemc_engine.h"

namespace blysk::bench {

// Defined in quadratic_bench.cpp, one object file per format; its header would elaborate them all here.
template <class Q, lobe Lobe>
std::unique_ptr<systemc_engine> make_quadratic(const wired_constants& wired);

std::unique_ptr<systemc_engine> make_systemc(const device_options& options) {
  const wired_constants wired = wire_constants(options);
  return visit_formats(options, [&]<class Q, lobe Lobe>() { return make_quadratic<Q, Lobe>(wired); });
}

}  // namespace blysk::bench
