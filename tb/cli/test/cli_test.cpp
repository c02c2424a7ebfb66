// SPDX-License-Identifier: Apache-2.0
// The program as its users start it: results, and one clear line for everything that is wrong with an input.
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tb/catch.h"
#include "tb/cli/test/program.h"

namespace {

std::string simulate(const std::string& in, const std::string& out, const std::string& more = "") {
  return "simulate --stimulus " + quoted(in) + " --results " + quoted(out) + " " + more;
}

const std::string kGood = "n,cos,r,g,b\n1,0,255,0,1\n10,0.99,200,100,50\n1000,1,255,255,255\n50,0.5,3,2,1\n";

TEST_CASE("simulate gives the same rows through bit and systemc", "[cli]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kGood);
  for (const std::string more : {"--format q12", "--format q8 --as-published --coefficient published",
                                 "--format q24 --coefficient published --constant 110011"}) {
    CAPTURE(more);
    REQUIRE(run_blysk(folder, simulate(in, folder.path("bit.csv"), more + " --engine bit")).status == 0);
    REQUIRE(run_blysk(folder, simulate(in, folder.path("systemc.csv"), more + " --engine systemc")).status ==
            0);
    const std::string rows = slurp(folder.path("bit.csv"));
    CHECK(rows == slurp(folder.path("systemc.csv")));
    CHECK(rows.starts_with("n,cos,r,g,b,brdf,red,green,blue\n1,0,255,0,1,0,0,0,0\n"));
    CHECK(rows.find("\n1000,1,255,255,255,1,255,255,255\n") != std::string::npos);
  }
}

TEST_CASE("the summary of simulate names the options that are no presets", "[cli]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kGood);
  const auto summary = [&](const std::string& more) {
    return run_blysk(folder, simulate(in, folder.path("out.csv"), more)).out;
  };
  CHECK(summary("--format q12").starts_with("4 rows through " + kDevice + " q12, engine bit: "));
  const std::string other = summary("--format q12 --coefficient published");
  CHECK(other.starts_with("4 rows through " + kDevice + " q12, coefficient published"));
  CHECK(other.find(", engine bit: ") != std::string::npos);
}

TEST_CASE("simulate gives the same rows through the exported Verilog", "[cli]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kGood);
  for (const std::string format : {"q8", "q16", "q24"}) {
    CAPTURE(format);
    const std::string more = " --format " + format;
    REQUIRE(run_blysk(folder, simulate(in, folder.path("bit.csv"), "--engine bit" + more)).status == 0);
    REQUIRE(run_blysk(folder, simulate(in, folder.path("verilog.csv"), "--engine verilator" + more)).status ==
            0);
    CHECK(slurp(folder.path("bit.csv")) == slurp(folder.path("verilog.csv")));
  }
}

TEST_CASE("export writes the device's Verilog", "[cli]") {
  const scratch folder;
  const std::string rtl = folder.path("rtl");
  REQUIRE(run_blysk(folder, "export --device " + kDevice + " --format q12 --output " + quoted(rtl)).status ==
          0);
  CHECK(slurp(rtl + "/" + top_of("q12") + ".v").find("module " + top_of("q12") + " (") != std::string::npos);
  CHECK(fs::exists(rtl + "/" + top_of("q12") + ".f"));
  fs::create_directory(folder.path("empty"));
  CHECK(run_blysk(folder, "export --output " + quoted(folder.path("empty/"))).status == 0);
  CHECK(run_blysk(folder, "export --output " + quoted(folder.path("two/levels/"))).status == 0);
}

TEST_CASE("an export by an alias bears the alias, and what is known of the device", "[cli]") {
  const scratch folder;
  const auto listed = nlohmann::json::parse(run_blysk(folder, "list --json").out);
  int found = 0;
  for (const auto& device : listed.at("devices")) {
    for (const auto& [alias, values] : device.at("aliases").items()) {
      CAPTURE(alias);
      ++found;
      const auto top_by = [&](const std::string& asked, std::string name) {
        std::ranges::replace(name, '-', '_');
        const std::string rtl = folder.path(name);
        REQUIRE(
            run_blysk(folder, "export --format q8 --device " + asked + " --output " + quoted(rtl)).status ==
            0);
        name = "blysk_" + name + "_q8";
        const std::string text = slurp(rtl + "/" + name + ".v");
        REQUIRE(text.find("module " + name + " (") != std::string::npos);
        return text.substr(0, text.find("module "));
      };
      std::string options;
      for (const auto& [name, value] : values.items())
        options += " --" + name + " " + value.get<std::string>();
      const std::string own = device.at("name");
      std::string head = top_by(alias, alias);
      CHECK(head.find("\n//   OSU018: ") != std::string::npos);
      std::string name = own;
      std::ranges::replace(name, '-', '_');
      const std::string note = ", with blysk_" + name + "_q8 in their names";
      REQUIRE(head.find(note) != std::string::npos);
      head.erase(head.find(note), note.size());
      CHECK(head == top_by(own + options, own));
      fs::remove_all(folder.path(name));
    }
  }
  CHECK(found > 0);
}

TEST_CASE("an export replaces one with the same options alone", "[cli]") {
  const scratch folder;
  const std::string to = " --format q8 --output " + quoted(folder.path("rtl"));
  REQUIRE(run_blysk(folder, "export --coefficient published" + to).status == 0);
  const std::string top = folder.path("rtl/" + top_of("q8") + ".v");
  const std::string before = slurp(top);
  CHECK(run_blysk(folder, "export --coefficient published" + to).status == 0);
  const outcome other = run_blysk(folder, "export" + to);
  CHECK(other.status == 2);
  CHECK(other.err.starts_with("blysk: " + folder.path("rtl") + ": holds device " + kDevice +
                              ", format q8, coefficient published"));
  CHECK(other.err.find("expected an empty directory or one with files of the export of device " + kDevice +
                       ", format q8, coefficient derived") != std::string::npos);
  CHECK(slurp(top) == before);
}

TEST_CASE("standard output by its other names is standard output", "[cli]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kGood);
  const std::string simulated = run_blysk(folder, simulate(in, "-")).out;
  fs::create_symlink("/dev/stdout", folder.path("link"));
  for (const std::string name : {"/dev/stdout", "/dev/fd/1", "/proc/self/fd/1", "/dev/../dev/stdout", ""}) {
    CAPTURE(name);
    const outcome run = run_blysk(folder, simulate(in, name.empty() ? folder.path("link") : name));
    CHECK(run.status == 0);
    CHECK(run.out == simulated);
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  }
  const std::string all = folder.write("all.csv", "before\n");
  REQUIRE(std::system((quoted(BLYSK_PROGRAM) + " " + simulate(in, "/dev/stdout") + " >>" + quoted(all) +
                       " 2>/dev/null")
                          .c_str()) == 0);
  CHECK(slurp(all) == "before\n" + simulated);
}

TEST_CASE("an export that cannot be written leaves everything as it was", "[cli]") {
  const scratch folder;
  const auto fails = [&](const std::string& arguments, const std::string& message,
                         const std::string& first = "") {
    const outcome failed = run_blysk(folder, "export " + arguments, first);
    CAPTURE(arguments, failed.err);
    CHECK(failed.status == 2);
    CHECK(failed.err.starts_with("blysk: "));
    CHECK(failed.err.find(message) != std::string::npos);
    CHECK(std::count(failed.err.begin(), failed.err.end(), '\n') == 1);
  };
  const auto to = [&](const std::string& name) { return " --output " + quoted(folder.path(name)); };
  folder.write("file", "");
  fails("--format q9" + to("no"), "q9");
  fails("--constant 0" + to("no"), "constant 0 cannot be wired");
  fails(to("file"), "file: cannot be made (Not a directory), expected a directory to write into");
  fails(to("file/below"), "below: cannot be made (Not a directory), expected a directory to write into");
  fails(to("new/rtl"), "cannot be written (File too large)", "trap '' XFSZ; ulimit -f 1; ");
  CHECK(folder.names() == std::vector<std::string>{"file"});

  // A former export of the same names is rewritten, and others stop it.
  REQUIRE(run_blysk(folder, "export --format q8" + to("rtl")).status == 0);
  const std::string top = folder.path("rtl/" + top_of("q8") + ".v");
  const std::string before = slurp(top);
  folder.write("rtl/" + top_of("q8") + ".v", "old");
  CHECK(run_blysk(folder, "export --format q8" + to("rtl")).status == 0);
  CHECK(slurp(top) == before);
  fails("--format q8 --as-published" + to("rtl"), ", expected an empty directory or one with files of the");
  fails("--format q10" + to("rtl"), ", expected an empty directory or one with files of the");
  folder.write("rtl/notes", "");
  fails("--format q8" + to("rtl"), "rtl: holds notes, expected an empty directory");
  fs::remove(folder.path("rtl/notes"));
  CHECK(slurp(top) == before);

  // A directory in a file's place; the file that is written last shows that none is replaced.
  fs::remove(top);
  fs::create_directory(top);
  const std::string list = folder.write("rtl/" + top_of("q8") + ".f", "old");
  fails("--format q8" + to("rtl"), ".v: is a directory, expected a file to write");
  CHECK(slurp(list) == "old");
  fs::remove(top);

  fs::create_symlink("/dev/full", top);
  const auto names = [&] { return std::distance(fs::directory_iterator(folder.path("rtl")), {}); };
  const auto count = names();
  fails("--format q8" + to("rtl"), "cannot be written (No space left on device)");
  CHECK(slurp(list) == "old");
  CHECK(names() == count);
  if (geteuid() != 0) {  // root may write everything
    fs::permissions(folder.path("rtl"), fs::perms::owner_read | fs::perms::owner_exec);
    fails("--format q8" + to("rtl"), "cannot be written (Permission denied)");
    fs::permissions(folder.path("rtl"), fs::perms::owner_all);
  }
}

TEST_CASE("simulate, golden, is the formula at the quantised cosine", "[cli]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", "n,cos,r,g,b\n10,0.9,200,100,50\n");
  REQUIRE(run_blysk(folder, simulate(in, folder.path("out.csv"),
                                     "--engine golden --format q8 --coefficient published"))
              .status == 0);
  // 0.9 * 256 = 230.4, so c = 230/256; a = 8.36. Four roundings of values below 8.36, 2^-53 relative each.
  double brdf = 0;
  REQUIRE(std::sscanf(slurp(folder.path("out.csv")).c_str(),
                      "n,cos,r,g,b,brdf,red,green,blue\n10,0.8984375,200,100,50,%lf", &brdf) == 1);
  const double c = 230.0 / 256;
  CHECK(std::abs(brdf - (8.36 * (c * c - c) + c)) < 8.36 * 4e-16);
}

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

/// A program with which a bench talks row by row.
class conversation {
 public:
  explicit conversation(const std::string& arguments) {
    std::array<int, 2> in{}, out{};
    if (pipe(in.data()) != 0 || pipe(out.data()) != 0) throw std::runtime_error("no pipe");
    child_ = fork();
    if (child_ == 0) {
      dup2(in[0], STDIN_FILENO);
      dup2(out[1], STDOUT_FILENO);
      for (const int each : {in[0], in[1], out[0], out[1]}) close(each);
      const std::string command = "exec " + quoted(BLYSK_PROGRAM) + " " + arguments + " 2>/dev/null";
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(127);
    }
    close(in[0]);
    close(out[1]);
    to_ = in[1];
    from_ = out[0];
  }
  ~conversation() {
    finish();
    close(from_);
  }
  conversation(const conversation&) = delete;
  conversation& operator=(const conversation&) = delete;

  void say(const std::string& text) const {
    REQUIRE(write(to_, text.data(), text.size()) == static_cast<ssize_t>(text.size()));
  }

  /// Waits for a line; empty if none comes for ten minutes.
  std::string line() const {
    std::string text;
    for (char c = 0; c != '\n'; text += c) {
      pollfd asked{from_, POLLIN, 0};
      if (poll(&asked, 1, 600'000) <= 0 || read(from_, &c, 1) != 1) return {};
    }
    return text;
  }

  int finish() {
    if (child_ == -1) return -1;
    close(to_);
    int status = 0;
    waitpid(std::exchange(child_, -1), &status, 0);
    return status;
  }

 private:
  pid_t child_ = -1;
  int to_ = -1, from_ = -1;
};

TEST_CASE("a bench that writes a row and waits gets its row", "[cli]") {
  const std::string engine = GENERATE("golden", "bit", "systemc", "verilator");
  conversation bench("simulate --format q8 --stimulus - --results - --engine " + engine);
  bench.say("n,cos,r,g,b\n10,0.5,1,2,3\n");
  CHECK(bench.line() == "n,cos,r,g,b,brdf,red,green,blue\n");
  CHECK(bench.line() == "10,0.5,1,2,3,0,0,0,0\n");
  bench.say("10,1,1,2,3\n# that is all\n");
  CHECK(bench.line() == "10,1,1,2,3,1,1,2,3\n");
  CHECK(bench.finish() == 0);

  conversation points("model blinn --points - --results -");
  points.say("n,cos\n2,0.5\n");
  CHECK(points.line() == "n,cos,value\n");
  CHECK(points.line() == "2,0.5,0.25\n");
  CHECK(points.finish() == 0);
}

TEST_CASE("simulate reads a pipe and writes one", "[cli]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kGood);
  const outcome piped = run_blysk(folder, "simulate --stimulus - --results - <" + quoted(in));
  REQUIRE(piped.status == 0);
  REQUIRE(run_blysk(folder, simulate(in, folder.path("out.csv"))).status == 0);
  CHECK(piped.out == slurp(folder.path("out.csv")));
}

TEST_CASE("simulate streams many rows through blocks without losing one", "[cli]") {
  const scratch folder;
  std::string text = "n,cos,r,g,b\n";
  constexpr int kRows = 50000;  // several blocks and input buffers
  for (int i = 0; i < kRows; ++i) {
    text += std::to_string(1 + i % 1000) + "," + std::to_string(i % 1001 / 1000.0) + "," +
            std::to_string(i % 256) + ",2,3\n";
  }
  const std::string in = folder.write("in.csv", text);
  REQUIRE(run_blysk(folder, simulate(in, folder.path("bit.csv"))).status == 0);
  REQUIRE(run_blysk(folder, simulate(in, folder.path("systemc.csv"), "--engine systemc")).status == 0);
  const std::string rows = slurp(folder.path("bit.csv"));
  CHECK(rows == slurp(folder.path("systemc.csv")));
  CHECK(std::count(rows.begin(), rows.end(), '\n') == kRows + 1);
}

TEST_CASE("simulate records waves under the names of fig. 1", "[cli]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kGood);
  const outcome done =
      run_blysk(folder, simulate(in, folder.path("out.csv"),
                                 "--engine systemc --vcd " + quoted(folder.path("w.vcd")) + " --json"));
  REQUIRE(done.status == 0);
  const auto summary = nlohmann::json::parse(done.out);
  CHECK(summary["rows"] == 4);
  CHECK(summary["writes"] == 5);
  CHECK(summary["cycles"] == 12);  // 2 of reset, 2 a write, the confirming one included
  const std::string waves = slurp(folder.path("w.vcd"));
  for (const char* name : {" clk ", " rst_n ", " strobe17 ", " valid29 ", " cos18 ", " out25_red ",
                           " out26_green ", " out27_blue ", "module rg1 ", "module rg5 ", "module mul6 ",
                           "module mul14 ", "module add9 ", "module add15 ", "module inv8 ", "1 ps"}) {
    CAPTURE(name);
    CHECK(waves.find(name) != std::string::npos);
  }
  CHECK(folder.names().size() == 3);  // in, out, waves: nothing temporary stays
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

TEST_CASE("simulate keeps an earlier result when a later run fails", "[cli]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kGood);
  REQUIRE(run_blysk(folder, simulate(in, folder.path("out.csv"))).status == 0);
  const std::string before = slurp(folder.path("out.csv"));
  folder.write("in.csv", kGood + "0,0,0,0,0\n");
  CHECK(run_blysk(folder, simulate(in, folder.path("out.csv"))).status == 2);
  CHECK(slurp(folder.path("out.csv")) == before);
}

TEST_CASE("files that cannot be read or written get one line", "[cli]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kGood);
  const auto fails = [&](const std::string& arguments, const std::string& message) {
    const outcome failed = run_blysk(folder, arguments);
    CAPTURE(arguments, failed.err);
    CHECK(failed.status == 2);
    CHECK(failed.err.starts_with("blysk: "));
    CHECK(failed.err.find(message) != std::string::npos);
    CHECK(std::count(failed.err.begin(), failed.err.end(), '\n') == 1);
  };
  fails(simulate(folder.path("none.csv"), folder.path("out.csv")),
        ": cannot be read (No such file or directory)");
  fails(simulate(folder.path(""), folder.path("out.csv")), ": is a directory, expected a CSV file");
  fails(simulate(in, folder.path("")), ": is a directory, expected a file to write");
  fails(simulate(in, folder.path("none/out.csv")), ": cannot be written (No such file or directory)");
  fails(simulate(in, "/dev/full"), "cannot be written (No space left on device)");
  fails(simulate(in, folder.path("out.csv"), "--engine systemc --vcd " + quoted(folder.path("none/w.vcd"))),
        ": cannot be written (No such file or directory)");
  if (geteuid() != 0) {  // root may read and write everything
    fs::permissions(in, fs::perms::none);
    fails(simulate(in, folder.path("out.csv")), ": cannot be read (Permission denied)");
  }
  CHECK(folder.names() == std::vector<std::string>{"in.csv"});
}

TEST_CASE("wrong use gets one line and status 2", "[cli]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kGood);
  const std::string out = folder.path("out.csv");
  for (const std::string& arguments :
       {std::string(), std::string("simulate"), std::string("polish"), simulate(in, out, "--format q9"),
        simulate(in, out, "--device sphere"), simulate(in, out, "--engine magic"),
        simulate(in, out, "--colour 3"), simulate(in, out, "--coefficient exact"),
        simulate(in, out, "--vcd w.vcd"), simulate(in, out, "--constant 0110"),
        simulate(in, out, "--engine golden --constant 110011"),
        std::string("model nobody --points ") + quoted(in) + " --results -"}) {
    const outcome failed = run_blysk(folder, arguments);
    CAPTURE(arguments, failed.err);
    CHECK(failed.status == 2);
    CHECK(failed.err.starts_with("blysk: "));
    CHECK(std::count(failed.err.begin(), failed.err.end(), '\n') == 1);
  }
  CHECK(folder.names() == std::vector<std::string>{"in.csv"});
}

TEST_CASE("model gives 17 digits and keeps the points' text", "[cli]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", "n,cos\n2,.75\n1000,1e0\n1,0.1\n");
  const outcome done = run_blysk(folder, "model blinn --points " + quoted(in) + " --results -");
  REQUIRE(done.status == 0);
  CHECK(done.out == "n,cos,value\n2,.75,0.5625\n1000,1e0,1\n1,0.1,0.10000000000000001\n");
  folder.write("in.csv", "n,cos\n2,0.5\n2,1.5\n");
  const outcome failed = run_blysk(
      folder, "model blinn --points " + quoted(in) + " --results " + quoted(folder.path("out.csv")));
  CHECK(failed.status == 2);
  CHECK(failed.err.starts_with("blysk: " + in + ":3: "));
  CHECK(folder.names() == std::vector<std::string>{"in.csv"});
}

TEST_CASE("list names what there is, for people and for programs", "[cli]") {
  const scratch folder;
  const auto json = nlohmann::json::parse(run_blysk(folder, "list --json").out);
  const std::string text = run_blysk(folder, "list").out;
  CHECK(json["models"].size() >= 16);
  for (const auto& model : json["models"])
    CHECK(text.find(model["name"].get<std::string>()) != std::string::npos);
  // What an option takes beside engine golden, and what that engine alone takes.
  CHECK(text.find("--coefficient [derived, published], engine golden also [exact]: ") != std::string::npos);
  CHECK(run_blysk(folder, "export --help").out.find("[derived]: derived, published (of " + kDevice) !=
        std::string::npos);
  CHECK(run_blysk(folder, "simulate --help")
            .out.find("derived, published; engine golden also exact (of " + kDevice) != std::string::npos);
  for (const char* engine : {"golden", "bit", "systemc", "verilator", "timed"}) {
    CHECK(std::count(json["engines"].begin(), json["engines"].end(), engine) == 1);
  }
}

TEST_CASE("list says of each device what a user chooses it by", "[cli]") {
  const scratch folder;
  const auto json = nlohmann::json::parse(run_blysk(folder, "list --json").out);
  const std::string text = run_blysk(folder, "list").out;
  const std::string markdown = run_blysk(folder, "list --markdown").out;
  CHECK(std::count(markdown.begin(), markdown.end(), '\n') ==
        static_cast<std::ptrdiff_t>(json["devices"].size()) + 2);
  bool has_errors = false;
  for (const auto& device : json["devices"]) {
    const auto name = device["name"].get<std::string>();
    CAPTURE(name);
    CHECK(markdown.find("| [" + name + "](docs/devices/" + name + ".md) | ") != std::string::npos);
    CHECK(fs::exists(BLYSK_ROOT "/docs/devices/" + name + ".md"));
    for (const char* key : {"title", "source", "figure", "good_for"}) {
      CAPTURE(key);
      CHECK_FALSE(device[key].get<std::string>().empty());
      CHECK(text.find(device[key].get<std::string>()) != std::string::npos);
    }
    CHECK_FALSE(device["blocks"].empty());
    for (const auto& block : device["blocks"]) {
      CHECK_FALSE(block["instance"].get<std::string>().empty());
      CHECK_FALSE(block["is"].get<std::string>().empty());
    }
    for (const auto& format : json["formats"]) CHECK(device["rom_bits"][format.get<std::string>()] >= 0);
    CHECK((device["latency_cycles"].is_null() || device["latency_cycles"] >= 1));
    for (const auto& row : device["errors"]) {
      has_errors = true;
      CAPTURE(row.dump());
      const bool is_whole = row["domain"] == "whole";
      CHECK((is_whole || row["domain"] == "epicentre"));
      const double error = row[is_whole ? "max_abs_err" : "max_rel_err"];
      CHECK((error >= 0 && error < 1));
      CHECK((row["n"] >= 0 && row["n"] <= 1000));
    }
  }
  CHECK(has_errors);
  CHECK(run_blysk(folder, "list --json --markdown").status == 2);
}

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
  for (const std::string arguments : {"vectors --level 3", "vectors --format q9", "vectors --seed x",
                                      "vectors --seed -1", "vectors --seed ''", "vectors --seed ' 1'",
                                      "vectors --seed 0x10", "vectors --seed 18446744073709551616",
                                      "settle --seed -1", "settle --pairs -1", "check --differences -1"}) {
    const outcome failed = run_blysk(folder, arguments);
    CAPTURE(arguments, failed.err);
    CHECK(failed.status == 2);
    CHECK(std::count(failed.err.begin(), failed.err.end(), '\n') == 1);
  }
}

TEST_CASE("zeros in front of a number do not make it octal", "[cli]") {
  const scratch folder;
  const std::string ten = run_blysk(folder, "vectors --format q8 --seed 10").out;
  CHECK(run_blysk(folder, "vectors --format q8 --seed 010").out == ten);
  CHECK(run_blysk(folder, "vectors --format q8 --seed 8").out != ten);
}

TEST_CASE("an argument that is wrong is named, and the help of its verb", "[cli]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", kGood);
  const auto fails = [&](const std::string& arguments, const std::string& message) {
    const outcome failed = run_blysk(folder, arguments);
    CAPTURE(arguments);
    CHECK(failed.status == 2);
    CHECK(failed.err == "blysk: " + message + "\n");
  };
  // What is unknown comes before what is missing: it may be a wrong name of that.
  fails("--verison", "'--verison' is unknown, see blysk --help");
  fails("simulate --stimlus x", "'--stimlus' is unknown, see blysk simulate --help");
  fails("explore merge a --outptu b", "'--outptu' is unknown, see blysk explore merge --help");
  fails("list extra", "'extra' is unknown, see blysk list --help");
  fails("model blinn --points x", "--results is required, see blysk model --help");
  // An unset variable of a script.
  const std::string simulate = "simulate --stimulus " + quoted(in) + " --results - ";
  for (const std::string option : {"--constant", "--engine", "--format", "--vcd", "--stages", "--period"})
    fails(simulate + option + " ''", option + " is '', expected a value");
  for (const std::string option : {"--watch", "--eye", "--target", "--ambient", "--background", "--fov"})
    fails("render sphere --output - " + option + " ''", option + " is '', expected a value");
  fails("simulate --stimulus= --results -", "--stimulus has no value, expected one");
  fails("list --json=", "--json has no value, expected one");
  fails("export --output -", "--output is -, expected a directory: an export has several files");
  CHECK(folder.names() == std::vector<std::string>{"in.csv"});
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
       {"000 100 ff ff ff 0 0 0\n", ":1: n is 0, expected a code 1..3e8"},
       {"001 101 ff ff ff 0 0 0\n", ":1: cos is 101, expected a code 0..100"},
       {"001 100 ff ff ff 0 0 0 0\n", ":1: has '0' at its end, expected n cos r g b red green blue"}}));
  CAPTURE(text);
  const std::string answers = folder.write("answers.txt", text);
  const outcome failed = run_blysk(folder, "check --format q8 --answers " + quoted(answers));
  CHECK(failed.status == 2);
  CHECK(failed.err == "blysk: " + answers + message + "\n");
}

TEST_CASE("every verb has its help", "[cli]") {
  const scratch folder;
  for (const std::string verb : {"", "simulate", "model", "export", "list", "vectors", "check"}) {
    const outcome help = run_blysk(folder, verb + " --help");
    CAPTURE(verb);
    CHECK(help.status == 0);
    CHECK(help.out.find("Usage: blysk") != std::string::npos);
    CHECK(help.err.empty());
  }
}

TEST_CASE("what cannot be brought to its end is refused, and nothing is left of it", "[cli]") {
  const scratch folder;
  const std::string stimulus = folder.write("in.csv", slurp(BLYSK_ROOT "/docs/examples/fig3.csv"));
  const auto fails = [&](const std::string& arguments, const std::string& message,
                         const std::string& first = "") {
    const outcome failed = run_blysk(folder, arguments, first);
    CAPTURE(arguments, failed.err);
    CHECK(failed.status == 2);
    CHECK(failed.err.starts_with("blysk: "));
    CHECK(failed.err.find(message) != std::string::npos);
    CHECK(std::count(failed.err.begin(), failed.err.end(), '\n') == 1);
    CHECK(folder.names() == std::vector<std::string>{"in.csv"});
  };
  const std::string in = " --stimulus " + quoted(stimulus);
  const auto to = [&](const std::string& name) { return " --results " + quoted(folder.path(name)); };
  const std::string waves = " --engine systemc --vcd " + quoted(folder.path("w.vcd"));
  // Results fit into 4 KiB, the waves do not.
  for (const std::string engine : {"systemc", "verilator"})
    fails("simulate" + in + to("out.csv") + " --engine " + engine + " --vcd " + quoted(folder.path("w.vcd")),
          "w.vcd: cannot be written to its end", "trap '' XFSZ; ulimit -f 8; ");
  fails("simulate" + in + to("in.csv"), "in.csv: is given by --stimulus and --results");
  fails("simulate" + in + to("w.vcd") + waves, "w.vcd: is given by --results and --vcd");
  fails("model blinn --points " + quoted(stimulus) + to("in.csv"),
        "in.csv: is given by --points and --results");
  fails("simulate" + in + to("out.csv") + " --engine systemc --vcd " + quoted(folder.path("w.lxt")),
        "w.lxt: names another form of waves, expected .vcd or .fst");
  fails("simulate" + in + to("out.csv") + " --engine systemc --vcd " + quoted(folder.path("w.GHW")),
        "w.GHW: names another form of waves, expected .vcd or .fst");
  fails("simulate" + in + to("out.csv") + " --engine systemc --vcd " + quoted(folder.path("w.vcd.gz")),
        "w.vcd.gz: names a packed file, expected .vcd or .fst");
  fails("simulate" + in + to("out.csv") + " --engine systemc --vcd " + quoted(folder.path("w.fst")),
        "w.fst: is FST, which GTKWave's vcd2fst makes, and that is not installed; expected .vcd",
        "PATH=/nonexistent; ");
  fails("simulate --format q10" + in + to("out.csv") + " --engine verilator --vcd " +
            quoted(folder.path("w.vcd")),
        "engine verilator has no waves of device " + kDevice + " in format q10, expected q8, q12, q16, q24");
  fails("simulate --engine verilator --as-published" + in + to("out.csv"),
        "engine verilator has device " + kDevice + " compiled in with its presets (");
  fails("shine",
        "'shine' is no verb, expected simulate, render, model, export, list, vectors, check, explore or "
        "settle");
  fails("compare --help", "'compare' is no verb");
  CHECK(slurp(stimulus) == slurp(BLYSK_ROOT "/docs/examples/fig3.csv"));
}

TEST_CASE("a signal that ends the program takes its unfinished files with it", "[cli]") {
  const scratch folder;
  const auto [name, number] = GENERATE(table<std::string, int>({{"HUP", SIGHUP},
                                                                {"INT", SIGINT},
                                                                {"QUIT", SIGQUIT},
                                                                {"ABRT", SIGABRT},
                                                                {"PIPE", SIGPIPE},
                                                                {"ALRM", SIGALRM},
                                                                {"TERM", SIGTERM},
                                                                {"USR1", SIGUSR1},
                                                                {"XCPU", SIGXCPU}}));
  // The stimulus does not end; the signal comes when both files are begun.
  const std::string command = fmt::format(
      "cd {} && {{ (echo n,cos,r,g,b; yes 10,0.5,1,2,3) |"
      " env --default-signal={} {} simulate --engine systemc --stimulus - --results out.csv --vcd out.vcd & "
      "}};"
      " until [ $(ls | grep -c part) = 2 ] || ! kill -0 $!; do sleep 0.01; done; kill -{} $!; wait $!",
      quoted(folder.path("")), name, quoted(BLYSK_PROGRAM), name);
  const int raw = std::system(command.c_str());
  CAPTURE(name);
  REQUIRE(WIFEXITED(raw));
  CHECK(WEXITSTATUS(raw) == 128 + number);  // ended by the signal itself
  CHECK(folder.names().empty());
}

TEST_CASE("a full standard output is an error", "[cli]") {
  for (const char* arguments : {"list", "list --json", "--help"}) {
    CAPTURE(arguments);
    const int raw =
        std::system(fmt::format("'{}' {} >/dev/full 2>/dev/null", BLYSK_PROGRAM, arguments).c_str());
    CHECK((WIFEXITED(raw) && WEXITSTATUS(raw) == 2));
  }
}

TEST_CASE("a link is written through, and permissions stay", "[cli]") {
  const scratch folder;
  const std::string stimulus = folder.write("in.csv", "n,cos,r,g,b\n10,0.5,1,2,3\n");
  const std::string real = folder.write("real.csv", "old");
  fs::permissions(real, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real.csv", folder.path("link.csv"));
  REQUIRE(run_blysk(folder, "simulate --stimulus " + quoted(stimulus) + " --results " +
                                quoted(folder.path("link.csv")))
              .status == 0);
  CHECK(fs::is_symlink(folder.path("link.csv")));
  CHECK(slurp(real).starts_with("n,cos,r,g,b,brdf"));
  CHECK(fs::status(real).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("messages do not pass on control bytes or half characters", "[cli]") {
  const scratch folder;
  const std::string field =
      "\x1b[31m" + std::string(17, 'x') +
      "\xd1\x89\xd1\x89\xd1\x89\xd1\x89\xd1\x89\xd1\x89\xd1\x89\xd1\x89\xd1\x89\xd1\x89";
  const std::string stimulus = folder.write("in.csv", "n,cos,r,g,b\n" + field + ",0.5,1,2,3\n");
  const outcome failed = run_blysk(folder, "simulate --stimulus " + quoted(stimulus) + " --results -");
  CHECK(failed.status == 2);
  CHECK(failed.err.find("in.csv:2: n is '\\x1B[31m" + std::string(17, 'x')) != std::string::npos);
  CHECK(failed.err.find("\xd1...") == std::string::npos);
}

}  // namespace
