// SPDX-License-Identifier: Apache-2.0
/// Whether a layout of GTKWave fits a waveform. GTKWave itself makes rows of names that it does not find.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_set>

namespace blysk::harness {

/// Signals that a VCD file declares, with the scopes that they are in: "SystemC.rg1.q_o". Reads the header alone.
/// \throws usage_error if the file cannot be read, its header has no end, or closes a scope that it does not open
std::unordered_set<std::string> declared_signals(const std::string& vcd);

/// Rows of a layout for signals, by whether the waveform has the signal.
struct row_count {
  std::size_t shown = 0, unknown = 0;
};

/// Rows of a layout (a .gtkw file). A row is the signal's name, with "+{alias} " before it and a range as "[7:0]" after it
/// or not; lines that begin with another sign than a name does are none.
/// \throws usage_error if the file cannot be read
row_count rows_of(const std::string& layout, const std::unordered_set<std::string>& signals);

}  // namespace blysk::harness
