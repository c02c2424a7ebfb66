// SPDX-License-Identifier: Apache-2.0
/// Rows of measured configurations: what they cost beside how far they are from cos^n.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tb/cost/measured.h"

namespace blysk::cost {

/// An error that can be asked for.
struct metric {
  std::string_view key;
  std::string_view what;
  double (*of)(const errors&);
};

std::span<const metric> metrics();

/// \throws std::invalid_argument for a metric that does not exist
const metric& find_metric(const std::string& key);

/// What a configuration is built of: its cost is one number there, its clock another.
struct technology {
  std::string_view name;  ///< "ice40"
  std::string_view unit;  ///< of the cost
  std::string_view what;
  std::optional<double> (*cost)(const configuration&);
  double (*mhz)(const configuration&);
};

std::span<const technology> technologies();

/// \throws std::invalid_argument for a technology that does not exist
const technology& find_technology(const std::string& name);

/// Adds domain, status and errors to a row; null without a table.
void put_errors(nlohmann::ordered_json& row, const error_table* table, domain where);

/// A row for each domain that is asked for, keys as docs/accuracy-and-time.md lists them; what was not measured is null.
nlohmann::ordered_json json_rows(const std::vector<configuration>& all, std::span<const domain> domains);

/// The same as CSV, one line a row, numbers only.
std::string csv_of(const nlohmann::ordered_json& rows);

/// A table for people, in Markdown or in columns of blanks.
std::string markdown_table(const std::vector<configuration>& all, const metric& by, domain where);
std::string plain_table(const std::vector<configuration>& all, const metric& by, domain where);

/// What is cheapest within a tolerance.
struct choice {
  const configuration* cheapest = nullptr;
  const configuration* cheaper =
      nullptr;  ///< costs less: of those the one with the least error, beyond the tolerance
  const configuration* better = nullptr;            ///< has less error: of those the one that costs least
  std::vector<const configuration*> unpriced = {};  ///< within the tolerance, but their cost was not measured
  bool has_candidate = false;                       ///< some has both an error and a cost
};

/// \param mhz  a clock that all of them have to reach, 0 for any
choice choose_cheapest(const std::vector<configuration>& all, double tolerance, const metric& by,
                       domain where, const technology& in, double mhz);

/// Those that no other is at least as cheap and as good as, by cost.
std::vector<const configuration*> front_of(const std::vector<configuration>& all, const metric& by,
                                           domain where, const technology& in);

/// One page that needs nothing else: the rows as a picture that shows a row where it is pointed at, and copies its command
/// where it is clicked.
std::string html_page(const nlohmann::ordered_json& rows, const std::string& metric);

/// "0.00123": four digits, or exactly 0.
std::string number_text(double value);

}  // namespace blysk::cost
