// SPDX-License-Identifier: Apache-2.0
/// What the programs of the tests have in common.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "tb/device.h"

namespace blysk {

/// The body of a main(). Bad use or bad input ends it with one line on standard error and status 2.
/// \param what      the program does, for --help
/// \param describe  adds the arguments
/// \param run       does the work when they are parsed, gives the exit status
int run_program(int argc, char** argv, const std::string& what,
                const std::function<void(CLI::App&)>& describe, const std::function<int()>& run);

/// The arguments DEVICE and FORMAT.
class device_arguments {
 public:
  void add_to(CLI::App& program);

  /// The device's own options besides, "--OPTION [VALUE]", which are none of the program's.
  void add_options_to(CLI::App& program);

  /// \throws std::invalid_argument for a device, format or option that does not exist
  selection chosen() const;

 private:
  std::string device_, format_;
  const CLI::App* with_options_ = nullptr;
};

/// \throws std::invalid_argument if the text is no decimal number above zero
std::uint64_t positive(std::string_view name, std::string_view text);

}  // namespace blysk
