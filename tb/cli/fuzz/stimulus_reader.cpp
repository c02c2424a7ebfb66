// SPDX-License-Identifier: Apache-2.0
// The stimulus of `simulate`: the first byte chooses the format and --clamp, the rest is the file. Codes that come out of
// it are legal for the device, and those that --clamp took are counted.
#include <algorithm>
#include <vector>

#include "tb/cli/rows.h"
#include "tb/device.h"
#include "tb/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blysk;
  if (size == 0) return 0;
  static const auto ports = [] {
    std::vector<std::vector<port>> of;
    for (const auto format : format_names) {
      const selection asked = choose(devices().front()->name(), std::string(format));
      of.push_back(asked.of().ports(asked));
    }
    return of;
  }();
  const std::vector<port>& of = ports[(data[0] >> 1) % ports.size()];
  const std::vector<port> columns_of = of_role(of, port::role::data);
  const fuzz::memory_file file(fuzz::text_of(data + 1, size - 1));
  try {
    csv_reader rows(file.path(), cli::stimulus_header(of));
    cli::stimulus_reader stimulus(rows, of, data[0] % 2 != 0);
    columns block;
    for (stimulus.read(block); block.size() != 0; stimulus.read(block)) {
      for (std::size_t column = 0; column < columns_of.size(); ++column) {
        const wire_format& legal = *columns_of[column].carries;
        for (std::size_t row = 0; row < block.size(); ++row) {
          const std::int64_t code = block[column].get(row);
          fuzz::expect(code >= legal.min && code <= legal.max, "a code is not legal");
        }
      }
    }
    fuzz::expect(data[0] % 2 != 0 || stimulus.clamped() == 0, "a number is clamped without --clamp");
  } catch (const usage_error& error) {
    fuzz::expect_message(error.what());
  }
  return 0;
}
