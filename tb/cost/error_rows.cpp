// SPDX-License-Identifier: Apache-2.0
// error_rows DEVICE FORMAT... --output|--check FOLDER [--options LINE]: errors of a device in each format, as
// FOLDER/<identifier>/errors_<format>.json. Exit 1 if --check finds another text there.
#include <fmt/format.h>

#include <filesystem>
#include <sstream>

#include "tb/cost/cost_row.h"
#include "tb/cost/errors.h"
#include "tb/program.h"
#include "tb/progress.h"

namespace {

using namespace blysk;
namespace fs = std::filesystem;

struct options {
  std::string output, check, device;
  std::vector<std::string> formats;
  std::string line;
  int threads = 1;
};

/// "--rom clocked" by name, a flag as "on".
std::map<std::string, std::string> options_of(const std::string& line) {
  std::map<std::string, std::string> given;
  std::istringstream words(line);
  std::string name;
  for (std::string word; words >> word;) {
    if (word.starts_with("--")) {
      name = word.substr(2);
      given[name] = "on";
    } else {
      given[name] = word;
    }
  }
  return given;
}

std::string text_of(const selection& asked, int threads) {
  progress shown(asked.text(), 1000);
  std::size_t before = 0;
  const cost::error_table table = measure_errors(cost::judge(asked), threads, [&](double share) {
    const auto now = static_cast<std::size_t>(1000 * share);
    shown.advance(now - before);
    before = now;
  });
  return cost::stored_text({{"device", asked.of().name()},
                            {"format", asked.format()},
                            {"options", cost::given_options(asked)},
                            {"domains", json_of(table)}});
}

bool is_current(const std::string& path, const std::string& text) {
  if (fs::exists(path) && cost::read_text(path) == text) return true;
  fmt::print("{} is stale: the target update_errors writes it\n", path);
  return false;
}

int run(const options& asked) {
  bool is_fine = true;
  for (const std::string& format : asked.formats) {
    const selection chosen = choose(asked.device, format, options_of(asked.line));
    const fs::path folder = asked.check.empty() ? asked.output : asked.check;
    const std::string path = (folder / cost::row_path("errors", chosen)).string();
    const std::string text = text_of(chosen, asked.threads);
    if (!asked.check.empty()) {
      is_fine = is_current(path, text) && is_fine;
      continue;
    }
    fs::create_directories(fs::path(path).parent_path());
    cost::write_text(path, text);
  }
  return is_fine ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  options asked;
  return run_program(
      argc, argv, "Measures a device's BRDF against cos^n at every input",
      [&](CLI::App& program) {
        program.add_option("DEVICE", asked.device, "name of a device")->required();
        program.add_option("FORMAT", asked.formats, "named formats")->required();
        program.add_option("--options", asked.line, "of the device, in one word: '--rom clocked'");
        program.add_option("--threads", asked.threads, "at work")
            ->check(CLI::Range(1, 256))
            ->capture_default_str();
        auto* actions = program.add_option_group("action");
        actions->add_option("--output", asked.output, "folder to write below, such as docs/tables");
        actions->add_option("--check", asked.check, "folder to compare with");
        actions->require_option(1);
      },
      [&] { return run(asked); });
}
