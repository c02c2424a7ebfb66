// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <stdexcept>

#include "tb/cli/verbs.h"
#include "tb/csv_reader.h"
#include "tb/golden/registry.h"
#include "tb/output_file.h"

namespace blysk::cli {
namespace {

struct options {
  std::string name, points, results;
};

double parse_real(csv_reader& rows, std::size_t column) {
  const std::string_view field = rows.fields()[column];
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc{} || end != field.data() + field.size()) throw rows.error(column, "a real number");
  return value;
}

void run(const options& asked) {
  const golden::model* const model = golden::find_model(asked.name);
  if (model == nullptr) {
    throw usage_error(fmt::format("model '{}' does not exist, expected a name from blysk list", asked.name));
  }
  expect_different_files({"--points", "--results"}, {asked.points, asked.results});
  csv_reader rows(asked.points, model->header);
  output_file results(asked.results);
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{},value\n", model->header);
  std::vector<double> inputs;
  while (rows.next()) {
    inputs.clear();
    for (std::size_t column = 0; column < rows.fields().size(); ++column)
      inputs.push_back(parse_real(rows, column));
    try {
      fmt::format_to(std::back_inserter(text), "{},{:.17g}\n", rows.text(), model->value(inputs));
    } catch (const std::domain_error& error) {
      throw rows.error(error.what());
    }
    constexpr std::size_t kFlushBytes = std::size_t{1} << 16;
    if (text.size() >= kFlushBytes) {
      results.write({text.data(), text.size()});
      text.clear();
    }
  }
  results.write({text.data(), text.size()});
  results.commit();
}

}  // namespace

void add_model(CLI::App& program) {
  auto* verb = program.add_subcommand("model", "Evaluate a golden reflectance model on points of a CSV file");
  auto asked = std::make_shared<options>();
  verb->add_option("NAME", asked->name, "one of the models of blysk list")->required();
  verb->add_option("--points", asked->points, "CSV with the model's header, - for standard input")
      ->required();
  verb->add_option("--results", asked->results,
                   "CSV to write: the points and their value, 17 digits; - for standard output")
      ->required();
  verb->footer(
      "Examples:\n"
      "  blysk model blinn --points points.csv --results -\n"
      "  blysk model schlick --points points.csv --results values.csv && cat values.csv");
  verb->callback([asked] { run(*asked); });
}

}  // namespace blysk::cli
