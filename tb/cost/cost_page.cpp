// SPDX-License-Identifier: Apache-2.0
// cost_page [--check] TABLES PAGE...: the generated blocks of pages, from the measured rows below TABLES. Exit 1 if
// --check finds another text.
#include <fmt/format.h>

#include "tb/cost/page.h"
#include "tb/program.h"

namespace {

using namespace blysk;

int run(const std::string& tables, const std::vector<std::string>& pages, bool is_check) {
  std::vector<cost::configuration> all = cost::read_measured(tables);
  cost::look_for_stale(all);
  bool is_fine = true;
  for (const std::string& path : pages) {
    const std::string page = cost::read_text(path);
    const std::string made = with_generated_blocks(path, page, all);
    if (made == page) continue;
    if (is_check) {
      fmt::print("{} is stale: the target update_cost_page writes it\n", path);
      is_fine = false;
      continue;
    }
    cost::write_text(path, made);
  }
  return is_fine ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  std::string tables;
  std::vector<std::string> pages;
  bool is_check = false;
  return run_program(
      argc, argv, "Makes the tables of measured rows in pages",
      [&](CLI::App& program) {
        program.add_flag("--check", is_check, "compare instead");
        program.add_option("TABLES", tables, "folder of the measured rows, such as docs/tables")->required();
        program.add_option("PAGE", pages, "to write")->required();
      },
      [&] { return run(tables, pages, is_check); });
}
