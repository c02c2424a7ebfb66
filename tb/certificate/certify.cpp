// SPDX-License-Identifier: Apache-2.0
// certify scripts FOLDER --device D --format F ... [--bound B] [--fault F]: scripts for Gappa, FOLDER/*.g, that together say
//   |BRDF of the netlist - BRDF of the exact formula| <= B for all legal codes. Without --bound those of the cases, case_*.g,
//   ask for their error instead.
// certify compare --device D --format F ...: the definitions that Gappa is told are what the bit-accurate model computes, at
//   20,000 random inputs and at the ends of the codes. Exit 1 where they differ.
// certify row FILE --device D --format F ... --bound B --gappa VERSION: measures the largest error of the bit-accurate model,
//   and writes both as a certificate.
// certify place --device D --format F ...: prints where the certificate stands below docs/tables.
// certify page TABLES PAGE [--check]: the table of all certificates in a page.
// What is exact, and what Gappa has to be told of it, stands in tb/devices/<identifier>/certificate; specification.h has its form.
#include <fmt/format.h>

#include "tb/certificate/model.h"
#include "tb/certificate/scripts.h"
#include "tb/certificate/specification.h"
#include "tb/cost/certificate_row.h"
#include "tb/cost/cost_row.h"
#include "tb/cost/delays.h"
#include "tb/device_arguments.h"
#include "tb/netlist/gappa_path.h"
#include "tb/program.h"

namespace {

using namespace blysk;

/// What the command line asks for.
struct request {
  asked_device device;
  std::string folder, file, bound, fault, version, specification, tables, page;
  bool is_check = false;

  netlist::planted_fault planted() const {
    if (fault == "no_rounding") return netlist::planted_fault::no_rounding;
    if (fault == "narrow_words") return netlist::planted_fault::narrow_words;
    return netlist::planted_fault::none;
  }
};

int write_all_scripts(const request& asked) {
  const selection chosen = asked.device.choose();
  const auto device = chosen.of().elaborate(chosen, 0);
  write_scripts(read_specification(asked.specification, chosen.fraction()),
                netlist::read_gappa(*device, kCertifiedNet, asked.planted()), chosen.text(), asked.bound,
                asked.folder);
  return 0;
}

int compare(const request& asked) {
  return are_those_of_the_model(asked.device.choose(), asked.planted()) ? 0 : 1;
}

int write_row(const request& asked) {
  const selection chosen = asked.device.choose();
  const cost::certificate made{.device = chosen.of().name(),
                               .format = chosen.format(),
                               .options = cost::given_options(chosen),
                               .digest = cost::digest_of(chosen),
                               .gappa = asked.version,
                               .bound = std::stod(asked.bound),
                               .seen = largest_error(chosen)};
  cost::write_text(asked.file, cost::stored_text(cost::json_of(made)));
  return 0;
}

int print_place(const request& asked) {
  fmt::print("{}\n", cost::row_path("certificate", asked.device.choose()));
  return 0;
}

int write_page(const request& asked) {
  const std::string now = cost::read_text(asked.page);
  const std::string wanted = cost::with_certificates(asked.tables, asked.page, now);
  if (!asked.is_check) {
    cost::write_text(asked.page, wanted);
  } else if (now != wanted) {
    fmt::print("{} is stale: the target update_certificates writes it\n", asked.page);
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  request asked;
  int (*run)(const request&) = nullptr;
  return run_program(
      argc, argv, "Bounds the error of a device's datapath with Gappa",
      [&](CLI::App& program) {
        program.require_subcommand(1);
        const auto add = [&](const char* name, const char* what, int (*does)(const request&)) {
          CLI::App* const made = program.add_subcommand(name, what);
          made->callback([&run, does] { run = does; });
          return made;
        };
        CLI::App* const scripts = add("scripts", "write scripts for Gappa", write_all_scripts);
        scripts->add_option("FOLDER", asked.folder, "for the scripts")->required();
        scripts->add_option("--exact", asked.specification, "the device's file certificate")->required();
        CLI::App* const comparison = add("compare", "compute what Gappa is told, beside the model", compare);
        CLI::App* const row =
            add("row", "write a certificate beside the largest error that is seen", write_row);
        row->add_option("FILE", asked.file, "to write")->required();
        row->add_option("--gappa", asked.version, "its version")->required();
        CLI::App* const place =
            add("place", "print where the certificate stands below docs/tables", print_place);
        for (CLI::App* each : {scripts, comparison, row, place})
          add_device_arguments(*each, asked.device, purpose::hardware);
        for (CLI::App* each : {scripts, comparison}) {
          each->add_option("--fault", asked.fault, "planted in the netlist")
              ->check(CLI::IsMember({"none", "no_rounding", "narrow_words"}));
        }
        for (CLI::App* each : {scripts, row}) each->add_option("--bound", asked.bound, "of the error");
        CLI::App* const pages = add("page", "write the table of all certificates", write_page);
        pages->add_option("TABLES", asked.tables, "folder of the measured files")->required();
        pages->add_option("PAGE", asked.page, "with the table")->required();
        pages->add_flag("--check", asked.is_check, "fail if it differs instead");
      },
      [&] { return run(asked); });
}
