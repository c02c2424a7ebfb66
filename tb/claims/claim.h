// SPDX-License-Identifier: Apache-2.0
/// Rows of docs/verification.md: what a seed says, as data, apart from the numbers that are measured.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace blysk::claims {

enum class relation { is, at_most, at_least };

/// One figure that a seed states, and the measured figure that it is held against.
struct demand {
  std::string figure;   ///< key of the measured figure
  std::string reading;  ///< which of the readings that the seed leaves open; empty if it leaves none
  std::string name;     ///< of one among several figures, for the verdict
  relation how = relation::is;
  std::string value;         ///< as the seed prints it, such as "3.2": its last digit is the unit of a miss
  bool law = false;          ///< an identity or a law of physics: no printed precision
  int of = 0;                ///< if not 0, the figure counts how many of so many stated figures are met,
  std::string largest_miss;  ///< and this one is the largest miss among them, in units
};

struct claim {
  std::string id;              ///< "P3", "A-T1", "T12", "E4"
  std::string place;           ///< where in the seed
  std::string says;            ///< the seed's statement
  std::string measured;        ///< text with a placeholder {key} or {key:spec} for each measured figure
  std::vector<demand> stated;  ///< empty if nothing can be judged; then
  std::string open;            ///< says why
  std::string held_by;         ///< name of the test that derives the figures again; empty if none does
  std::vector<std::string> regenerated_only;  ///< figures that this test does not derive
};

struct section {
  std::string title;
  std::vector<claim> rows;
};

/// The rows of claims.json.
/// \throws std::runtime_error with the file, and the row or the line, if it is not as it has to be
std::vector<section> load_claims(const std::filesystem::path& file);

/// claims.json of the source tree.
const std::vector<section>& all_claims();

/// \throws std::out_of_range if there is no such row
const claim& claim_of(std::string_view id);

/// A placeholder of a row's text.
struct placeholder {
  std::string key;
  std::string spec;  ///< as in {fmt}: ".3g"
};

/// In the order of the text. "{{" and "}}" are none.
/// \throws std::runtime_error if a brace is not closed or a key comes twice
std::vector<placeholder> placeholders(std::string_view text);

/// The text with printed[key] in the place of every placeholder.
/// \throws std::out_of_range if a key is missing
std::string fill(std::string_view text, const std::map<std::string, std::string>& printed);

}  // namespace blysk::claims
