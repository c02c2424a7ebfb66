// SPDX-License-Identifier: Apache-2.0
// replay_vectors DEVICE FORMAT COUNT --output FOLDER: COUNT random writes and what the bit-accurate model makes of them as
// FOLDER/vectors.txt, and the device's ports as FOLDER/device.vh, both for replay.v. For a device that is started the
// results stand in FOLDER/results.txt, all for replay_handshake.v.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "tb/inputs.h"
#include "tb/output_file.h"
#include "tb/program.h"

namespace blysk {
namespace {

std::string binary(std::int64_t value, int width) {
  std::string digits;
  for (int bit = width - 1; bit >= 0; --bit) digits += ((value >> bit) & 1) != 0 ? '1' : '0';
  return digits;
}

/// Slices of one register or wire of the bench, from its upper end down.
class bundle {
 public:
  explicit bundle(const std::string& name) : name_(name) {}

  void add(const port& of) { ports_.push_back(of); }
  int width() const {
    int bits = 0;
    for (const port& each : ports_) bits += each.width();
    return bits;
  }
  std::string connections() const {
    std::string text;
    int upper = width();
    for (const port& each : ports_) {
      text += fmt::format(", .{}({}[{}:{}])", each.name, name_, upper - 1, upper - each.width());
      upper -= each.width();
    }
    return text;
  }

 private:
  std::string name_;
  std::vector<port> ports_;
};

class replay {
 public:
  explicit replay(const selection& asked)
      : asked_(asked),
        ports_(asked.of().ports(asked)),
        is_strobed_(protocol_of(ports_) == protocol::strobes) {
    if (protocol_of(ports_) == protocol::none)
      throw std::invalid_argument(asked.text() + " has no protocol, expected a device with one");
    std::size_t data_column = 0;
    std::size_t result_column = 0;
    for (const port& each : ports_) {
      if (each.is == port::role::data) {
        const bool is_trailing = is_strobed_ && strobe_of(each).edge == write_edge::trailing;
        (is_trailing ? trailing_ : level_).add(each);
        (is_trailing ? trailing_columns_ : level_columns_).push_back(data_column++);
      } else if (each.is == port::role::result) {
        if (!each.is_inner) {
          results_.add(each);
          result_columns_.push_back(result_column);
        }
        ++result_column;
      }
    }
  }

  std::string header() const {
    std::string connections, stuck;
    const auto name = [&](port::role role) { return ports_[find_role(ports_, role)].name; };
    for (const port& each : ports_) {
      if (each.is == port::role::strobe)
        connections +=
            fmt::format(", .{}({})", each.name, each.edge == write_edge::trailing ? "trailing" : "level");
      if (each.is == port::role::control) connections += fmt::format(", .{}(1'b0)", each.name);
      if (each.is == port::role::start || each.is == port::role::ready)
        connections += fmt::format(", .{}({})", each.name, each.is == port::role::start ? "start" : "ready");
      if (!each.is_inner && !each.is_input())
        stuck += fmt::format(" if ($test$plusargs(\"stuck_{0}\")) force device.{0} = 0;", each.name);
    }
    return fmt::format(
        "// Made by replay_vectors; do not edit.\n"
        "{}`define LEVEL_BITS {}\n`define RESULT_BITS {}\n"
        "`define DEVICE {} device (.{}(clk), .{}(rst_n), .{}(valid){}{}{}{});\n"
        "`define STUCK{}\n",
        is_strobed_ ? fmt::format("`define TRAILING_BITS {}\n", trailing_.width()) : "", level_.width(),
        results_.width(), asked_.top_name(), name(port::role::clock), name(port::role::reset),
        name(port::role::valid), connections, trailing_.connections(), level_.connections(),
        results_.connections(), stuck);
  }

  /// A line for each write with strobes; for a device that is started, the rows and their results apart.
  struct vectors {
    std::string writes, results;
  };

  vectors make(std::uint64_t count) const {
    vectors text;
    const auto model = asked_.of().make_bit(asked_);
    columns out;
    for_random_inputs(asked_, count, 1, [&](const columns& in) {
      model->run(in, out);
      for (std::size_t row = 0; row < in.size(); ++row) {
        if (is_strobed_) text.writes += digits(in, trailing_columns_, port::role::data, row) + ' ';
        text.writes += digits(in, level_columns_, port::role::data, row);
        text.writes +=
            is_strobed_ ? ' ' + digits(out, result_columns_, port::role::result, row) + '\n' : "\n";
      }
      if (is_strobed_) return;
      for (std::size_t row = 0; row < out.size(); ++row)
        text.results += digits(out, result_columns_, port::role::result, row) + '\n';
    });
    return text;
  }

  bool is_strobed() const { return is_strobed_; }

 private:
  const port& strobe_of(const port& data) const {
    const auto found = std::ranges::find_if(
        ports_, [&](const port& each) { return each.is == port::role::strobe && each.writes == data.name; });
    if (found == ports_.end())
      throw std::invalid_argument(data.name + " has no strobe, expected a device with the strobe protocol");
    return *found;
  }

  std::string digits(const columns& of, const std::vector<std::size_t>& which, port::role role,
                     std::size_t row) const {
    const std::vector<port> described = of_role(ports_, role);
    std::string text;
    for (const std::size_t each : which) text += binary(of[each].get(row), described[each].width());
    return text;
  }

  const selection& asked_;
  std::vector<port> ports_;
  bool is_strobed_;
  bundle trailing_{"trailing_data"}, level_{"level_data"}, results_{"results"};
  std::vector<std::size_t> trailing_columns_, level_columns_, result_columns_;
};

void write(const std::string& path, const std::string& text) {
  output_file file(path);
  file.write(text);
  file.close();
  file.commit();
}

}  // namespace
}  // namespace blysk

int main(int argc, char** argv) {
  using namespace blysk;
  device_arguments arguments;
  std::string count, folder;
  return run_program(
      argc, argv, "Writes what replay.v needs: writes, their results and the ports of the device",
      [&](CLI::App& program) {
        arguments.add_to(program);
        program.add_option("COUNT", count, "writes")->required();
        program.add_option("--output", folder, "folder for vectors.txt and device.vh")->required();
      },
      [&] {
        const std::uint64_t writes = positive("COUNT", count);
        const selection asked = arguments.chosen();
        const replay text(asked);
        write(folder + "/device.vh", text.header());
        const replay::vectors made = text.make(writes);
        write(folder + "/vectors.txt", made.writes);
        if (!text.is_strobed()) write(folder + "/results.txt", made.results);
        return 0;
      });
}
