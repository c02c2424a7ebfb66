// SPDX-License-Identifier: Apache-2.0
// What no device takes: one line that says what was expected, status 2, and nothing written. For every device of the list.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tb/catch.h"
#include "tb/cli/test/program.h"
#include "tb/device.h"

namespace {

using namespace blysk;

std::string number(std::int64_t code, const wire_format& of) {
  return fmt::format("{}", std::ldexp(static_cast<double>(code), -of.frac));
}

/// A device, a stimulus that it takes, and what is refused besides.
class victim {
 public:
  explicit victim(const device& of)
      : device_(of),
        data_(of_role(of.ports(choose(of.name(), "q8", {})), port::role::data)),
        header_(column_names(data_, port::role::data)) {
    for (const port& each : data_) good_.push_back(number(each.carries->min, *each.carries));
  }

  const device& of() const { return device_; }
  const std::vector<port>& data() const { return data_; }
  const std::string& header() const { return header_; }
  const std::vector<std::string>& good() const { return good_; }

  std::string with(std::size_t column, const std::string& field) const {
    std::vector<std::string> fields = good_;
    fields.at(column) = field;
    return text(header_, fields);
  }

  static std::string text(const std::string& header, const std::vector<std::string>& fields) {
    return fmt::format("{}\n{}\n", header, fmt::join(fields, ","));
  }

  outcome run(const scratch& folder, const std::string& stimulus, const std::string& more) const {
    folder.write("in.csv", stimulus);
    return run_blysk(
        folder, fmt::format("simulate --device {} --format q8 {} --stimulus {} --results {}", device_.name(),
                            more, quoted(folder.path("in.csv")), quoted(folder.path("out.csv"))));
  }

  /// The refusal has the words.
  void refuses(const scratch& folder, const std::string& words, const std::string& stimulus,
               const std::string& more = "") const {
    CAPTURE(device_.name(), more, stimulus);
    is_refused(run(folder, stimulus, more), words);
    CHECK(!fs::exists(folder.path("out.csv")));
  }

  /// One line says so, and has the words.
  static void is_refused(const outcome& got, const std::string& words) {
    CAPTURE(got.err);
    CHECK(got.status == 2);
    CHECK(got.out.empty());
    CHECK(got.err.starts_with("blysk: "));
    CHECK(std::ranges::count(got.err, '\n') == 1);
    CHECK(got.err.ends_with('\n'));
    CHECK(got.err.find(words) != std::string::npos);
    CHECK(got.err.find("expected") != std::string::npos);
  }

 private:
  const device& device_;
  std::vector<port> data_;
  std::string header_;
  std::vector<std::string> good_;
};

/// Calls use(victim) for every device, after it has shown that it takes its good row.
template <class Use>
void for_devices(const scratch& folder, Use use) {
  REQUIRE(devices().size() > 10);
  for (const device* each : devices()) {
    const victim of(*each);
    const outcome good = of.run(folder, victim::text(of.header(), of.good()), "");
    CAPTURE(each->name(), good.err);
    REQUIRE(good.status == 0);
    REQUIRE(fs::exists(folder.path("out.csv")));
    fs::remove(folder.path("out.csv"));
    use(of);
  }
}

}  // namespace

TEST_CASE("every device refuses numbers outside the range of their column, and texts that are none",
          "[cli]") {
  const scratch folder;
  for_devices(folder, [&](const victim& of) {
    for (std::size_t i = 0; i < of.data().size(); ++i) {
      const wire_format& legal = *of.data()[i].carries;
      const std::string& column = of.data()[i].column;
      for (const std::string& field :
           {number(legal.min - 1, legal), number(legal.max + 1, legal), std::string("x"), std::string()}) {
        if (field.empty() && of.data().size() == 1) continue;  // an empty line is none
        of.refuses(folder, fmt::format("in.csv:2: {} is '{}', expected ", column, field), of.with(i, field));
      }
    }
  });
}

TEST_CASE("every device refuses the header of another one, and rows of another length", "[cli]") {
  const scratch folder;
  for_devices(folder, [&](const victim& of) {
    std::vector<std::string> fields = of.good();
    of.refuses(folder, "in.csv:1: header is 'some,thing', expected " + of.header(),
               victim::text("some,thing", {"1", "1"}));
    if (fields.size() > 1) {
      const std::string shorter = of.header().substr(0, of.header().rfind(','));
      fields.pop_back();
      of.refuses(folder, "expected " + of.header(), victim::text(shorter, fields));
      of.refuses(folder,
                 fmt::format("in.csv:2: row has {} fields, expected {}", fields.size(), of.good().size()),
                 victim::text(of.header(), fields));
    }
    of.refuses(folder, "in.csv:1: is empty, expected the header " + of.header(), "");
  });
}

TEST_CASE("every device refuses options that it does not have, and values that its own do not have",
          "[cli]") {
  const scratch folder;
  std::map<std::string, std::string>
      values;                   // of each option's name; what the first device has is how a flag is told
  std::set<std::string> flags;  // options that are one of some device: they may stand without a value
  for (const device* each : devices()) {
    for (const option& own : each->options()) {
      values.try_emplace(own.name, own.is_flag() ? "" : " 1");
      if (own.is_flag()) flags.insert(own.name);
    }
  }
  for_devices(folder, [&](const victim& of) {
    const std::string good = victim::text(of.header(), of.good());
    const std::vector<option> options = of.of().options();
    for (const auto& [name, value] : values) {
      const auto own = std::ranges::find(options, name, &option::name);
      if (own == options.end()) {
        of.refuses(folder, fmt::format("device {} has no option --{}", of.of().name(), name), good,
                   fmt::format("--{}{}", name, value));
      } else if (!own->is_flag()) {
        of.refuses(folder, "nosuch", good, fmt::format("--{} nosuch", name));
        of.refuses(
            folder,
            fmt::format("--{} is {}", name,
                        flags.contains(name) ? "on, expected " : "followed by --stimulus, expected a value"),
            good, fmt::format("--{}", name));
      }
    }
  });
}

TEST_CASE("engine timed and settle are for devices with strobes", "[cli]") {
  const scratch folder;
  for_devices(folder, [&](const victim& of) {
    if (protocol_of(of.of().ports(choose(of.of().name(), "q8", {}))) == protocol::strobes) return;
    const std::string words =
        fmt::format("device {} takes its inputs by start and ready, expected one", of.of().name());
    of.refuses(folder, words, victim::text(of.header(), of.good()), "--engine timed");
    CAPTURE(of.of().name());
    victim::is_refused(run_blysk(folder, fmt::format("settle --device {} --format q8", of.of().name())),
                       words);
  });
}
