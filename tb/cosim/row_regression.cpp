// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tb/cosim/inner_results.h"
#include "tb/cosim/mutants.h"
#include "tb/cosim/regression.h"
#include "tb/cosim/strobes.h"
#include "tb/inputs.h"

namespace blysk::cosim {
namespace {

namespace fate {
enum : std::size_t {
  killed_by_strobes,
  killed_by_codes,
  killed_by_rows,
  killed_by_own_rows,
  killed_by_all_inputs,
  equivalent,
  alive
};
}
constexpr const char* kFates[] = {"killed by 20000 cycles of starts and resets",
                                  "killed by 20000 such cycles with illegal codes",
                                  "killed by random rows",
                                  "killed by rows of the device's own",
                                  "killed by all inputs",
                                  "equivalent",
                                  "alive"};

constexpr std::uint64_t kRows = 2000;
constexpr std::uint64_t kLines = 100;  // of hundreds of pixels

/// The tests of the device's ports after every edge of clk, then those of its rows. A proof is tried before all inputs, what
/// most survivors would take longest for: it holds for every sequence of inputs. Where all inputs are all rows, a mutant that
/// passes them is equivalent too, if its outputs are still a function of the row that was taken last. So is one of a device
/// that gives a point the values of another one, which is of the kind of inner_results, if start, ready and valid are left
/// alone: with rows in flight each result is still a function of its own row.
class row_regression final : public regression {
 public:
  row_regression(const selection& asked, columns own_rows, std::function<bool(unsigned)> is_proved)
      : asked_(asked),
        ports_(asked.of().ports(asked)),
        own_rows_(std::move(own_rows)),
        is_proved_(std::move(is_proved)),
        tries_all_rows_(asked.of().enumerated() == of_role(ports_, port::role::data).size()) {
    for (const auto& make : mutants_table()) modules_.push_back(make());
    find_columns();
    if (asked.of().computes_as(asked)) reached_.emplace(asked);
    for (const codes which : {codes::legal, codes::all}) {
      start(1, 0);
      std::vector<std::int64_t>& levels = which == codes::legal ? legal_ : all_;
      play_strobes(
          *module_, asked_,
          [&](std::span<const std::int64_t> now) {
            levels.insert(levels.end(), now.begin(), now.end());
            return true;
          },
          which);
    }
  }

  std::span<const char* const> fates() const override { return kFates; }

  std::size_t run(unsigned number, const mutation& what) override {
    number_ = number;
    if (differs(codes::legal, legal_)) return fate::killed_by_strobes;
    if (differs(codes::all, all_)) return fate::killed_by_codes;
    if (differs_in_random_rows()) return fate::killed_by_rows;
    if (own_rows_.size() > 0 && differs(own_rows_)) return fate::killed_by_own_rows;
    if (is_proved_(number)) return fate::equivalent;
    if (differs_in_all_inputs()) return fate::killed_by_all_inputs;
    const bool is_whole = tries_all_rows_ || (reached_ && !what.is_protocol);
    return what.is_datapath && is_whole ? fate::equivalent : fate::alive;
  }

 private:
  /// The results that the mutants show.
  void find_columns() {
    const std::vector<port> results = of_role(ports_, port::role::result);
    for (std::size_t i = 0; i < results.size(); ++i) {
      if (!results[i].is_inner) outer_.push_back(i);
    }
  }

  /// Takes the module of the mutant, resets it while it has no fault, and selects the mutant or another number.
  void start(unsigned mutant, unsigned selected) {
    module_ = modules_.at((mutant - 1) / 100).get();
    module_->select(0);
    std::vector<std::int64_t> levels(ports_.size(), 0);
    for (std::uint64_t edge = 0; edge < 2 * kResetCycles; ++edge) {
      levels[find_role(ports_, port::role::clock)] = edge % 2 == 0 ? 0 : 1;
      module_->apply(levels);
    }
    levels[find_role(ports_, port::role::clock)] = 0;
    module_->apply(levels);
    module_->select(selected);
  }

  bool differs(codes which, const std::vector<std::int64_t>& expected) {
    start(number_, number_);
    auto next = expected.begin();
    bool same = true;
    play_strobes(
        *module_, asked_,
        [&](std::span<const std::int64_t> levels) {
          same = std::equal(levels.begin(), levels.end(), next);
          next += static_cast<std::ptrdiff_t>(levels.size());
          return same;
        },
        which);
    return !same;
  }

  /// A few rows first: most mutants need no more.
  bool differs_in_random_rows() {
    const std::uint64_t most = asked_.of().draws_lines() ? kLines : kRows;
    for (std::uint64_t rows = 10; rows <= most; rows *= 10) {
      bool killed = false;
      for_random_inputs(asked_, rows, rows, [&](const columns& in) { killed = killed || differs(in); });
      if (killed) return true;
    }
    return false;
  }

  bool differs_in_all_inputs() {
    bool killed = false;
    for_all_inputs(asked_, [&](const columns& in) {
      killed = killed || differs(reached_ ? reached_->at_largest(in) : in);
    });
    if (reached_) reached_->for_others([&](const columns& in) { killed = killed || differs(in); });
    return killed;
  }

  bool differs(const columns& in) {
    start(number_, number_);
    // A model may keep what it has added up: like the module, it begins anew.
    asked_.of().make_bit(asked_)->run(in, expected_);
    try {
      module_->run(in, got_);
    } catch (const std::runtime_error&) {  // it takes no row any more
      return true;
    }
    return got_.size() != expected_.size() ||
           std::ranges::any_of(outer_, [&](std::size_t i) { return !(got_[i] == expected_[i]); });
  }

  const selection& asked_;
  std::vector<port> ports_;
  columns own_rows_;
  std::function<bool(unsigned)> is_proved_;
  bool tries_all_rows_;  // all inputs are all rows that are legal
  std::optional<inner_results> reached_;
  std::vector<std::size_t> outer_;  // columns
  std::vector<std::unique_ptr<mutants>> modules_;
  mutants* module_ = nullptr;  // the one with the mutant that runs
  unsigned number_ = 0;
  std::vector<std::int64_t> legal_, all_;  // levels of all ports after every edge, without a fault
  columns got_, expected_;
};

}  // namespace

std::unique_ptr<regression> make_row_regression(const selection& asked, columns own_rows,
                                                std::function<bool(unsigned)> is_proved) {
  return std::make_unique<row_regression>(asked, std::move(own_rows), std::move(is_proved));
}

}  // namespace blysk::cosim
