// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <string_view>
#include <systemc>

#include "tb/cli/verbs.h"
#include "tb/files.h"

namespace {

bool has_verb(const CLI::App& program, std::string_view name) {
  const auto verbs = program.get_subcommands([](const CLI::App*) { return true; });
  return std::any_of(verbs.begin(), verbs.end(),
                     [name](const CLI::App* verb) { return verb->get_name() == name; });
}

int run(int argc, char** argv) {
  CLI::App program{"blysk: the specular-colour device of patent UA 60553, its models and its simulation",
                   "blysk"};
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  program.require_subcommand(1);
  program.set_version_flag("--version", "blysk " BLYSK_VERSION);
  program.footer("Exit status: 0 done, 1 a check failed or results differ, 2 bad use or bad input.");
  blysk::cli::add_simulate(program);
  blysk::cli::add_model(program);
  blysk::cli::add_export(program);
  blysk::cli::add_list(program);
  // CLI11 would ask for a verb, but not say what was there instead.
  if (argc > 1 && argv[1][0] != '-' && !has_verb(program, argv[1])) {
    fmt::print(stderr, "blysk: '{}' is no verb, expected simulate, model, export or list\n", argv[1]);
    return 2;
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    program.exit(success);
  } catch (const CLI::Error& error) {
    fmt::print(stderr, "blysk: {}, see blysk --help\n", error.what());
    return 2;
  }
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    throw blysk::file_error("standard output", 0,
                            fmt::format("cannot be written ({})", blysk::system_reason()));
  }
  return 0;
}

}  // namespace

int sc_main(int, char**) {
  return 0;
}  // SystemC's library asks for one; the program elaborates from main

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "blysk: {}\n", error.what());
    return 2;
  }
}
