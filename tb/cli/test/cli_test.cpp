// SPDX-License-Identifier: Apache-2.0
// The program as its users start it: results, and one clear line for everything that is wrong with an input. What tables,
// exports, vectors and lists are has files of its own.
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tb/catch.h"
#include "tb/cli/test/simulate.h"

namespace {

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
  fails("simulate --as-published=on",
        "--as-published is followed by a value, expected none, see blysk simulate --help");
  for (const char* number : {"0x10", "1_000", "10ns", "1 000"})
    fails(simulate + "--engine timed --period '" + number + "'",
          std::string("--period: is '") + number + "', expected a number, see blysk simulate --help");
  for (const char* number : {"0x10", "nan", "45deg", "180"})
    fails(std::string("render sphere --output - --fov ") + number,
          std::string("--fov: is '") + number +
              "', expected a number from 0.001 to 179, see blysk render --help");
  fails("export --output -", "--output is -, expected a directory: an export has several files");
  CHECK(folder.names() == std::vector<std::string>{"in.csv"});
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
