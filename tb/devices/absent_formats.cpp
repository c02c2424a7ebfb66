// SPDX-License-Identifier: Apache-2.0
// The formats that BLYSK_FORMATS leaves out of a build, in the place of their objects of per_format.cpp.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "rtl_sysc/formats.h"
#include "tb/device.h"
#include "tb/formats_of_build.h"
#include "tb/netlist/elaborated.h"

namespace blysk {

template <class Q>
std::vector<port> ports_in(const selection& asked);
template <class Q>
std::unique_ptr<netlist::elaborated> elaborate_in(const selection& asked, double clock_period_ns);

bool is_in_build(std::string_view format) {
  static const std::vector<std::string_view> absent{
#define BLYSK_NAMED_FORMAT(name) #name,
#include "tb/devices/absent_formats.def"
#undef BLYSK_NAMED_FORMAT
  };
  return std::ranges::find(absent, format) == absent.end();
}

void expect_in_build(std::string_view format) {
  if (is_in_build(format)) return;
  throw std::invalid_argument(
      fmt::format("format {} is not in this build; scripts/build makes one with all", format));
}

#define BLYSK_NAMED_FORMAT(name)                                                      \
  template <>                                                                         \
  std::vector<port> ports_in<name>(const selection&) {                                \
    expect_in_build(#name);                                                           \
    return {};                                                                        \
  }                                                                                   \
  template <>                                                                         \
  std::unique_ptr<netlist::elaborated> elaborate_in<name>(const selection&, double) { \
    expect_in_build(#name);                                                           \
    return nullptr;                                                                   \
  }
#include "tb/devices/absent_formats.def"
#undef BLYSK_NAMED_FORMAT

}  // namespace blysk
