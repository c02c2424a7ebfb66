// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <map>
#include <string>

#include "tb/device.h"

namespace blysk {

/// A device, its format and options as a command line gives them.
struct asked_device {
  std::string device = devices().front()->name();
  std::string format = "q16";
  std::map<std::string, std::string> options;  ///< those that were given

  /// \throws std::invalid_argument as blysk::choose() does
  selection choose(purpose is_for = purpose::hardware) const {
    return blysk::choose(device, format, options, is_for);
  }

  /// "blysk_NAME_2_q16" for NAME-2: of the Verilog top module that is exported for it. Of an alias it is not
  /// selection::top_name(): several of them stand in one design.
  std::string export_name() const;
};

/// Adds --device, --format and the options of all devices; choose() refuses those that the device does not have.
/// \param arguments  outlives the command line
/// \param takes      of the devices that the help names; none: all
void add_device_arguments(CLI::App& verb, asked_device& arguments, purpose is_for,
                          const std::function<bool(const device&)>& takes = {});

}  // namespace blysk
