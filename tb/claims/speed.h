// SPDX-License-Identifier: Apache-2.0
/// Speeds that bench_golden measured on one machine, kept in docs/tables/speed.csv so that pages can quote them, and what
/// synthesis tools measured of devices.
#pragma once

#include <string>
#include <string_view>

namespace blysk::claims {

/// Elements in the time of one std::pow(double, double), the column pow_ratio.
/// \param name  row, such as "double/schlick"
/// \throws std::runtime_error if there is no such row
double recorded_speed(std::string_view name);

/// What synthesis tools measured of a device in q8, kept in docs/tables/arccos/price.csv.
/// \param device  row, such as "quadratic"
/// \param column  such as "path_ns"
/// \throws std::runtime_error if there is no such row or column
double recorded_price(std::string_view device, std::string_view column);

/// A measured figure of docs/tables/<device>/cost_q8.json.
/// \param part  such as "osu018"
/// \param key   such as "area_nand2"
/// \throws std::runtime_error if there is no such file, part or key
double recorded_cost(const std::string& device, const char* part, const char* key);

}  // namespace blysk::claims
