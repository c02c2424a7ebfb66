// SPDX-License-Identifier: Apache-2.0
// The stimuli of `blysk simulate`: what is read of a table, and what is refused with its line.
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tb/catch.h"
#include "tb/cli/test/simulate.h"

namespace {

TEST_CASE("simulate tolerates CRLF, a byte order mark, blanks and empty lines", "[cli]") {
  const scratch folder;
  const std::string plain = folder.write("plain.csv", kGood);
  const std::string odd = folder.write("odd.csv",
                                       "\xEF\xBB\xBFn, cos,r,g,b\r\n1,0,255,0,1\r\n\r\n 10 "
                                       ",\t0.99,200,100,50\r\n1000,1,255,255,255\r\n50,0.5,3,2,1");
  REQUIRE(run_blysk(folder, simulate(plain, folder.path("a.csv"))).status == 0);
  REQUIRE(run_blysk(folder, simulate(odd, folder.path("b.csv"))).status == 0);
  CHECK(slurp(folder.path("a.csv")) == slurp(folder.path("b.csv")));
}

TEST_CASE("a table as other programs write it is read", "[cli]") {
  const scratch folder;
  const std::string plain = folder.write("plain.csv", "n,cos,r,g,b\n10,0.99,200,100,50\n1000,1,255,0,1\n");
  REQUIRE(run_blysk(folder, simulate(plain, folder.path("plain-results.csv"))).status == 0);
  const std::string expected = slurp(folder.path("plain-results.csv"));
  const auto [name, text] = GENERATE_COPY(table<std::string, std::string>(
      {{"numpy.savetxt",
        "# n,cos,r,g,b\n1.000e+01,9.900e-01,2.000e+02,1.000e+02,5.000e+01\n"
        "1.000e+03,1.000e+00,2.550e+02,0.000e+00,1.000e+00\n"},
       {"numpy.savetxt, its delimiter",
        "# n cos r g b\n1.0e+01 9.9e-01 2.0e+02 1.0e+02 5.0e+01\n1e3 1e0 2.55e2 0 1\n"},
       {"pandas, with its index", ",n,cos,r,g,b\n0,10,0.99,200,100,50\n1,1000,1.0,255,0,1\n"},
       {"R", "\"\",\"n\",\"cos\",\"r\",\"g\",\"b\"\n\"1\",10,0.99,200,100,50\n\"2\",1000,1,255,0,1\n"},
       {"all fields quoted",
        "n,cos,r,g,b\n\"10\",\"0.99\",\"200\",\"100\",\"50\"\n\"1000\", \"1\" ,255,0,1\n"},
       {"a spreadsheet's export",
        "\xEF\xBB\xBFn;cos;r;g;b;\r\n10;0.99;200;100;50;\r\n1000;1;255;0;1;\r\n;;;;;\r\n"},
       {"a note of the separator", "sep=;\r\nn;cos;r;g;b\r\n10;0.99;200;100;50\r\n1000;1;255;0;1\r\n"},
       {"such a note of tabs, quoted",
        "\xEF\xBB\xBF\"sep=\t\"\nn\tcos\tr\tg\tb\n10\t0.99\t200\t100\t50\n1000\t1\t255\t0\t1\n"},
       {"tabs", "n\tcos\tr\tg\tb\n10\t0.99\t200\t100\t50\n1000\t1\t255\t0\t1\n"},
       {"floats for integers", "n,cos,r,g,b\n10.0,0.99,200.0,1e2,50.00\n1000.,1.0,255.0,0.0,1.0\n"},
       {"signs", "n,cos,r,g,b\n+10,+.99,+200,+100,+5e1\n+1e3,+1,+255,-0,1\n"},
       {"comments", "# made today\n#\nn,cos,r,g,b\n10,0.99,200,100,50\n# half\n1000,1,255,0,1\n#"},
       {"a header twice, behind # and plain",
        "# columns: n cos r g b\n# n,cos,r,g,b\nn,cos,r,g,b\n10,0.99,200,100,50\n1000,1,255,0,1\n"},
       {"a comma at the end of lines", "n,cos,r,g,b,\n10,0.99,200,100,50,\n1000,1,255,0,1,,\n"},
       {"columns in another order, and others",
        "b,g,why,r,cos,n\n50,100,\"a, b\",200,0.99,10\n1,0,,255,1,1000\n"},
       {"own results", expected}}));
  CAPTURE(name, text);
  const std::string in = folder.write("in.csv", text);
  const outcome done = run_blysk(folder, simulate(in, folder.path("out.csv")));
  CAPTURE(done.err);
  REQUIRE(done.status == 0);
  CHECK(slurp(folder.path("out.csv")) == expected);
}

TEST_CASE("a table whose meaning is not clear is refused", "[cli]") {
  const scratch folder;
  const auto [text, message] = GENERATE(table<std::string, std::string>(
      {{"n,cos,r,g,b,n\n", ":1: header is 'n,cos,r,g,b,n' with column n twice, expected n,cos,r,g,b"},
       {"# n,cos,r,g\n1,0,1,1\n", ":2: header is '1,0,1,1', expected n,cos,r,g,b"},
       {"# nothing\n", ":1: is no header, expected n,cos,r,g,b"},
       {"n,cos,r,g,b\n10.5,0.5,1,2,3\n", ":2: n is '10.5', expected an integer 1..1000"},
       {"n,cos,r,g,b\n1e400,0.5,1,2,3\n", ":2: n is '1e400', expected an integer 1..1000"},
       {"n,cos,r,g,b\n+-10,0.5,1,2,3\n", ":2: n is '+-10', expected an integer 1..1000"},
       {"n;cos;r;g;b\n10;0,5;1;2;3\n", ":2: cos is '0,5', expected a real number in [0, 1]"},
       {"n,cos,r,g,b\n\"10,0.5,1,2,3\n", ":2: row '\"10,0.5,1,2,3' has a quote out of place"},
       {"n,cos,r,g,b\n\"10\"x,0.5,1,2,3\n", ":2: row '\"10\"x,0.5,1,2,3' has a quote out of place"},
       {"n,cos,r,g,b\n\"1\"\"\",0.5,1,2,3\n", ":2: n is '1\"', expected an integer 1..1000"},
       {"n,cos,r,g,b,\n10,0.5,1,2,3,4\n", ":2: row has 6 fields, expected 5: n,cos,r,g,b"},
       {"n,cos,r,g,b\nsep=,\n", ":2: row has 2 fields, expected 5"},
       {"n;cos;r;g;b;n\n", ":1: header is 'n;cos;r;g;b;n' with column n twice"},
       {"\xFF\xFEn", ":1: is UTF-16, expected text in UTF-8"},
       {"\xFE\xFFn", ":1: is UTF-16, expected text in UTF-8"},
       {"x,n,cos,r,g,b\n10,0.5,1,2,3\n", ":2: row has 5 fields, expected 6: x,n,cos,r,g,b"},
       {"n,cos,r,g,b\n10,0.5,1,2,3 # why\n", ":2: b is '3 # why', expected an integer 0..255"}}));
  CAPTURE(text);
  const std::string in = folder.write("in.csv", text);
  const outcome failed = run_blysk(folder, simulate(in, folder.path("out.csv")));
  CHECK(failed.status == 2);
  CAPTURE(failed.err);
  CHECK(failed.err.starts_with("blysk: " + in + message));
  CHECK(std::count(failed.err.begin(), failed.err.end(), '\n') == 1);
  CHECK(folder.names() == std::vector<std::string>{"in.csv"});
}

TEST_CASE("with --clamp is taken what rounding leaves outside [0, 1], and counts it", "[cli]") {
  const scratch folder;
  const std::string out = folder.path("out.csv");
  const std::string in =
      folder.write("in.csv",
                   "n,cos,r,g,b\n10,1.0000000000000002,1,2,3\n10,1.00000011920928955078125,1,2,3\n"
                   "10,-1.1920928955078125e-7,1,2,3\n10,-1e-400,1,2,3\n10,1,1,2,3\n10,0.5,1,2,3\n");
  const outcome done = run_blysk(folder, simulate(in, out, "--clamp --json"));
  REQUIRE(done.status == 0);
  CHECK(nlohmann::json::parse(done.out)["clamped"] == 3);  // -1e-400 is 0
  CHECK(slurp(out).find("10,1,1,2,3,1,1,2,3\n10,1,1,2,3,1,1,2,3\n10,0,1,2,3,0,0,0,0\n10,0,1,2,3,0,0,0,0\n") !=
        std::string::npos);
  CHECK(run_blysk(folder, simulate(in, out, "--clamp")).out.find(", 3 clamped") != std::string::npos);
  const outcome refused = run_blysk(folder, simulate(in, out));
  CHECK(refused.status == 2);
  CHECK(refused.err ==
        "blysk: " + in +
            ":2: cos is '1.0000000000000002', expected a real number in [0, 1], or --clamp, which "
            "takes the nearest\n");
  for (const std::string cosine : {"1.0000001192092898", "-1.1920928955078127e-7", "1.5", "nan", "inf"}) {
    CAPTURE(cosine);
    folder.write("in.csv", "n,cos,r,g,b\n10," + cosine + ",1,2,3\n");
    const outcome failed = run_blysk(folder, simulate(in, out, "--clamp"));
    CHECK(failed.status == 2);
    CHECK(failed.err == "blysk: " + in + ":2: cos is '" + cosine + "', expected a real number in [0, 1]\n");
  }
  const std::string points = folder.write("points.csv", "# n cos\n2 1.0000001\n2.0 0.5\n");
  const outcome model = run_blysk(folder, "model blinn --clamp --points " + quoted(points) + " --results -");
  CHECK(model.out == "n,cos,value\n2,1.0000001,1\n2.0,0.5,0.25\n");
  CHECK(model.err == "1 clamped\n");
  CHECK(run_blysk(folder, "model blinn --points " + quoted(points) + " --results -").status == 2);
}

TEST_CASE("zeros in front of a number do not make it octal", "[cli]") {
  const scratch folder;
  const std::string ten = run_blysk(folder, "vectors --format q8 --seed 10").out;
  CHECK(run_blysk(folder, "vectors --format q8 --seed 010").out == ten);
  CHECK(run_blysk(folder, "vectors --format q8 --seed 8").out != ten);
}

TEST_CASE("a value that is not finite is refused", "[cli]") {
  const scratch folder;
  const std::string points = folder.write(
      "in.csv", "ia,il,ka,kd,nx,ny,nz,lx,ly,lz\n1,1,1,1,0,0,1,0,0,1\n1e308,0,90,0,0,0,1,0,0,1\n");
  const outcome failed = run_blysk(
      folder, "model lambert --points " + quoted(points) + " --results " + quoted(folder.path("out.csv")));
  CHECK(failed.status == 2);
  CHECK(failed.err == "blysk: " + points + ":3: value is inf, expected columns that give a finite one\n");
  CHECK(folder.names() == std::vector<std::string>{"in.csv"});
}

struct wrong_input {
  const char* name;
  const char* text;
  int line;
  const char* message;
};

TEST_CASE("simulate says what is wrong with a stimulus, where, and leaves no output", "[cli]") {
  const std::vector<wrong_input> inputs{
      {"missing column", "n,cos,r,g\n1,0,1,1\n", 1, "header is 'n,cos,r,g', expected n,cos,r,g,b"},
      {"no header", "1,0,1,1,1\n", 1, "header is '1,0,1,1,1', expected n,cos,r,g,b"},
      {"n = 0", "n,cos,r,g,b\n0,0,1,1,1\n", 2, "n is '0', expected an integer 1..1000"},
      {"n = 1001", "n,cos,r,g,b\n1,0,1,1,1\n1001,0,1,1,1\n", 3, "n is '1001', expected an integer 1..1000"},
      {"n = 1.5", "n,cos,r,g,b\n1.5,0,1,1,1\n", 2, "n is '1.5', expected an integer 1..1000"},
      {"n huge", "n,cos,r,g,b\n99999999999999999999,0,1,1,1\n", 2, "n is '99999999999999999999', expected"},
      {"cos NaN", "n,cos,r,g,b\n1,nan,1,1,1\n", 2, "cos is 'nan', expected a real number in [0, 1]"},
      {"cos 1.01", "n,cos,r,g,b\n1,1.01,1,1,1\n", 2, "cos is '1.01', expected a real number in [0, 1]"},
      {"cos -0.1", "n,cos,r,g,b\n1,-0.1,1,1,1\n", 2, "cos is '-0.1', expected a real number in [0, 1]"},
      {"cos inf", "n,cos,r,g,b\n1,inf,1,1,1\n", 2, "cos is 'inf', expected a real number in [0, 1]"},
      {"letters", "n,cos,r,g,b\n1,0,red,1,1\n", 2, "r is 'red', expected an integer 0..255"},
      {"letters after digits", "n,cos,r,g,b\n1,0.5x,1,1,1\n", 2, "cos is '0.5x', expected"},
      {"colour 256", "n,cos,r,g,b\n1,0,1,256,1\n", 2, "g is '256', expected an integer 0..255"},
      {"colour -1", "n,cos,r,g,b\n1,0,1,1,-1\n", 2, "b is '-1', expected an integer 0..255"},
      {"truncated line", "n,cos,r,g,b\n1,0,1,1,1\n5,0.5,2", 3, "row has 3 fields, expected 5: n,cos,r,g,b"},
      {"too many fields", "n,cos,r,g,b\n1,0,1,1,1,9\n", 2, "row has 6 fields, expected 5"},
      {"empty field", "n,cos,r,g,b\n1,,1,1,1\n", 2, "cos is '', expected"},
      {"empty file", "", 1, "is empty, expected the header n,cos,r,g,b"},
  };
  for (const auto& wrong : inputs) {
    for (const char* engine : {"golden", "bit", "systemc"}) {
      const scratch folder;
      const std::string in = folder.write("in.csv", wrong.text);
      const outcome failed =
          run_blysk(folder, simulate(in, folder.path("out.csv"), std::string("--engine ") + engine));
      CAPTURE(wrong.name, engine, failed.err);
      CHECK(failed.status == 2);
      CHECK(failed.err.starts_with("blysk: " + in + ":" + std::to_string(wrong.line) + ": " + wrong.message));
      CHECK(std::count(failed.err.begin(), failed.err.end(), '\n') == 1);
      CHECK(failed.out.empty());
      CHECK(folder.names() == std::vector<std::string>{"in.csv"});
    }
  }
}

}  // namespace
