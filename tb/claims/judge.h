// SPDX-License-Identifier: Apache-2.0
/// The one rule by which every row of docs/verification.md gets its verdict.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "tb/claims/claim.h"

namespace blysk::claims {

inline constexpr std::string_view kHolds = "holds";
inline constexpr std::string_view kPartly = "holds in part";
inline constexpr std::string_view kFails = "does not hold";
inline constexpr std::string_view kDepends = "depends on the reading";
inline constexpr std::string_view kOpen = "cannot be judged";

struct judgement {
  std::string_view verdict;  ///< one of the above
  std::string detail;        ///< how many figures, which readings, or why not; may be empty
  std::string miss;          ///< the largest, "0.41 (1.02 for 1)"; "-" if nothing is stated
};

/// A decimal number, all of the text.
/// \throws std::runtime_error if it is none
double number_of(std::string_view text);

/// Unit of the last digit of a number as printed: 0.1 for "3.2", 1 for "10", 1e-5 for "0.00008".
double unit_of(std::string_view printed);

/// How far a printed figure is from what is stated, in units of the last digit of the latter; 0 on the good side of a
/// limit. For a law, which has no unit, the plain distance.
double miss_of(const demand& d, std::string_view printed);

/// Whether the miss is no more than half a unit; for a law, none at all.
bool met(const demand& d, std::string_view printed);

/// \param printed  the row's figures as the page shows them, by key: a reader can repeat the verdict from these
judgement judge(const claim& c, const std::map<std::string, std::string>& printed);

}  // namespace blysk::claims
