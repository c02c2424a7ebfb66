// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/parse_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "tb/usage_error.h"

namespace blysk::cli {
namespace {

/// "blysk simulate", as far as verbs were given.
std::string called(const CLI::App& program, std::string name) {
  for (const CLI::App* verb : program.get_subcommands()) name = called(*verb, name + " " + verb->get_name());
  return name;
}

/// CLI11 would take the next argument for the value.
void expect_values(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--") return;
    if (word.starts_with("--") && word.find('=') == word.size() - 1)
      throw usage_error(fmt::format("{} has no value, expected one", word.substr(0, word.size() - 1)));
  }
}

/// What most options would take for not given. An option that may stand without a value has an empty one then.
void expect_no_empty_value(const CLI::App& program) {
  for (const CLI::Option* option : program.get_options()) {
    const auto& values = option->results();
    if (option->nonpositional() && option->get_expected_min() > 0 &&
        std::ranges::any_of(values, &std::string::empty))
      throw usage_error(fmt::format("{} is '', expected a value", option->get_name()));
  }
  // Verbs that were called, and groups of options.
  for (const CLI::App* each : program.get_subcommands(nullptr)) {
    if (each->parsed() || each->get_name().empty()) expect_no_empty_value(*each);
  }
}

}  // namespace

void parse_arguments(CLI::App& program, const std::string& name, int argc, char** argv) {
  expect_values(argc, argv);
  program.parse_complete_callback([&program] { expect_no_empty_value(program); });
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success&) {
    throw;
  } catch (const CLI::Error& error) {
    std::vector<std::string> unknown = program.remaining(true);
    std::erase(unknown, "--");
    if (unknown.empty()) {
      expect_no_empty_value(program);
      constexpr std::string_view kOverride = " was given a disallowed flag override";
      if (const std::string_view what = error.what(); what.ends_with(kOverride))
        throw usage_error(fmt::format("--{} is followed by a value, expected none, see {} --help",
                                      what.substr(0, what.size() - kOverride.size()), called(program, name)));
      throw usage_error(fmt::format("{}, see {} --help", error.what(), called(program, name)));
    }
    const auto option =
        std::ranges::find_if(unknown, [](const std::string& word) { return word.starts_with('-'); });
    throw usage_error(fmt::format("'{}' is unknown, see {} --help",
                                  printable(option == unknown.end() ? unknown.front() : *option),
                                  called(program, name)));
  }
}

}  // namespace blysk::cli
