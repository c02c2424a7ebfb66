// SPDX-License-Identifier: Apache-2.0
#include "tb/program.h"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <stdexcept>
#include <system_error>
#include <systemc>
#include <vector>

#include "tb/run_program.h"
#include "tb/usage_error.h"

namespace blysk {
namespace {

/// \param words  "--coefficient published --as-published"
std::map<std::string, std::string> parse_options(const std::vector<std::string>& words) {
  std::map<std::string, std::string> options;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!words[i].starts_with("--"))
      throw std::invalid_argument(fmt::format("{} is not an option, expected --OPTION [VALUE]", words[i]));
    const std::string name = words[i].substr(2);
    const bool has_value = i + 1 < words.size() && !words[i + 1].starts_with("-");
    options[name] = has_value ? words[++i] : "on";
  }
  return options;
}

}  // namespace

int run_program(int argc, char** argv, const std::string& what,
                const std::function<void(CLI::App&)>& describe, const std::function<int()>& run) {
  return run_program("blysk", [&] {
    sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
    CLI::App program{what};
    describe(program);
    try {
      program.parse(argc, argv);
    } catch (const CLI::Success& success) {  // --help
      return program.exit(success);
    } catch (const CLI::Error& error) {
      throw usage_error(fmt::format("{}, expected the arguments that --help names", error.what()));
    }
    return run();
  });
}

void device_arguments::add_to(CLI::App& program) {
  program.add_option("DEVICE", device_, "name of a device, as devices.def has it")->required();
  program.add_option("FORMAT", format_, "named format, such as q12")->required();
}

void device_arguments::add_options_to(CLI::App& program) {
  program.allow_extras();
  program.footer("The device's own options may follow, as blysk export has them.");
  with_options_ = &program;
}

selection device_arguments::chosen() const {
  if (with_options_ == nullptr) return choose(device_, format_);
  return choose(device_, format_, parse_options(with_options_->remaining()));
}

std::uint64_t positive(std::string_view name, std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value == 0)
    throw std::invalid_argument(fmt::format("{} is '{}', expected a number above zero", name, text));
  return value;
}

}  // namespace blysk

int sc_main(int, char**) {
  return 0;
}  // SystemC's library asks for one
