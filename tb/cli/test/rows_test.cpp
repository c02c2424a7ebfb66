// SPDX-License-Identifier: Apache-2.0
// The rows of `simulate`: what the quick ways read and write is what the library of C++ reads.
#include "tb/cli/rows.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tb/catch.h"
#include "tb/cli/stream.h"
#include "tb/cli/test/program.h"
#include "tb/device.h"

namespace {

using namespace blysk;
using namespace blysk::cli;

/// The ports of the first device, whose columns are n,cos,r,g,b and brdf,red,green,blue.
std::vector<port> ports_of(const std::string& format, bool as_published = false) {
  const selection asked = choose(devices().front()->name(), format,
                                 as_published ? std::map<std::string, std::string>{{"as-published", "on"}}
                                              : std::map<std::string, std::string>{});
  return asked.of().ports(asked);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    lines.push_back(text.substr(begin, end - begin));
  return lines;
}

TEST_CASE("rows are read as the C library reads their numbers", "[cli]") {
  const scratch folder;
  std::mt19937 random(1);
  // 0 to 20 digits: those that are read at once, and those that are not.
  const auto cosine = [&]() -> std::string {
    const double value = static_cast<double>(random()) * 0x1p-32;
    switch (random() % 8) {
      case 0:
        return fmt::format("{}", random() % 2);
      case 1:
        return fmt::format("{:e}", value);
      case 2:
        return fmt::format("1.{}", std::string(random() % 9, '0'));
      default:
        return fmt::format("{:.{}f}", value, random() % 21);
    }
  };
  struct row {
    std::uint64_t n, red, green, blue;
    std::string cosine;
  };
  std::vector<row> expected;
  std::string text = "n,cos,r,g,b\n";
  for (int i = 0; i < 50'000; ++i) {  // several buffers: rows lie across their ends
    const row made{1 + random() % 1000, random() % 256, random() % 256, random() % 256, cosine()};
    expected.push_back(made);
    const char* const form = i % 5 == 0   ? " {},{} , {},\t{},{}\r\n"
                             : i % 5 == 1 ? "00{},{},0{},{},{}\n"
                                          : "{},{},{},{},{}\n";
    text += fmt::format(fmt::runtime(form), made.n, made.cosine, made.red, made.green, made.blue);
  }
  text.pop_back();  // no end of line at the end
  const std::vector<port> ports = ports_of("q24");
  csv_reader rows(folder.write("in.csv", text), stimulus_header(ports));
  stimulus_reader reader(rows, ports);
  constexpr int fraction = 24;
  columns block;
  std::size_t i = 0;
  for (reader.read(block); block.size() != 0; reader.read(block)) {
    for (std::size_t k = 0; k < block.size(); ++k, ++i) {
      const row& made = expected.at(i);
      const double scaled = std::ldexp(std::strtod(made.cosine.c_str(), nullptr), fraction);
      CAPTURE(i, made.cosine);
      const auto expected_code =
          static_cast<std::int64_t>(std::floor(scaled)) + (scaled - std::floor(scaled) >= 0.5);
      REQUIRE(block[0].get(k) == static_cast<std::int64_t>(made.n));
      REQUIRE(block[1].get(k) == expected_code);
      REQUIRE(block[2].get(k) == static_cast<std::int64_t>(made.red));
      REQUIRE(block[3].get(k) == static_cast<std::int64_t>(made.green));
      REQUIRE(block[4].get(k) == static_cast<std::int64_t>(made.blue));
    }
  }
  CHECK(i == expected.size());
}

TEST_CASE("rows that look plain and are wrong are refused", "[cli]") {
  const scratch folder;
  const auto [row, message] = GENERATE(table<std::string, std::string>({
      {"0,0.5,1,2,3", "n is '0', expected an integer 1..1000"},
      {"1001,0.5,1,2,3", "n is '1001', expected an integer 1..1000"},
      {"99999999,0.5,1,2,3", "n is '99999999', expected an integer 1..1000"},
      {",0.5,1,2,3", "n is '', expected an integer 1..1000"},
      {"1:,0.5,1,2,3", "n is '1:', expected an integer 1..1000"},
      {"1/,0.5,1,2,3", "n is '1/', expected an integer 1..1000"},
      {"\xB1,0.5,1,2,3", "n is '\\xB1', expected an integer 1..1000"},
      {"1,1.0000001,1,2,3",
       "cos is '1.0000001', expected a real number in [0, 1], or --clamp, which takes the nearest"},
      {"1,1.000001,1,2,3", "cos is '1.000001', expected a real number in [0, 1]"},
      {"1,2.0,1,2,3", "cos is '2.0', expected a real number in [0, 1]"},
      {"1,0.5x,1,2,3", "cos is '0.5x', expected a real number in [0, 1]"},
      {"1,0.,5,1,2,3", "row has 6 fields, expected 5: n,cos,r,g,b"},
      {"1,0.5,256,2,3", "r is '256', expected an integer 0..255"},
      {"1,0.5,1,256,3", "g is '256', expected an integer 0..255"},
      {"1,0.5,1,2,256", "b is '256', expected an integer 0..255"},
      {"1,0.5,1,2,3x", "b is '3x', expected an integer 0..255"},
      {"1,0.5,1,2,3\rx", "b is '3\\x0Dx', expected an integer 0..255"},
      {"1,0.5,1,2,", "b is '', expected an integer 0..255"},
      {"1,0.5,1,2", "row has 4 fields, expected 5: n,cos,r,g,b"},
      {"1,0.5,1,2,3,4", "row has 6 fields, expected 5: n,cos,r,g,b"},
  }));
  for (const std::string end : {"", "\n", "\r\n", "\n9,0.9,9,9,9\n"}) {
    CAPTURE(row, end);
    csv_reader reader(folder.write("in.csv", fmt::format("n,cos,r,g,b\n7,0.7,7,7,7\n{}{}", row, end)),
                      "n,cos,r,g,b");
    columns block;
    CHECK_THROWS_WITH(stimulus_reader(reader, ports_of("q8")).read(block),
                      folder.path("in.csv") + ":3: " + message);
  }
}

/// raw 2^-fraction without trailing zeros; at most 17 integer and 24 fraction bits, which a double holds.
std::string decimal(std::int64_t raw, int fraction) {
  std::string text = fmt::format("{:.24f}", std::ldexp(static_cast<double>(raw), -fraction));
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

TEST_CASE("results are written with all their digits", "[cli]") {
  const int fraction = GENERATE(8, 10, 16, 20, 22, 24);
  const std::vector<port> ports = ports_of(fmt::format("q{}", fraction), true);  // signed results
  std::mt19937_64 random(2);
  row_block block{columns(ports, port::role::data), columns(ports, port::role::result), {}};
  const std::size_t size = 70'000;
  block.writes.resize(size);
  block.computed.resize(size);
  const std::int64_t one = std::int64_t{1} << fraction;
  std::vector<std::array<std::int64_t, 9>> expected(size);
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint64_t bits = random();
    auto& [n, c, r, g, b, brdf, red, green, blue] = expected[i];
    n = static_cast<std::int64_t>(1 + i % 1000);
    c = static_cast<std::int64_t>(i) % (one + 1);  // q16: all
    r = static_cast<std::int64_t>(i % 256);
    g = static_cast<std::int64_t>(bits % 256);
    b = static_cast<std::int64_t>((bits >> 8) % 256);
    brdf = static_cast<std::int64_t>(bits % static_cast<std::uint64_t>(2 * one)) - one;
    red = static_cast<std::int64_t>(bits % static_cast<std::uint64_t>(65536 * one)) * (i % 2 == 0 ? 1 : -1);
    green = brdf * g;
    blue = red >> fraction << fraction;  // whole numbers
    for (std::size_t k = 0; k < 5; ++k) block.writes[k].set(i, expected[i].at(k));
    for (std::size_t k = 0; k < 4; ++k) block.computed[k].set(i, expected[i].at(5 + k));
  }
  fmt::memory_buffer text;
  append_rows(text, ports, block);
  const auto lines = lines_of({text.data(), text.size()});
  REQUIRE(lines.size() == size);
  for (std::size_t i = 0; i < size; ++i) {
    const auto& [n, c, r, g, b, brdf, red, green, blue] = expected[i];
    REQUIRE(lines[i] == fmt::format("{},{},{},{},{},{},{},{},{}", n, decimal(c, fraction), r, g, b,
                                    decimal(brdf, fraction), decimal(red, fraction), decimal(green, fraction),
                                    decimal(blue, fraction)));
  }
}

TEST_CASE("a cosine is rounded to its nearest code, ties up", "[cli]") {
  const scratch folder;
  const std::vector<port> ports = ports_of("q8");
  const auto [text, code] =
      GENERATE(table<std::string, int>({{"0.0019531249999999998", 0},  // a double below half a code
                                        {"0.001953125", 1},
                                        {"0.0058593749999999991", 1},
                                        {"0.005859375", 2},
                                        {"1e-400", 0},
                                        {"0.99804687499999989", 255},
                                        {"0.998046875", 256},
                                        {"1", 256}}));
  CAPTURE(text);
  csv_reader reader(folder.write("in.csv", "n,cos,r,g,b\n1," + text + ",1,2,3\n"), stimulus_header(ports));
  columns block;
  stimulus_reader(reader, ports).read(block);
  REQUIRE(block.size() == 1);
  CHECK(block[1].get(0) == code);
}

TEST_CASE("a cosine that is too large for a double is outside its range", "[cli]") {
  const scratch folder;
  const std::vector<port> ports = ports_of("q8");
  csv_reader reader(folder.write("in.csv", "n,cos,r,g,b\n1,1e400,1,2,3\n"), stimulus_header(ports));
  columns block;
  CHECK_THROWS_WITH(stimulus_reader(reader, ports).read(block),
                    folder.path("in.csv") + ":2: cos is '1e400', expected a real number in [0, 1]");
}

constexpr int kRows = 3 * static_cast<int>(kRowsPerBlock) + 1;
std::string stimulus() {
  std::string text = "n,cos,r,g,b\n";
  for (int i = 0; i < kRows; ++i) text += fmt::format("{},0.5,{},2,3\n", 1 + i % 1000, i / 1000);
  return text;
}

TEST_CASE("rows stream through in their order", "[cli]") {
  const scratch folder;
  const std::vector<port> ports = ports_of("q8");
  csv_reader rows(folder.write("in.csv", stimulus()), stimulus_header(ports));
  stimulus_reader reader(rows, ports);
  output_file file(folder.path("out.csv"));
  const auto count = stream(
      reader,
      [](row_block& block) {
        block.computed = columns(std::vector<storage>(4, storage::f64));
        block.computed.resize(block.writes.size());
        for (std::size_t i = 0; i < block.writes.size(); ++i) {
          const double n = block.writes[0].real(i);
          block.computed[0].set(i, n);
          for (std::size_t k = 1; k < 4; ++k) block.computed[k].set(i, n * block.writes[1 + k].real(i));
        }
      },
      file);
  file.commit();
  CHECK(count == kRows);
  const auto lines = lines_of(slurp(folder.path("out.csv")));
  REQUIRE(lines.size() == kRows + 1);
  CHECK(lines[0] == "n,cos,r,g,b,brdf,red,green,blue");
  for (int i = 0; i < kRows; ++i) {
    const int n = 1 + i % 1000;
    const int red = i / 1000;
    REQUIRE(lines[static_cast<std::size_t>(i) + 1] ==
            fmt::format("{},0.5,{},2,3,{},{},{},{}", n, red, n, n * red, n * 2, n * 3));
  }
}

TEST_CASE("what goes wrong in either thread ends the stream", "[cli]") {
  const scratch folder;
  const std::vector<port> ports = ports_of("q8");
  const auto nothing = [&](row_block& block) {
    block.computed = columns(ports, port::role::result);
    block.computed.resize(block.writes.size());
  };
  SECTION("in the stimulus") {
    csv_reader rows(folder.write("in.csv", stimulus() + "bad\n"), stimulus_header(ports));
    stimulus_reader reader(rows, ports);
    output_file file(folder.path("out.csv"));
    CHECK_THROWS_WITH(
        stream(reader, nothing, file),
        folder.path("in.csv") + fmt::format(":{}: row has 1 fields, expected 5: n,cos,r,g,b", kRows + 2));
  }
  SECTION("in the engine") {
    csv_reader rows(folder.write("in.csv", stimulus()), stimulus_header(ports));
    stimulus_reader reader(rows, ports);
    output_file file(folder.path("out.csv"));
    int blocks = 0;
    const auto fail_later = [&](row_block& block) {
      nothing(block);
      if (++blocks == 3) throw usage_error("no more");
    };
    CHECK_THROWS_WITH(stream(reader, fail_later, file), "no more");
  }
  SECTION("in the results, long before the stimulus ends") {
    std::string many = stimulus();
    for (int i = 0; i < 4; ++i) many += many.substr(many.find('\n') + 1);
    csv_reader rows(folder.write("in.csv", many), stimulus_header(ports));
    stimulus_reader reader(rows, ports);
    output_file file("/dev/full");
    CHECK_THROWS_WITH(stream(reader, nothing, file),
                      "/dev/full:1: cannot be written (No space left on device)");
    CHECK(rows.next());
  }
}

}  // namespace
