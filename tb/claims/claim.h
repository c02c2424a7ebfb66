// SPDX-License-Identifier: Apache-2.0
/// What the seeds state in numbers, beside what is measured: the rows of docs/verification.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace blysk::golden {

/// What a chain of some sixty roundings of numbers around 1 may leave: equality, to double precision.
inline constexpr double kRounding = 64 * 0x1p-53;

inline constexpr std::string_view kHolds = "holds";
inline constexpr std::string_view kPartly = "holds in part";
inline constexpr std::string_view kFails = "does not hold";
inline constexpr std::string_view kAmbiguous = "ambiguous";
inline constexpr std::string_view kUncheckable = "cannot be checked";

struct claim {
  std::string id;        ///< "P3", "A-T1", "T12", "E4"
  std::string place;     ///< where in the seed
  std::string says;      ///< the seed's statement
  std::string measured;  ///< what is found, every number computed in this run
  std::string verdict;   ///< one of the above, perhaps with a condition after a colon
};

/// \param digits  significant digits; below kRounding it is "0"
std::string number(double value, int digits = 3);
std::string percent(double value, int digits = 3);

/// Adds an item to a list in words: the separator before all but the first, then the item's parts.
template <class... Parts>
void append(std::string& list, std::string_view separator, const Parts&... parts) {
  if (!list.empty()) list += separator;
  ((list += parts), ...);
}

std::string verdict_of(bool holds);

/// One of several readings or parts of a statement.
struct reading {
  std::string name;
  bool holds;
};

/// For readings of which the seed means one: kHolds if all hold, kFails if none does, else kAmbiguous, naming
/// those that hold.
std::string verdict_of(const std::vector<reading>& readings);

/// For parts that the seed states together: kHolds, kFails or kPartly, naming those that hold.
std::string verdict_of_parts(const std::vector<reading>& parts);

/// Whether a measurement rounds to what is printed with so many decimals.
bool rounds_to(double measured, double printed, int decimals);

/// "1..17, 25": the members of [1, size] whose entry is true; "none" if there are none.
std::string ranges(const std::vector<bool>& members);

/// A table in Markdown: the first row is the head.
std::string markdown(const std::vector<std::vector<std::string>>& rows);

/// Name of the test that asserts a row's numbers by themselves, from closed forms or by another method than that of
/// the page; docs.verification, which only measures again, for the rest.
/// \param id  of a row, such as "T4"
std::string held_by(std::string_view id);

/// What a test holds: its name without "golden.claims: ", and the rows.
struct holding {
  std::string_view test;
  std::vector<std::string_view> rows;
};

const std::vector<holding>& holdings();

std::vector<claim> patent_claims();
std::vector<claim> article_claims();
std::vector<claim> thesis_claims();
std::vector<claim> errata();

/// A page of tables that the rows refer to, written beside them.
struct table {
  std::string file;  ///< below docs/tables
  std::string text;
};

std::vector<table> article_tables();
std::vector<table> errata_tables();
std::vector<table> error_tables();
std::vector<table> energy_tables();
std::vector<table> angle_energy_tables();
std::vector<table> stability_tables();
std::vector<table> picture_tables();

}  // namespace blysk::golden
