// SPDX-License-Identifier: Apache-2.0
// A file of delays: what is read is written as it was read, and has a delay or none for each pair of bits; anything else is
// refused in one printable line.
#include "tb/cost/delays.h"

#include <string>

#include "tb/cost/cost_row.h"
#include "tb/fuzz/fuzz.h"
#include "tb/usage_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blysk;
  try {
    const device_delays read = cost::parse_delays("file", std::string(fuzz::text_of(data, size)));
    for (const block_delays& block : read.blocks) {
      fuzz::expect(block.ps.size() == block.outputs.size(), "an output has no delays");
      for (std::size_t i = 0; i < block.ps.size(); ++i) {
        fuzz::expect(block.ps[i].size() == static_cast<std::size_t>(block.outputs[i].width),
                     "a bit has no delays");
        for (const auto& row : block.ps[i])
          fuzz::expect(row.size() == static_cast<std::size_t>(block.input_bits()),
                       "a bit of the inputs is missing");
      }
    }
    const std::string stored = cost::stored_text(cost::json_of(read));
    fuzz::expect(cost::stored_text(cost::json_of(cost::parse_delays("file", stored))) == stored,
                 "what was written is read as something else");
  } catch (const usage_error& error) {
    fuzz::expect_message(error.what());
  }
  return 0;
}
