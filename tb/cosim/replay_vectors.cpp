// SPDX-License-Identifier: Apache-2.0
// replay_vectors FORMAT COUNT: random writes and what the bit-accurate model makes of them, a line for each
// "n cos r g b red green blue", all raw integers.
#include "tb/bit/quadratic.h"
#include "tb/cosim/program.h"
#include "tb/cosim/vectors.h"

namespace {

int print_vectors(int argc, char** argv) {
  using namespace blysk;
  if (argc != 3) throw std::invalid_argument("usage: replay_vectors FORMAT COUNT");
  device_options options;
  options.format = argv[1];
  const std::uint64_t count = cosim::positive("COUNT", argv[2]);
  const auto model = bit::make_quadratic(options);
  results out;
  cosim::for_random_inputs(fraction_bits(options), count, 1, [&](const batch& in) {
    model->run(in, out);
    for (std::size_t i = 0; i < in.size(); ++i) {
      fmt::print("{} {} {} {} {} {} {} {}\n", in.n[i], in.cos_delta[i], in.red_ks[i], in.green_ks[i],
                 in.blue_ks[i], out.red[i], out.green[i], out.blue[i]);
    }
  });
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return blysk::cosim::program([&] { return print_vectors(argc, argv); });
}
