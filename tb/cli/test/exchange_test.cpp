// SPDX-License-Identifier: Apache-2.0
// `blysk vectors` and `blysk check`: what hardware of its user's takes, and what it answered.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tb/catch_text.h"
#include "tb/cli/test/simulate.h"

namespace {

/// Writes the vectors of q8 with the outputs of the bit-accurate engine appended.
std::string answered(const scratch& folder, const std::string& more = "") {
  const std::string vectors = run_blysk(folder, "vectors --format q8 --level 1" + more).out;
  std::string table = "n,cos,r,g,b\n";
  std::istringstream lines(vectors);
  std::string line, header;
  std::getline(lines, header);
  std::vector<std::string> inputs;
  while (std::getline(lines, line)) {
    inputs.push_back(line);
    std::array<unsigned, 5> code{};
    std::sscanf(line.c_str(), "%x %x %x %x %x", &code[0], &code[1], &code[2], &code[3], &code[4]);
    table += fmt::format("{},{},{},{},{}\n", code[0], code[1] / 256.0, code[2], code[3], code[4]);
  }
  const std::string in = folder.write("table.csv", table);
  std::istringstream results(run_blysk(folder, simulate(in, "-", "--format q8" + more)).out);
  std::getline(results, line);
  std::string text = header + "\n";
  for (const std::string& each : inputs) {
    std::getline(results, line);
    std::array<double, 3> colour{};
    std::sscanf(line.c_str(), "%*f,%*f,%*f,%*f,%*f,%*f,%lf,%lf,%lf", &colour[0], &colour[1], &colour[2]);
    text += each;
    for (const double value : colour) {
      const auto code = static_cast<std::int64_t>(value * 256);
      text += fmt::format(" {:x}", static_cast<std::uint64_t>(code) & (more.empty() ? 0xffff : 0x1ffffff));
    }
    text += '\n';
  }
  return text;
}

TEST_CASE("check judges what hardware answered to vectors", "[cli]") {
  const scratch folder;
  const std::string right = answered(folder);
  const std::string answers = folder.write("answers.txt", right);
  const std::string check = "check --format q8 --answers " + quoted(answers);
  const auto count = std::count(right.begin(), right.end(), '\n') - 1;
  const outcome equal = run_blysk(folder, check);
  CHECK(equal.status == 0);
  CHECK(equal.out == fmt::format("{} vectors of {} q8: equal\n", count, kDevice));
  // The lines alone, and in capitals.
  std::string plain = right.substr(right.find('\n') + 1);
  std::ranges::transform(plain, plain.begin(), [](unsigned char c) { return std::toupper(c); });
  folder.write("answers.txt", plain);
  CHECK(run_blysk(folder, check).out == equal.out);

  folder.write("answers.txt", "\n1f4 0ff 00 80 ff 0000 6f31 de84\n");
  const outcome different = run_blysk(folder, check);
  CAPTURE(different.out);
  CHECK(different.status == 1);
  CHECK(different.err.empty());
  const auto json = nlohmann::json::parse(run_blysk(folder, check + " --json").out);
  CHECK(json["vectors"] == 1);
  CHECK(json["different"] == 1);
  CHECK(json["differences"][0]["line"] == 2);
  CHECK(json["differences"][0]["inputs"]["cos"] == "ff (0.996094)");
  // n = 500, cos = 255/256: a = 100372/256, the parabola -100372 255 / 2^24 + 255/256 = -0.53, so all are 0.
  CHECK(different.out.find(
            "answers.txt:2: n 1f4 (500), cos ff (0.996094), r 0 (0), g 80 (128), b ff (255): green is "
            "6f31 (111.191), expected 0 (0), 28465 ulp more\n") != std::string::npos);
  CHECK(different.out.ends_with("1 vectors of " + kDevice + " q8: 1 differ, by up to 56964 ulp\n"));
}

TEST_CASE("answers that end within their last word are refused", "[cli]") {
  const scratch folder;
  const std::string row = "1f4 0ff 00 80 ff 0000 0000 ";
  const auto checked = [&](const std::string& end) {
    return run_blysk(folder, "check --format q8 --answers " + quoted(folder.write("answers.txt", row + end)));
  };
  for (const char* whole : {"0000", "0000\n", "0\n", "0\r\n", "00000"}) CHECK(checked(whole).status == 0);
  for (const char* cut : {"000", "00", "0", "0\r"}) {
    const outcome failed = checked(cut);
    CAPTURE(cut, failed.err);
    CHECK(failed.status == 2);
    CHECK(failed.out.empty());
    CHECK(failed.err.ends_with("answers.txt:1: ends within blue, expected its 4 digits or a line feed\n"));
  }
}

TEST_CASE("a vector of several lines differs once", "[cli]") {
  const scratch folder;
  int devices = 0;
  const auto listed = nlohmann::json::parse(run_blysk(folder, "list --json").out);
  for (const auto& device : listed["devices"]) {
    // Those that draw a line of colours.
    if (device["results"] != nlohmann::json{"line", "pixel", "red", "green", "blue"}) continue;
    const std::string name = device["name"];
    const std::string vectors = run_blysk(folder, "vectors --format q8 --device " + name).out;
    const auto lines = std::count(vectors.begin(), vectors.end(), '\n');
    // A vector of more than one line, each with the same answer; what it should be does not matter here.
    std::istringstream text(vectors);
    std::string line;
    for (int i = 0; i < 20 && i < lines; ++i) std::getline(text, line);
    std::string answers;
    line += " 1 1 1";
    outcome checked;
    int repeated = 0;
    do {
      answers += line + "\n";
      ++repeated;
      checked = run_blysk(folder, "check --json --format q8 --device " + name + " --answers " +
                                      quoted(folder.write("answers.txt", answers)));
    } while (checked.status == 2 && checked.err.find("pixels more") != std::string::npos && repeated < 3000);
    CAPTURE(name, repeated, checked.err);
    REQUIRE(checked.status == 1);
    ++devices;
    const auto json = nlohmann::json::parse(checked.out);
    CHECK(json["vectors"] == 1);
    CHECK(json["different"] == 1);
  }
  CHECK(devices > 0);
}

TEST_CASE("answers of a device with signed results are two's complement", "[cli]") {
  const scratch folder;
  const std::string answers = folder.write("answers.txt", answered(folder, " --as-published"));
  const std::string text = slurp(answers);
  CHECK(text.find("--as-published; ") != std::string::npos);
  CHECK(run_blysk(folder, "check --format q8 --as-published --answers " + quoted(answers)).status == 0);
  CHECK(run_blysk(folder, "check --format q8 --answers " + quoted(answers)).status == 2);
}

TEST_CASE("vectors repeat, and depend on their seed", "[cli]") {
  const scratch folder;
  const std::string first = run_blysk(folder, "vectors --format q8").out;
  CHECK(run_blysk(folder, "vectors --format q8").out == first);
  CHECK(run_blysk(folder, "vectors --format q8 --seed 2").out != first);
  const std::string all = run_blysk(folder, "vectors --format q8 --level 2").out;
  CHECK(all.starts_with("# blysk vectors --device " + kDevice +
                        " --format q8; 257000 vectors of n cos r g b\n"));
  CHECK(std::count(all.begin(), all.end(), '\n') == 257'001);
  CHECK_THAT(run_blysk(folder, "vectors --format q8 --level 2 --seed 2").err,
             ContainsSubstring("--seed is of random writes and level 2 has none up to q12"));
  for (const std::string arguments :
       {"vectors --level 2 --format q12 --seed 2", "vectors --level 3", "vectors --format q9",
        "vectors --seed x", "vectors --seed -1", "vectors --seed ''", "vectors --seed ' 1'",
        "vectors --seed 0x10", "vectors --seed 18446744073709551616", "settle --seed -1", "settle --pairs -1",
        "check --differences -1"}) {
    const outcome failed = run_blysk(folder, arguments);
    CAPTURE(arguments, failed.err);
    CHECK(failed.status == 2);
    CHECK(std::count(failed.err.begin(), failed.err.end(), '\n') == 1);
  }
}

TEST_CASE("answers that cannot be read are refused, and are no difference", "[cli]") {
  const scratch folder;
  const std::string header =
      "# blysk vectors --device " + kDevice + " --format q8; 2 vectors of n cos r g b\n";
  const std::string good = "001 100 ff ff ff ff00 ff00 ff00\n";
  const auto [text, message] = GENERATE_COPY(table<std::string, std::string>(
      {{"# blysk vectors --device " + kDevice + " --format q12; 1 vectors of n cos r g b\n" + good,
        ":1: has vectors of --device " + kDevice + " --format q12, expected those of --device " + kDevice +
            " --format q8"},
       {header + good, ":2: is the end after 1 vectors, expected 2 as the header says"},
       {header + good + good + good, ":4: is the end after 3 vectors, expected 2 as the header says"},
       {"# blysk vectors --device " + kDevice +
            " --format q8; 99999999999999999999 vectors of n cos r g b\n" + good,
        ":1: is no header, expected what blysk vectors wrote in its first line"},
       {header.substr(0, 40) + "\n" + good,
        ":1: is no header, expected what blysk vectors wrote in its first line"},
       {"# blysk vectors --device " + kDevice + " --format q8; 1 vectors of cos n r g b\n" + good,
        ":1: has vectors of cos n r g b, expected n cos r g b"},
       {"", ": has no vectors, expected lines of n cos r g b red green blue"},
       {good + "001 100 ff ff ff ff00 ff00\n", ":2: ends before blue, expected n cos r g b red green blue"},
       {good + "001 100 f", ":2: ends before g, expected n cos r g b red green blue"},
       {"001 100 ff ff ff ff00 ff00 xx00\n",
        ":1: blue is 'xx00', unknown, expected hexadecimal digits of 16 bits"},
       {"001 100 ff ff ff ff00 Z ff00\n",
        ":1: green is 'Z', unknown, expected hexadecimal digits of 16 bits"},
       {"0x001 100 ff ff ff 0 0 0\n", ":1: n is '0x001', expected hexadecimal digits of 10 bits"},
       {"001 100 ff ff ff 1ff00 ff00 ff00\n", ":1: red is '1ff00', expected hexadecimal digits of 16 bits"},
       {"001 100 ff ff ff -1 ff00 ff00\n", ":1: red is '-1', expected hexadecimal digits of 16 bits"},
       {"000 100 ff ff ff 0 0 0\n", ":1: n is 000, expected 001 to 3e8"},
       {"001 101 ff ff ff 0 0 0\n", ":1: cos is 101, expected 000 to 100"},
       {"001 100 ff ff ff 0 0 0 0\n", ":1: has '0' at its end, expected n cos r g b red green blue"}}));
  CAPTURE(text);
  const std::string answers = folder.write("answers.txt", text);
  const outcome failed = run_blysk(folder, "check --format q8 --answers " + quoted(answers));
  CHECK(failed.status == 2);
  CHECK(failed.err == "blysk: " + answers + message + "\n");
}

}  // namespace
