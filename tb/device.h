// SPDX-License-Identifier: Apache-2.0
/// A device as its user asks for it, and the way from those words to the formats of rtl_sysc.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "rtl_sysc/formats.h"

namespace blysk {

/// Every wire of a device is decided by these.
struct device_options {
  std::string device = "quadratic";
  std::string format = "q16";
  std::string coefficient = "derived";  ///< published | derived
  std::string constant;  ///< fraction bits wired at node 31, as "11001001"; empty: the line's slope, rounded
  bool as_published = false;  ///< keep the parabola's negative lobe (spec erratum E4)
};

inline constexpr std::string_view device_names[] = {
#define BLYSK_DEVICE(identifier, name) name,
#include "tb/devices.def"
#undef BLYSK_DEVICE
};
inline constexpr std::string_view format_names[] = {
#define BLYSK_NAMED_FORMAT(name) #name,
#include "tb/formats.def"
#undef BLYSK_NAMED_FORMAT
};
inline constexpr std::string_view coefficient_names[] = {"published", "derived"};

/// Calls visitor.operator()<Q>() with the named format of the options.
/// \throws std::invalid_argument for a format that does not exist
template <class Visitor>
auto visit_format(const device_options& options, Visitor&& visitor) {
#define BLYSK_NAMED_FORMAT(name) \
  if (options.format == #name) return visitor.template operator()<name>();
#include "tb/formats.def"
#undef BLYSK_NAMED_FORMAT
  throw std::invalid_argument("format " + options.format + " does not exist, expected q8, q10, ... q24");
}

/// Calls visitor.operator()<Q, Lobe>() with the named format and the lobe of the options.
/// \throws std::invalid_argument for a format that does not exist
template <class Visitor>
auto visit_formats(const device_options& options, Visitor&& visitor) {
  return visit_format(options, [&]<class Q>() {
    return options.as_published ? visitor.template operator()<Q, lobe::as_published>()
                                : visitor.template operator()<Q, lobe::clamped>();
  });
}

/// Fraction bits of cos(delta), of the BRDF and of the colours that leave the device.
/// \throws std::invalid_argument for a format that does not exist
int fraction_bits(const device_options& options);

/// The wires of nodes 31 and 32.
/// \throws std::invalid_argument for a coefficient line that hardware cannot form, or a constant that does not
///         start with one, is longer than the node, or holds anything but bits
wired_constants wire_constants(const device_options& options);

}  // namespace blysk
