// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <sysc/tracing/sc_tracing_ids.h>

#include <algorithm>
#include <sstream>
#include <string_view>
#include <systemc>

#include "tb/cli/parse_arguments.h"
#include "tb/cli/verbs.h"
#include "tb/run_program.h"
#include "tb/usage_error.h"

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
  // Waves of nothing are nothing to warn of: a run that fails before its first write has its own message.
  sc_core::sc_report_handler::set_actions(sc_core::SC_ID_TRACING_CLOSE_EMPTY_FILE_, sc_core::SC_DO_NOTHING);
  // Standard output is for results.
  sc_core::sc_report_handler::set_handler(
      [](const sc_core::sc_report& report, const sc_core::sc_actions& actions) {
        if ((actions & sc_core::SC_DISPLAY) != 0)
          blysk::say("blysk", fmt::format("{}: {}", report.get_msg_type(), report.get_msg()));
        sc_core::sc_report_handler::default_handler(
            report, actions & ~static_cast<sc_core::sc_actions>(sc_core::SC_DISPLAY));
      });
  program.require_subcommand(1);
  program.set_version_flag("--version", "blysk " BLYSK_VERSION);
  program.footer("Exit status: 0 done, 1 a check failed or results differ, 2 bad use or bad input.");
  int status = 0;
  blysk::cli::add_simulate(program, status);
  blysk::cli::add_render(program);
  blysk::cli::add_model(program);
  blysk::cli::add_export(program);
  blysk::cli::add_list(program);
  blysk::cli::add_vectors(program);
  blysk::cli::add_check(program, status);
  blysk::cli::add_explore(program, status);
  blysk::cli::add_settle(program);
  // CLI11 would ask for a verb, but not say what was there instead.
  if (argc > 1 && argv[1][0] != '-' && !has_verb(program, argv[1])) {
    throw blysk::usage_error(fmt::format(
        "'{}' is no verb, expected simulate, render, model, export, list, vectors, check, explore or settle",
        argv[1]));
  }
  try {
    blysk::cli::parse_arguments(program, "blysk", argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    std::ostringstream text;               // a stream of C++ would not say why it cannot write
    program.exit(success, text, text);
    fmt::print("{}", text.str());
  }
  return status;
}

}  // namespace

int sc_main(int, char**) {
  return 0;
}  // SystemC's library asks for one; the program elaborates from main

int main(int argc, char** argv) {
  return blysk::run_program("blysk", [&] { return run(argc, argv); });
}
