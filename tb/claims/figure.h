// SPDX-License-Identifier: Apache-2.0
/// Measured figures: the numbers of docs/verification.md, apart from its words.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <variant>

#include "tb/claims/claim.h"

namespace blysk::claims {

/// What a chain of some sixty roundings of numbers around 1 may leave: equality, to double precision.
inline constexpr double kRounding = 64 * 0x1p-53;

/// A number, or words such as the exponents "1..17" for which something is true.
using figure = std::variant<double, std::string>;

/// By key.
using figures = std::map<std::string, figure>;

/// 100 share; what is rounding in a share is 0 per cent.
double in_percent(double share);

/// As the page shows it. Numbers below kRounding are "0": they are rounding, in which compilers differ.
/// \param spec  of {fmt}, such as ".3g"; words have none
std::string print(const figure& value, const std::string& spec);

/// Every figure of a row, printed.
/// \throws std::runtime_error if the row's text and `measured` do not have the same keys
std::map<std::string, std::string> print_all(const claim& c, const figures& measured);

/// Printed figures by row and key: docs/tables/measured.json, the one list that the page and the tests read.
using figure_list = std::map<std::string, std::map<std::string, std::string>>;

std::string to_json(const figure_list& list);

/// \throws std::runtime_error if the file cannot be read
figure_list load_figures(const std::filesystem::path& file);

/// How each row is measured, by its identifier; rows without figures are absent.
using measurements = std::map<std::string, std::function<figures()>, std::less<>>;

const measurements& all_measurements();

void measure_patent(measurements& into);
void measure_article(measurements& into);
void measure_relative_errors(measurements& into);
void measure_absolute_errors(measurements& into);
void measure_energy(measurements& into);
void measure_pictures(measurements& into);
void measure_rendered(measurements& into);
void measure_settling(measurements& into);
void measure_whole_numbers(measurements& into);
void measure_errata(measurements& into);

/// Measures every row.
figure_list measure_all();

}  // namespace blysk::claims
