// SPDX-License-Identifier: Apache-2.0
/// Timing diagrams, as [P] fig. 3 is one, made of recorded waves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "tb/harness/wave_changes.h"
#include "tb/port.h"

namespace blysk::harness {

struct timing_diagram {
  /// A signal: its value in each tick. A space comes before what begins a group.
  struct lane {
    std::string name;
    bool is_bus = false;
    bool begins_group = false;
    std::vector<std::string> values;
  };

  /// From the beginning of a tick in one lane to that of one in another.
  struct arrow {
    std::size_t from_lane, from_tick, to_lane, to_tick;
    std::string text;
  };

  std::string title, foot;
  std::vector<lane> lanes;
  std::vector<arrow> arrows;
};

/// The strobe protocol of a device as the waves of engine systemc show it: clock and reset, the strobes with their data,
/// valid and results. Arrows lead from the trailing edge of the strobe that writes by it to the change of the first
/// result, and from the leading edge of valid to what it confirms.
/// \param ports           of a device with strobes
/// \param half_period_ps  a tick
/// \param first, count    ticks that are shown
/// \throws std::invalid_argument if the device has no strobes, or the waves lack a port
timing_diagram diagram_of(const std::vector<port>& ports, const wave_changes& waves,
                          std::uint64_t half_period_ps, std::size_t first, std::size_t count);

/// As WaveDrom reads it (WaveJSON).
std::string wave_json(const timing_diagram& shown);

/// As a picture.
std::string svg_text(const timing_diagram& shown);

}  // namespace blysk::harness
