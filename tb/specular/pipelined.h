// SPDX-License-Identifier: Apache-2.0
/// A device that shades points as another one does, with registers between its blocks: one point a clock cycle.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "rtl_sysc/devices/pipelined.h"
#include "tb/specular/same_values.h"

namespace blysk::specular {

/// Blocks of a pipelined device between two cuts.
struct pipeline_level {
  std::vector<std::vector<std::string>> chains;  ///< its blocks, those one behind the other in one list
  int ps;  ///< the longest chain by the worst delays of its blocks, as docs/tables has them for q12
};

/// The cuts that give one stage, two, and so on up to as many as there are levels, the shortest longest stage; of those the
/// ones whose second longest is shortest, and so on.
std::vector<std::uint64_t> balanced_cuts(const std::vector<pipeline_level>& levels);

/// The longest stage, in ps by those delays, registers left out.
int longest_stage(const std::vector<pipeline_level>& levels, std::uint64_t cuts);

/// The pipelined form of a device. Its options are those of the other one, and `stages` and `cuts`.
class pipelined : public device_of_same_values {
 public:
  std::string figure() const override;
  std::vector<option> options() const override;
  void check(const selection& asked) const override;
  std::map<std::string, std::string> canonical(const selection& asked) const override;
  std::string words(const selection& asked) const override;
  int cycles_per_row(const selection&) const override { return 1; }

  const std::vector<pipeline_level>& levels() const { return levels_; }

  /// As many stages as the shortest clock needs, by the levels' delays.
  int fewest_stages() const;

  /// The cuts that the options ask for.
  /// \throws std::invalid_argument for what is no list of cuts, and for cuts and stages together
  pipeline_cuts cuts(const selection& asked) const;

  /// The ports of the device's type, the number of stages in them.
  std::vector<port> with_stages(std::vector<port> ports, const selection& asked) const;

 protected:
  /// \param whose  the other device's name
  pipelined(std::string whose, std::vector<pipeline_level> levels)
      : device_of_same_values(std::move(whose)), levels_(std::move(levels)) {}

 private:
  const std::vector<std::uint64_t>& balanced() const;

  std::vector<pipeline_level> levels_;
  mutable std::once_flag is_balanced_;
  mutable std::vector<std::uint64_t> balanced_;
};

}  // namespace blysk::specular
