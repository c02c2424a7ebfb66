// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tb/cli/numbers.h"
#include "tb/cli/vector_text.h"
#include "tb/cli/verbs.h"
#include "tb/device_arguments.h"
#include "tb/progress.h"

namespace blysk::cli {
namespace {

struct options {
  asked_device device;
  std::string answers = "-";
  std::size_t shown = 10;
  bool json = false;
};

/// Judges what hardware answered; collects the first differences.
class judge {
 public:
  judge(const selection& asked, std::size_t most_shown)
      : ports_(asked.of().ports(asked)),
        in_(inputs_of(ports_)),
        out_(outputs_of(ports_)),
        model_(asked.of().make_bit(asked)),
        most_shown_(most_shown) {
    const std::vector<port> results = of_role(ports_, port::role::result);
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (!results[i].is_inner) columns_.push_back(i);
    }
  }

  void look_at(const answers& block) {
    model_->run(block.in, expected_);    // a row for each line
    std::optional<std::size_t> counted;  // a vector of several lines differs once
    for (std::size_t row = 0; row < block.lines.size(); ++row) {
      bool is_equal = true;
      for (std::size_t i = 0; i < out_.size(); ++i) {
        const std::int64_t wanted = expected_[columns_[i]].get(row);
        const std::int64_t got = block.out[i][row];
        if (wanted == got) continue;
        is_equal = false;
        largest_ = std::max(largest_, std::abs(got - wanted));
        note(block, row, i, wanted, got);
      }
      if (!is_equal && counted != block.vectors[row]) {
        counted = block.vectors[row];
        ++different_;
      }
    }
  }

  std::uint64_t different() const { return different_; }
  std::int64_t largest() const { return largest_; }
  const nlohmann::ordered_json& differences() const { return differences_; }

  /// "in.txt:3: n 10, cos 0.5, r 1, ...: red expected 0x1f (0.12), got 0x20 (0.125), 1 ulp more"
  static std::string text(const std::string& path, const nlohmann::ordered_json& of) {
    std::string inputs;
    for (const auto& [name, value] : of["inputs"].items())
      inputs += fmt::format("{}{} {}", inputs.empty() ? "" : ", ", name, value.get<std::string>());
    const auto ulp = of["ulp"].get<std::int64_t>();
    return fmt::format("{}:{}: {}: {} is {}, expected {}, {} ulp {}", path, of["line"].get<std::size_t>(),
                       inputs, of["port"].get<std::string>(), of["got"].get<std::string>(),
                       of["expected"].get<std::string>(), std::abs(ulp), ulp > 0 ? "more" : "less");
  }

 private:
  /// The code in hexadecimal, and what it stands for.
  static std::string code_text(const port& of, std::int64_t code) {
    const std::uint64_t wires = ~std::uint64_t{0} >> (64 - of.width());
    return fmt::format("{:x} ({})", static_cast<std::uint64_t>(code) & wires, of.carries->value(code));
  }

  void note(const answers& block, std::size_t row, std::size_t i, std::int64_t wanted, std::int64_t got) {
    if (differences_.size() == most_shown_) return;
    nlohmann::ordered_json inputs;
    for (std::size_t k = 0; k < in_.size(); ++k)
      inputs[in_[k].column] = code_text(in_[k], block.in[k].get(block.vectors[row]));
    differences_.push_back({{"line", block.lines[row]},
                            {"inputs", inputs},
                            {"port", out_[i].column},
                            {"expected", code_text(out_[i], wanted)},
                            {"got", code_text(out_[i], got)},
                            {"ulp", got - wanted}});
  }

  std::vector<port> ports_, in_, out_;
  std::unique_ptr<engine> model_;
  std::size_t most_shown_;
  std::vector<std::size_t> columns_;  // of the outputs among the results
  columns expected_;
  std::uint64_t different_ = 0;
  std::int64_t largest_ = 0;
  nlohmann::ordered_json differences_ = nlohmann::ordered_json::array();
};

int run(const options& asked) {
  const selection device = asked.device.choose();
  line_reader lines(asked.answers, "vectors with the outputs of hardware");
  answer_reader reader(lines, device);
  judge judged(device, asked.shown);
  constexpr std::size_t kBlock = 4096;
  {
    progress shown("check: bytes read", lines.file_size());
    answers block;
    for (reader.read(block, kBlock); !block.lines.empty(); reader.read(block, kBlock)) {
      judged.look_at(block);
      shown.reach(lines.bytes_read());
    }
  }
  if (asked.json) {
    const nlohmann::ordered_json json{
        {"device", device.of().name()},    {"format", device.format()},
        {"vectors", reader.count()},       {"different", judged.different()},
        {"largest_ulp", judged.largest()}, {"differences", judged.differences()}};
    fmt::print("{}\n", json.dump(2));
  } else {
    for (const auto& each : judged.differences())
      fmt::print("{}\n", judge::text(printable(lines.path()), each));
    fmt::print("{} vectors of {} {}: {}\n", reader.count(), device.of().name(), device.format(),
               judged.different() == 0
                   ? "equal"
                   : fmt::format("{} differ, by up to {} ulp", judged.different(), judged.largest()));
  }
  return judged.different() == 0 ? 0 : 1;
}

}  // namespace

void add_check(CLI::App& program, int& status) {
  auto* verb = program.add_subcommand("check", "Judge what hardware of your own answered to vectors");
  auto asked = std::make_shared<options>();
  add_device_arguments(*verb, asked->device, purpose::hardware);
  verb->add_option(
          "--answers", asked->answers,
          "file to read: lines of blysk vectors with the codes of the result ports appended; - for standard "
          "input")
      ->capture_default_str();
  verb->add_option("--differences", asked->shown, "how many differences to show")
      ->transform(whole_number(0, std::numeric_limits<std::uint32_t>::max()))
      ->capture_default_str();
  verb->add_flag("--json", asked->json, "print JSON");
  verb->footer(
      "Exit status: 0 equal, 1 different, 2 not readable: another device's vectors, a line that is cut, X or "
      "Z.\n"
      "Examples:\n"
      "  blysk check --format q8 --answers answers.txt\n"
      "  blysk check --format q8 --answers answers.txt --json");
  verb->callback([asked, &status] { status = run(*asked); });
}

}  // namespace blysk::cli
