// SPDX-License-Identifier: Apache-2.0
/// A proved bound of a device's error, beside the largest error that was seen: docs/tables/<identifier>/certificate_<format>.json,
/// with "_<option>_<value>" behind the format for each option that is no preset.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace blysk::cost {

/// The largest |BRDF of the bit-accurate model - BRDF of the device's formula|, dimensionless.
struct seen_error {
  double max_abs_err = 0;
  int n = 0;  ///< an input that has it
  double cos = 0;
  std::uint64_t inputs = 0;    ///< that were tried
  bool is_exhaustive = false;  ///< all legal codes of n and cos
};

struct certificate {
  std::string device, format;
  std::map<std::string, std::string> options = {};  ///< those that differ from their presets
  std::string digest;                               ///< of the Verilog of the same netlist
  std::string gappa;                                ///< its version
  double bound =
      0;  ///< |BRDF of the netlist - BRDF of the formula in real numbers| is at most that, dimensionless
  seen_error seen;
};

nlohmann::ordered_json json_of(const certificate& row);

/// \param path  for messages
/// \throws usage_error for text that is no certificate, and for a bound below what was seen
certificate parse_certificate(const std::string& path, const std::string& text);

/// The table between the lines "<!-- generated: certificates -->" and "<!-- end of generated -->" of a page: all
/// certificates of a folder, and a line for each device that computes as another one does.
/// \throws usage_error for a page without them, or a file that is no certificate
std::string with_certificates(const std::string& tables, const std::string& path, const std::string& page);

}  // namespace blysk::cost
