// SPDX-License-Identifier: Apache-2.0
/// How the program reads its command line.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace blysk::cli {

/// Parses a command line; a verb's callback runs. An argument that is unknown is named before one that is missing, and
/// an option without its value, as an unset variable of a script leaves it, is refused: --points= and --points ''.
/// \param name  of the program, for "see NAME VERB --help"
/// \throws CLI::Success for --help and --version
/// \throws usage_error if the arguments are wrong
void parse_arguments(CLI::App& program, const std::string& name, int argc, char** argv);

}  // namespace blysk::cli
