// SPDX-License-Identifier: Apache-2.0
// error_rows DEVICE FORMAT... --output|--check FOLDER [--options LINE] [--pixels DOMAIN]: errors of a device in each format,
// as FOLDER/<identifier>/errors_<format>.json. Exit 1 if --check finds another text there. With --pixels a row that is there
// gets the errors of sphere or teapot anew, which takes seconds where the other domains take an hour.
#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <sstream>

#include "tb/cost/cost_row.h"
#include "tb/cost/errors.h"
#include "tb/program.h"
#include "tb/progress.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;
namespace fs = std::filesystem;

struct options {
  std::string output, check, device;
  std::vector<std::string> formats;
  std::string line, pixels;
  int threads = 1;
};

/// Tells the line of progress what share of the work is done.
constexpr std::size_t kSteps = 1000;
std::function<void(double)> shown_by(progress& line) {
  return [&line](double share) { line.reach(static_cast<std::size_t>(kSteps * share)); };
}

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

/// The row that is there with one domain measured anew.
std::string text_with(const std::string& path, const selection& asked, const std::string& pixels,
                      int threads) {
  auto row = cost::parse_json(path, cost::read_text(path));
  if (!row.is_object() || !row.contains("domains") || !row["domains"].is_object())
    throw file_error(path, 0, "is no row of errors, expected one that error_rows wrote");
  progress shown(asked.text(), kSteps);
  row["domains"][pixels] = cost::json_of(
      measure_on_pixels(cost::judge(asked), cost::find_domain(pixels), threads, shown_by(shown)));
  return cost::stored_text(row);
}

std::string text_of(const selection& asked, int threads) {
  progress shown(asked.text(), kSteps);
  const cost::error_table table = measure_errors(cost::judge(asked), threads, shown_by(shown));
  return cost::stored_text({{"device", asked.of().name()},
                            {"format", asked.format()},
                            {"options", cost::given_options(asked)},
                            {"domains", json_of(table)}});
}

/// The text without a domain of pixels that the stored row has not: it was not measured.
std::string as_far_as(const std::string& stored, const std::string& path, const std::string& text) {
  const auto there = cost::parse_json(path, stored);
  auto row = cost::parse_json(path, text);
  const std::string name = "teapot";
  if (there.is_object() && there.contains("domains") && !there["domains"].contains(name))
    row["domains"].erase(name);
  return cost::stored_text(row);
}

bool is_current(const std::string& path, const std::string& text) {
  if (fs::exists(path)) {
    const std::string stored = cost::read_text(path);
    if (stored == as_far_as(stored, path, text)) return true;
  }
  fmt::print("{} is stale: the target update_errors writes it\n", path);
  return false;
}

int run(const options& asked) {
  bool is_fine = true;
  for (const std::string& format : asked.formats) {
    const selection chosen = choose(asked.device, format, options_of(asked.line));
    const fs::path folder = asked.check.empty() ? asked.output : asked.check;
    const std::string path = (folder / cost::row_path("errors", chosen)).string();
    const std::string text = asked.pixels.empty() ? text_of(chosen, asked.threads)
                                                  : text_with(path, chosen, asked.pixels, asked.threads);
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
        program.add_option("--pixels", asked.pixels, "domain to measure alone: sphere, teapot");
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
