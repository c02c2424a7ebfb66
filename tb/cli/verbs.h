// SPDX-License-Identifier: Apache-2.0
/// The verbs of the program: each adds its options to the command line and runs when it is named.
#pragma once

#include <CLI/CLI.hpp>

namespace blysk::cli {

void add_model(CLI::App& program);
void add_export(CLI::App& program);
void add_list(CLI::App& program);
void add_render(CLI::App& program);
void add_settle(CLI::App& program);
void add_vectors(CLI::App& program);

/// \param status  becomes the program's exit status; outlives it
void add_simulate(CLI::App& program, int& status);
void add_check(CLI::App& program, int& status);
void add_explore(CLI::App& program, int& status);

}  // namespace blysk::cli
