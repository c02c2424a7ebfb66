// SPDX-License-Identifier: Apache-2.0
/// Speeds that bench_golden measured on one machine, kept in docs/tables/speed.csv so that pages can quote them.
#pragma once

#include <string_view>

namespace blysk::claims {

/// Elements in the time of one std::pow(double, double), the column pow_ratio.
/// \param name  row, such as "double/schlick"
/// \throws std::runtime_error if there is no such row
double recorded_speed(std::string_view name);

}  // namespace blysk::claims
