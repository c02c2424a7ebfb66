// SPDX-License-Identifier: Apache-2.0
/// How long the blocks of a device take, as synthesis and timing tools measured it.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace blysk {

/// A port of a block.
struct timed_pin {
  std::string name;
  int width;
};

/// How long a block takes from each bit of its inputs to each bit of its outputs.
struct block_delays {
  static constexpr int kNoPath = -1;

  std::string block;              ///< its path within the device, "mul7"
  std::vector<timed_pin> inputs;  ///< those of one bit are controls
  std::vector<timed_pin> outputs;

  /// ps, the worst of both edges, or kNoPath: [output][bit of the output][bit of the inputs], the inputs one after the
  /// other, each from its lowest bit on. Of a register: from its clock.
  std::vector<std::vector<std::vector<int>>> ps;

  int input_bits() const {
    int bits = 0;
    for (const timed_pin& each : inputs) bits += each.width;
    return bits;
  }
};

/// A block on the longest path that static timing finds.
struct path_step {
  std::string block;
  int ps;  ///< what the path takes in it
};

/// The delays of a device in a format with options.
struct device_delays {
  std::string device, format;
  std::map<std::string, std::string> options;  ///< those that differ from their presets
  std::string digest;                          ///< of the Verilog that was measured
  std::map<std::string, std::string> tools;    ///< what each says of its version
  std::string script;                          ///< what the tools were told
  std::vector<path_step> path;                 ///< from a register to an output, by OpenSTA
  int bound_ps = 0;                            ///< the longest path from bit to bit through the blocks
  int blocks_bound_ps = 0;                     ///< the same if all bits of a block took as long as its worst
  std::vector<block_delays> blocks;
  std::string file = {};  ///< where they were read, for messages

  int path_ps() const {
    int sum = 0;
    for (const path_step& each : path) sum += each.ps;
    return sum;
  }
};

}  // namespace blysk
