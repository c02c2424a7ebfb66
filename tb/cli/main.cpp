// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <systemc>

#include "tb/cli/files.h"
#include "tb/cli/verbs.h"

namespace {

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
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return program.exit(success);
  } catch (const CLI::Error& error) {
    fmt::print(stderr, "blysk: {}, see blysk --help\n", error.what());
    return 2;
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
  } catch (const blysk::cli::usage_error& error) {
    fmt::print(stderr, "blysk: {}\n", error.what());
  } catch (const std::exception& error) {
    fmt::print(stderr, "blysk: {}\n", error.what());
  }
  return 2;
}
