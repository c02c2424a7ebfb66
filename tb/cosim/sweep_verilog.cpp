// SPDX-License-Identifier: Apache-2.0
// sweep_verilog DEVICE FORMAT [all|corners|beside|COUNT|ROWS.csv] [--OPTION [VALUE]]...: the exported Verilog, and the reference
// written by hand where there is one for these options, against the bit-accurate model. Exit 1 if they differ anywhere.
//   all      every combination of legal codes of the enumerated ports
//   corners  those within 1024 of an end or a corner of the last of them
//   beside   every code of the other ports at every code of the last enumerated one
//   COUNT    so many random ones
//   ROWS.csv  those of a file, raw codes
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "tb/cosim/reference.h"
#include "tb/cosim/rows_file.h"
#include "tb/inputs.h"
#include "tb/program.h"
#include "tb/progress.h"

namespace blysk::cosim {
namespace {

/// Verilog that is compared with the model.
struct candidate {
  std::string name;
  std::unique_ptr<verilator_engine> verilog;
  std::uint64_t differences = 0;
};

std::vector<std::int64_t> row_of(const columns& of, std::size_t row) {
  std::vector<std::int64_t> codes;
  for (const column& each : of) codes.push_back(each.get(row));
  return codes;
}

class comparison {
 public:
  explicit comparison(const selection& asked)
      : device_(asked.of()), ports_(device_.ports(asked)), model_(device_.make_bit(asked)) {
    candidates_.push_back({"exported", make_verilator(asked)});
    if (auto reference = make_reference(asked)) candidates_.push_back({"reference", std::move(reference)});
  }

  void check(const columns& in) {
    model_->run(in, expected_);
    for (candidate& each : candidates_) {
      each.verilog->run(in, got_);
      if (got_ == expected_) continue;
      if (got_.size() != expected_.size()) {
        ++each.differences;
        fmt::print("{}: {} rows of results, expected {}\n", each.name, got_.size(), expected_.size());
        continue;
      }
      std::size_t result = 0;
      for (std::size_t row = 0; row < in.size(); ++row) {
        for (std::int64_t pixel = 0; pixel < device_.pixels(in, row); ++pixel)
          count_row(each, in, row, result++);
      }
    }
    compared_ += in.size();
  }

  /// \return  whether anything has been compared and nothing differs
  bool report(const std::string& what) const {
    bool same = compared_ > 0;
    for (const candidate& each : candidates_) {
      fmt::print("{}, {}: {} writes compared, {} differ\n", what, each.name, compared_, each.differences);
      same = same && each.differences == 0;
    }
    return same;
  }

  std::uint64_t compared() const { return compared_; }

 private:
  void count_row(candidate& of, const columns& in, std::size_t row, std::size_t result) {
    const auto got = row_of(got_, result);
    const auto expected = row_of(expected_, result);
    if (got == expected) return;
    if (++of.differences > 10) return;  // enough to see a pattern
    fmt::print("{}: {} = {}: got {} = {}, expected {}\n", of.name, column_names(ports_, port::role::data),
               fmt::join(row_of(in, row), ","), column_names(ports_, port::role::result), fmt::join(got, ","),
               fmt::join(expected, ","));
  }

  const device& device_;
  std::vector<port> ports_;
  std::unique_ptr<engine> model_;
  std::vector<candidate> candidates_;
  columns got_, expected_;
  std::uint64_t compared_ = 0;
};

/// Every code of the ports that are not enumerated, each from another one on, at every code of the last enumerated port,
/// the ones before it at their smallest.
void for_codes_beside(const selection& asked, const use_batch& use) {
  constexpr std::size_t kBatch = 4096;
  const std::vector<port> data = of_role(asked.of().ports(asked), port::role::data);
  const std::size_t enumerated = asked.of().enumerated();
  std::int64_t most = 1;
  for (std::size_t i = enumerated; i < data.size(); ++i)
    most = std::max(most, data[i].carries->max - data[i].carries->min + 1);
  columns in(data, port::role::data);
  in.resize(kBatch);
  std::size_t row = 0;
  const wire_format& last = *data[enumerated - 1].carries;
  for (std::int64_t code = last.min; code <= last.max; ++code) {
    for (std::int64_t step = 0; step < most; ++step) {
      for (std::size_t i = 0; i < data.size(); ++i) {
        const wire_format& format = *data[i].carries;
        const std::int64_t codes = format.max - format.min + 1;
        const auto shift = static_cast<std::int64_t>(i) * codes / 3;
        in[i].set(row, i + 1 < enumerated    ? format.min
                       : i + 1 == enumerated ? code
                                             : format.min + (step + shift) % codes);
      }
      if (++row == kBatch) {
        use(in);
        row = 0;
      }
    }
  }
  in.resize(row);
  if (row > 0) use(in);
}

int sweep(const selection& asked, const std::string& which) {
  comparison against_model(asked);
  std::uint64_t count = 0;  // 0: nobody counts them before
  const bool is_file = which.ends_with(".csv");
  const bool is_random = !is_file && which != "all" && which != "corners" && which != "beside";
  if (is_random) count = positive("COUNT", which);
  if (which == "all") count = input_count(asked);
  {
    progress bar(asked.folder_name(), std::max<std::uint64_t>(count, 1));
    const use_batch check = [&](const columns& in) {
      against_model.check(in);
      if (count > 0) bar.advance(in.size());
    };
    if (is_file) {
      check(read_rows(asked, which));
    } else if (is_random) {
      for_random_inputs(asked, count, 1, check);
    } else if (which == "all") {
      for_all_inputs(asked, check);
    } else if (which == "corners") {
      for_corner_inputs(asked, 1024, check);
    } else {
      for_codes_beside(asked, check);
    }
  }
  const bool same = against_model.report(asked.folder_name());
  return same && (count == 0 || against_model.compared() == count) ? 0 : 1;
}

}  // namespace
}  // namespace blysk::cosim

int main(int argc, char** argv) {
  blysk::device_arguments arguments;
  std::string which = "all";
  return blysk::run_program(
      argc, argv,
      "Compares the exported Verilog, and the reference written by hand, with the bit-accurate model",
      [&](CLI::App& program) {
        arguments.add_to(program);
        program
            .add_option(
                "INPUTS", which,
                "all: every input; corners: those near ends and corners; beside: every code of the "
                "ports that "
                "are not enumerated; a number: so many random ones; a file: its rows, raw codes in CSV")
            ->capture_default_str();
        arguments.add_options_to(program);
      },
      [&] { return blysk::cosim::sweep(arguments.chosen(), which); });
}
