// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/device_arguments.h"

namespace blysk::cli {

void add_device_arguments(CLI::App& verb, device_options& device,
                          const std::vector<std::string>& coefficients) {
  verb.add_option("--device", device.device, "device")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(device_names), std::end(device_names))))
      ->capture_default_str();
  verb.add_option("--format", device.format, "fraction bits of cos(delta)")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(format_names), std::end(format_names))))
      ->capture_default_str();
  verb.add_option(
          "--coefficient", device.coefficient,
          "a = 0.786 n + 0.5 (published), 0.78694 n - 0.5 (derived), formula (9) (exact, engine golden)")
      ->check(CLI::IsMember(coefficients))
      ->capture_default_str();
  verb.add_option("--constant", device.constant, "bits wired at node 31 after the point, such as 11001001");
  verb.add_flag("--as-published", device.as_published,
                "keep the negative lobe instead of clamping to [0, 1]");
}

}  // namespace blysk::cli
