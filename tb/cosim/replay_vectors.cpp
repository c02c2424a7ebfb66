// SPDX-License-Identifier: Apache-2.0
// replay_vectors FORMAT COUNT: random writes and what the bit-accurate model makes of them, a line for each
// "n cos r g b red green blue", all raw integers.
#include "tb/cosim/vectors.h"

#include <fmt/format.h>

#include "tb/bit/quadratic.h"

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: replay_vectors FORMAT COUNT\n");
    return 2;
  }
  blysk::device_options options;
  options.format = argv[1];
  const auto model = blysk::bit::make_quadratic(options);
  blysk::results out;
  blysk::cosim::for_random_inputs(
      blysk::fraction_bits(options), std::stoull(argv[2]), 1, [&](const blysk::batch& in) {
        model->run(in, out);
        for (std::size_t i = 0; i < in.size(); ++i) {
          fmt::print("{} {} {} {} {} {} {} {}\n", in.n[i], in.cos_delta[i], in.red_ks[i], in.green_ks[i],
                     in.blue_ks[i], out.red[i], out.green[i], out.blue[i]);
        }
      });
  return 0;
}
