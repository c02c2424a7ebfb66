// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "tb/device.h"

namespace CLI {
class App;
}

namespace blysk::harness {

/// A program that makes a text of a device: NAME [--output FILE | --check FILE] [--device D] [--format F] [OPTION...]
struct text_program {
  std::string name;
  std::string description;
  std::string target;  ///< writes the checked-in files
  std::function<std::string(const selection&)> text;
  /// Whether what is made of FILE is still of this text; empty if nothing is.
  std::function<bool(const std::string& file, const std::string& text)> is_made_of = {};
  /// Options besides.
  std::function<void(CLI::App&)> add_options = {};
};

/// The body of such a program: writes the text to standard output or a file, or compares it with the file.
/// \return  exit status: 1 if the file that --check names is another
/// \throws usage_error, std::invalid_argument  for arguments that are wrong
int run_text(const text_program& of, int argc, char** argv);

}  // namespace blysk::harness
