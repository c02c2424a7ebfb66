// SPDX-License-Identifier: Apache-2.0
/// What a device says of its ports, for the readers of its pins(): test benches, CSV files, waveforms, Verilog export.
#pragma once

namespace blysk {

/// A port, or a net that is reported as a result.
struct pin {
  const char* name;    ///< as SystemC and Verilog have it, "cos_i"
  const char* number;  ///< in the figure, "18"; empty if it has none
  const char* wave;    ///< name of the wire in a waveform, "cos18"
  const char* note;    ///< what it is, "cos(delta), 0..1"
};

/// When a register takes its data.
enum class write_edge {
  level,    ///< at each rising edge of clk that sees the strobe at one
  trailing  ///< at the rising edge of clk that sees the strobe at zero after one that saw it at one
};

}  // namespace blysk
