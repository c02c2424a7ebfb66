// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <functional>
#include <limits>
#include <memory>

#include "tb/cli/numbers.h"
#include "tb/cli/vector_text.h"
#include "tb/cli/verbs.h"
#include "tb/device_arguments.h"
#include "tb/inputs.h"
#include "tb/output_file.h"
#include "tb/progress.h"

namespace blysk::cli {
namespace {

struct options {
  asked_device device;
  int level = 1;
  std::uint64_t seed = 1;
  bool is_seeded = false;
  std::string output = "-";
};

/// Widest format of which level 2 tries every input.
constexpr int kExhaustiveBits = 12;

/// Whether a level has random writes. All inputs are every code of the enumerated ports with the others beside; where those
/// are more than three colours, there are random writes too.
bool has_random(const options& asked, const selection& device) {
  constexpr std::size_t kColours = 3;
  if (asked.level == 1 || device.fraction() > kExhaustiveBits) return true;
  return of_role(device.of().ports(device), port::role::data).size() > device.of().enumerated() + kColours;
}

void for_level(const options& asked, const selection& device, const use_batch& use) {
  constexpr std::int64_t kReach = 2;
  constexpr std::int64_t kFarReach = 64;
  constexpr std::uint64_t kFew = 10'000;
  constexpr std::uint64_t kMany = 1'000'000;
  if (asked.level == 2 && device.fraction() <= kExhaustiveBits) {
    for_all_inputs(device, use);
    if (has_random(asked, device)) for_random_inputs(device, kMany, asked.seed, use);
    return;
  }
  for_corner_inputs(device, asked.level == 1 ? kReach : kFarReach, use);
  for_random_inputs(device, asked.level == 1 ? kFew : kMany, asked.seed, use);
}

void run(const options& asked) {
  const selection device = asked.device.choose();
  if (asked.is_seeded && !has_random(asked, device))
    throw usage_error("--seed is of random writes and level 2 has none up to q12, expected no --seed");
  const std::vector<port> inputs = inputs_of(device.of().ports(device));
  std::uint64_t count = 0;
  for_level(asked, device, [&](const columns& rows) { count += rows.size(); });
  output_file file(asked.output);
  file.write(header_text(device, count) + "\n");
  fmt::memory_buffer text;
  {
    progress shown("vectors: written", count, !is_shown_at(asked.output));
    for_level(asked, device, [&](const columns& rows) {
      append_vectors(text, inputs, rows);
      file.write({text.data(), text.size()});
      text.clear();
      shown.advance(rows.size());
    });
  }
  file.commit();
}

}  // namespace

void add_vectors(CLI::App& program) {
  auto* verb = program.add_subcommand("vectors", "Write stimuli for hardware of your own");
  auto asked = std::make_shared<options>();
  add_device_arguments(*verb, asked->device, purpose::hardware);
  verb->add_option(
          "--level", asked->level,
          "1: every n with the cosines at the ends of the range and of the lobe, and 10000 random writes; 2: "
          "up to q12 every n with every cosine, colours beside, of wider formats more around the ends and "
          "10^6 "
          "random writes; of other devices the same with their first ports in place of n and cosine, and "
          "10^6 "
          "random writes")
      ->transform(whole_number(1, 2))
      ->capture_default_str();
  verb->add_option("--seed", asked->seed, "of the random writes")
      ->transform(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
  verb->add_option("--output", asked->output, "file to write, - for standard output")->capture_default_str();
  verb->footer(
      "A line begins with # and names the device; each line below it is one write, the raw codes of the "
      "device's data\n"
      "ports in hexadecimal. `blysk check` takes the lines back with the codes of the result ports "
      "appended.\n"
      "Examples:\n"
      "  blysk vectors --format q12\n"
      "  blysk vectors --format q8 --level 2 --output vectors.txt && head -n 3 vectors.txt");
  verb->callback([asked, verb] {
    asked->is_seeded = verb->count("--seed") > 0;
    run(*asked);
  });
}

}  // namespace blysk::cli
