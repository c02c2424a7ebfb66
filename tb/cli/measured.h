// SPDX-License-Identifier: Apache-2.0
/// The errors of the devices against c^n, as docs/tables/<device>/device_errors.csv has them.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace blysk::cli {

/// The worst of a format over the exponents of the table.
struct worst_errors {
  std::string format;
  double epicentre = 0;  ///< largest |BRDF / c^n - 1| where c^n >= 0.6, dimensionless
  unsigned epicentre_n = 0;
  double whole = 0;  ///< largest |BRDF - c^n| over all cosines, dimensionless
  unsigned whole_n = 0;
};

/// In the table's order; none for a device without a table.
/// \param identifier  the device's name with underscores
/// \throws std::runtime_error for a table that lacks a column
std::vector<worst_errors> measured_errors(const std::string& identifier);

}  // namespace blysk::cli
