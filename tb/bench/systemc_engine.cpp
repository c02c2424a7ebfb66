// SPDX-License-Identifier: Apache-2.0
#include "tb/bench/systemc_engine.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace blysk::bench {

// Defined in quadratic_bench.cpp, one object file per format; its header would elaborate them all here.
template <class Q, lobe Lobe>
std::unique_ptr<systemc_engine> make_quadratic(const wired_constants& wired);

bool ends_at(const std::string& vcd, const sc_core::sc_time& now) {
  std::ifstream file(vcd, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(file.tellg());
  constexpr std::streamoff kTail = 1 << 16;  // the changes of a clock edge are shorter
  file.seekg(-std::min(size, kTail), std::ios::end);
  const std::string tail{std::istreambuf_iterator<char>(file), {}};
  const auto stamp = tail.rfind("\n#");
  if (stamp == std::string::npos || tail.back() != '\n') return false;
  const sc_core::sc_time last(std::strtod(tail.c_str() + stamp + 2, nullptr), sc_core::SC_PS);
  return last + sc_core::sc_time(kClockPeriodNs, sc_core::SC_NS) >= now;
}

std::unique_ptr<systemc_engine> make_systemc(const device_options& options) {
  const wired_constants wired = wire_constants(options);
  return visit_formats(options, [&]<class Q, lobe Lobe>() { return make_quadratic<Q, Lobe>(wired); });
}

}  // namespace blysk::bench
