// SPDX-License-Identifier: Apache-2.0
/// Writes docs/verification.md and docs/tables/ from measurements, or prints rows of it.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <sstream>

#include "tb/claims/figure.h"
#include "tb/claims/page.h"
#include "tb/claims/tables/tables.h"
#include "tb/output_file.h"
#include "tb/run_program.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;
using namespace blysk::claims;
namespace fs = std::filesystem;

constexpr std::vector<table> (*kTables[])() = {article_tables, errata_tables,       error_tables,
                                               energy_tables,  angle_energy_tables, stability_tables,
                                               picture_tables};

/// File below docs/ and its text.
std::vector<std::pair<fs::path, std::string>> pages() {
  const figure_list list = measure_all();
  std::vector<std::pair<fs::path, std::string>> result{
      {"verification.md", verification_page(all_claims(), list)},
      {fs::path("tables") / "measured.json", to_json(list)}};
  for (const auto& make : kTables) {
    for (const auto& t : make())
      result.emplace_back(fs::path("tables") / t.file, std::string(kGenerated) + t.text);
  }
  return result;
}

/// All pages, or none if one cannot be written.
int write_pages(const fs::path& docs) {
  std::vector<std::unique_ptr<output_file>> files;
  for (const auto& [path, text] : pages()) {
    fs::create_directories((docs / path).parent_path());
    files.push_back(std::make_unique<output_file>((docs / path).string()));
    files.back()->write(text);
    files.back()->close();
  }
  for (const auto& file : files) file->commit();
  return 0;
}

int check_pages(const fs::path& docs) {
  int result = 0;
  for (const auto& [path, text] : pages()) {
    std::ifstream file(docs / path, std::ios::binary);
    std::istringstream expected(text);
    std::string have;
    std::string want;
    for (int line = 1;; ++line) {
      const bool more_have = static_cast<bool>(std::getline(file, have));
      const bool more_want = static_cast<bool>(std::getline(expected, want));
      if (!more_have && !more_want) break;
      if (more_have != more_want || have != want) {
        std::cerr << "claims: " << (docs / path).string() << ":" << line << ": stale; measured now:\n"
                  << (more_want ? want : "(end of page)") << "\n";
        result = 1;
        break;
      }
    }
  }
  return result;
}

int print_row(const std::string& id) {
  const claim& c = claim_of(id);
  const auto found = all_measurements().find(id);
  std::cout << row_text(c, print_all(c, found == all_measurements().end() ? figures{} : found->second()));
  return 0;
}

int run(int argc, char** argv) {
  CLI::App program{"claims: what the seeds claim, beside what is measured", "claims"};
  program.footer("Exit status: 0 done, 1 a page is stale, 2 bad use or a file that cannot be written.");
  std::string output;
  std::string check;
  std::string row;
  auto* choice = program.add_option_group("action")->require_option(1);
  choice->add_option("--output", output, "Write DOCS/verification.md and DOCS/tables/")->type_name("DOCS");
  choice->add_option("--check", check, "Measure again; exit 1 if a page of DOCS differs")->type_name("DOCS");
  choice->add_option("--row", row, "Measure and print one row, for example T4")->type_name("ID");
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    throw usage_error(std::string(error.what()) + ", see claims --help");
  }
  if (!output.empty()) return write_pages(output);
  if (!check.empty()) return check_pages(check);
  return print_row(row);
}

}  // namespace

int main(int argc, char** argv) {
  return blysk::run_program("claims", [&] { return run(argc, argv); });
}
