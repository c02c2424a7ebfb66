// SPDX-License-Identifier: Apache-2.0
/// Errors of a device over word lengths, roundings and options of its bit-accurate model, a file for each combination in a
/// folder.
///
/// A folder belongs to one sweep, of which sweep.json tells. Each row is written as a whole, so a sweep that was killed
/// goes on where it stopped; a lock keeps two runs apart. Shards of a sweep go into folders of their own and are merged.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tb/cost/errors.h"

namespace blysk::cost {

/// From the first to the last, both included.
struct width_range {
  int first = 0, last = 0;
};

/// "8..12" or "8".
/// \throws std::invalid_argument for another text, or an empty range
width_range parse_range(const std::string& name, const std::string& text);

/// One of so many parts of a sweep.
struct shard {
  int index = 1, count = 1;
};

/// "2/8".
/// \throws std::invalid_argument for another text, or an index that is not 1..count
shard parse_shard(const std::string& text);

/// "a,b" without its commas.
std::vector<std::string> split_list(const std::string& text);

/// "nearest,truncate", or "all".
/// \throws std::invalid_argument for a rounding that does not exist
std::vector<specular::rounding> parse_roundings(const std::string& text);

using option_values = std::map<std::string, std::string>;

/// What is swept: each value of the options with each word length and each rounding.
struct sweep {
  std::string device;
  std::map<std::string, std::vector<std::string>> options;  ///< those given
  std::map<std::string, width_range> widths;                ///< those given
  std::vector<specular::rounding> roundings{specular::rounding::nearest};
  std::string format{};  ///< whose word lengths those are that no range names; empty: as sweep_point says

  /// \throws std::invalid_argument if the device, the format, an option, a word length or a rounding does not exist, or is there twice
  void check() const;

  /// One value of each option.
  std::vector<option_values> option_lines() const;
};

/// A combination, and what is to be measured. Word lengths that no range names are those of the widest format that has no
/// more bits of the cosine, or of the narrowest.
struct sweep_point {
  word_lengths bits;
  option_values options;
  specular::rounding how;
  selection asked;

  /// The named format that has these word lengths and rounds so, and whose hardware can therefore be exported and measured.
  std::optional<std::string> format() const;

  /// "cos_8_coefficient_8_square_16": the file of its row; options of which the sweep has one value and the rounding to
  /// nearest are left out.
  std::string name(const sweep& of) const;
};

/// The combinations that the laws allow, and how many they refuse.
std::pair<std::vector<sweep_point>, std::size_t> points_of(const sweep& of);

/// A measured row.
struct sweep_row {
  sweep_point point;
  error_table errors;
};

struct sweep_settings {
  std::string folder;  ///< empty: nothing is kept
  shard part;
  int threads = 1;
};

/// Measures what the folder does not have yet.
/// \param advanced  called with the share that is done
/// \return rows of the shard, in the order of points_of()
/// \throws usage_error if the folder belongs to another sweep, another run is at work in it, or it cannot be written
std::vector<sweep_row> run_sweep(const sweep& of, const sweep_settings& settings,
                                 const std::function<void(double)>& advanced);

/// Copies the rows of shards into one folder, all of them or none.
/// \return the rows of the whole sweep
/// \throws usage_error if the folders are not shards of one sweep, or rows are missing
std::pair<sweep, std::vector<sweep_row>> merge_shards(const std::vector<std::string>& folders,
                                                      const std::string& to);

/// The rows as `blysk explore --json` prints them.
nlohmann::ordered_json json_rows(const sweep& of, const std::vector<sweep_row>& rows,
                                 const std::vector<domain>& domains);

}  // namespace blysk::cost
