// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "tb/cli/verbs.h"
#include "tb/csv_reader.h"
#include "tb/golden/registry.h"
#include "tb/output_file.h"
#include "tb/progress.h"
#include "tb/read_number.h"

namespace blysk::cli {
namespace {

struct options {
  std::string name, points, results;
  bool clamps = false;
};

/// Columns of a model whose numbers lie in [0, 1].
bool is_cosine(std::string_view column) {
  constexpr std::array<std::string_view, 5> cosines{"cos", "nh", "nl", "nv", "vh"};
  return std::ranges::find(cosines, column) != cosines.end();
}

/// Reads points, counts those that were clamped.
class point_reader {
 public:
  point_reader(csv_reader& rows, std::string_view header, bool clamps) : rows_(rows), clamps_(clamps) {
    while (!header.empty()) {
      const std::size_t comma = std::min(header.find(','), header.size());
      are_cosines_.push_back(is_cosine(header.substr(0, comma)));
      header.remove_prefix(std::min(comma + 1, header.size()));
    }
  }

  std::uint64_t clamped() const { return clamped_; }

  void read(std::vector<double>& inputs) {
    inputs.clear();
    for (std::size_t column = 0; column < are_cosines_.size(); ++column) {
      const std::optional<double> value = read_real(rows_.fields()[column]);
      if (!value) throw rows_.error(column, "a real number");
      inputs.push_back(*value);
      const bool is_near = are_cosines_[column] && *value >= -kClampReach && *value <= 1 + kClampReach;
      const double nearest = std::clamp(*value, 0.0, 1.0);
      if (!clamps_ || !is_near || nearest == *value) continue;
      inputs.back() = nearest;
      ++clamped_;
    }
  }

 private:
  csv_reader& rows_;
  bool clamps_;
  std::vector<bool> are_cosines_;
  std::uint64_t clamped_ = 0;
};

void run(const options& asked) {
  const golden::model* const model = golden::find_model(asked.name);
  if (model == nullptr) {
    throw usage_error(fmt::format("model '{}' does not exist, expected a name from blysk list", asked.name));
  }
  expect_different_files({"--points", "--results"}, {input_path(asked.points), asked.results});
  csv_reader rows(asked.points, model->header);
  point_reader points(rows, model->header, asked.clamps);
  output_file results(asked.results);
  fmt::memory_buffer text;
  std::optional<progress> shown(std::in_place, "model: bytes read", rows.file_size(),
                                !is_shown_at(asked.results));
  const auto write = [&] {
    results.write({text.data(), text.size()});
    text.clear();
    shown->reach(rows.bytes_read());
  };
  fmt::format_to(std::back_inserter(text), "{},value\n", model->header);
  std::vector<double> inputs;
  for (;;) {
    if (!rows.next_at_hand()) {  // somebody may wait for these values before he goes on
      write();
      results.flush();
      if (!rows.next()) break;
    }
    points.read(inputs);
    try {
      const double value = model->value(inputs);
      if (!std::isfinite(value))
        throw std::domain_error(fmt::format("value is {}, expected columns that give a finite one", value));
      fmt::format_to(std::back_inserter(text), "{},{:.17g}\n", fmt::join(rows.fields(), ","), value);
    } catch (const std::domain_error& error) {
      throw rows.error(error.what());
    }
    constexpr std::size_t kFlushBytes = std::size_t{1} << 16;
    if (text.size() >= kFlushBytes) write();
  }
  shown.reset();
  results.commit();
  if (asked.clamps)
    fmt::print(is_standard_output(asked.results) ? stderr : stdout, "{} clamped\n", points.clamped());
}

}  // namespace

void add_model(CLI::App& program) {
  auto* verb = program.add_subcommand("model", "Evaluate a golden reflectance model on points of a CSV file");
  auto asked = std::make_shared<options>();
  verb->add_option("NAME", asked->name, "one of the models of blysk list")->required();
  verb->add_option(
          "--points", asked->points,
          "CSV with the columns of the model, see blysk list; others are passed over; - for standard input")
      ->required();
  verb->add_option("--results", asked->results,
                   "CSV to write: the points and their value, 17 digits; - for standard output")
      ->required();
  verb->add_flag(
      "--clamp", asked->clamps,
      "take cosines not more than 2^-23 outside [0, 1], as rounding leaves them, for 0 or 1, and count them");
  verb->footer(
      "Examples:\n"
      "  blysk model blinn --points points.csv --results -\n"
      "  blysk model schlick --points points.csv --results values.csv && cat values.csv");
  verb->callback([asked] { run(*asked); });
}

}  // namespace blysk::cli
