// SPDX-License-Identifier: Apache-2.0
// Files and messages of the program where its user's machine is not as usual: other files of the same names, folders and
// files with other permissions, full disks, closed streams, text that is no text.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tb/catch.h"
#include "tb/cli/test/program.h"
#include "tb/output_file.h"
#include "tb/usage_error.h"

namespace {

const std::string kRow = "n,cos,r,g,b\n10,0.99,1,2,3\n";
const std::string kBadRow = "n,cos,r,g,b\n0,0.99,1,2,3\n";
const std::string kResult = "n,cos,r,g,b,brdf,red,green,blue\n10,0.99";

/// Exit status of shell commands in the folder; -1 if a signal ended them. BLYSK is the program.
int shell(const scratch& folder, const std::string& commands) {
  const int raw = std::system(
      ("cd " + quoted(folder.path("")) + " && BLYSK=" + quoted(BLYSK_PROGRAM) + " && " + commands).c_str());
  return WIFEXITED(raw) ? WEXITSTATUS(raw) : -1;
}

void write_file(const std::string& path, const std::string& text) {
  blysk::output_file file(path);
  file.write(text);
  file.commit();
}

std::vector<std::string> sorted_names(const scratch& folder) {
  std::vector<std::string> names = folder.names();
  std::sort(names.begin(), names.end());
  return names;
}

/// Nothing else stands on standard error: one line, printable.
void check_message(const std::string& text, const std::string& part) {
  CAPTURE(text);
  CHECK(text.starts_with("blysk: "));
  CHECK(text.find(part) != std::string::npos);
  CHECK(std::count(text.begin(), text.end(), '\n') == 1);
  CHECK(text.ends_with('\n'));
  CHECK(blysk::printable(text.substr(0, text.size() - 1)) == text.substr(0, text.size() - 1));
}

/// What runs the rest of a command as a user whom permissions bind; empty if there is none.
std::string as_user(const scratch& folder) {
  if (geteuid() != 0) return "env ";
  // This user has no rights but everybody's, and may not reach the build folder.
  const std::string user = "setpriv --reuid=65534 --regid=65534 --clear-groups ";
  return shell(folder, "chown 65534:65534 . && " + user + "\"$BLYSK\" --version >/dev/null 2>&1") == 0 ? user
                                                                                                       : "";
}

TEST_CASE("files of the names that were temporary once are their user's", "[cli][files]") {
  const scratch folder;
  folder.write("in.csv", kRow);
  folder.write("bad.csv", kBadRow);
  folder.write("precious", "precious");
  // The shell's number becomes the program's.
  const std::string run =
      "sh -c '{}; exec \"$0\" simulate --engine systemc --results a.csv --vcd w.vcd --stimulus {}'"
      " \"$BLYSK\" >/dev/null 2>&1";
  const std::string links = "ln -s precious a.csv.$$.part; ln -s precious w.vcd.$$.part.vcd";
  CHECK(shell(folder, fmt::format(fmt::runtime(run), links, "in.csv")) == 0);
  CHECK(slurp(folder.path("precious")) == "precious");
  CHECK(slurp(folder.path("a.csv")).starts_with(kResult));
  CHECK(slurp(folder.path("w.vcd")).find("$enddefinitions") != std::string::npos);
  CHECK_FALSE(fs::is_symlink(folder.path("a.csv")));
  CHECK_FALSE(fs::is_symlink(folder.path("w.vcd")));
  CHECK(folder.names().size() == 7);  // three, two results, two links

  const std::string own = "echo own >a.csv.$$.part; echo own >w.vcd.$$.part.vcd";
  CHECK(shell(folder, fmt::format(fmt::runtime(run), own, "bad.csv")) == 2);
  CHECK(folder.names().size() == 9);
}

TEST_CASE("a table of the co-simulation goes to its place by a name of its own", "[cli][files]") {
  const scratch folder;
  folder.write("precious", "precious");
  fs::create_symlink("precious", folder.path("table.md.part"));
  write_file(folder.path("table.md"), "text");
  CHECK(slurp(folder.path("table.md")) == "text");
  CHECK_FALSE(fs::is_symlink(folder.path("table.md")));
  CHECK(slurp(folder.path("precious")) == "precious");
  CHECK_THROWS_AS(write_file(folder.path("none/table.md"), "text"), blysk::usage_error);
  CHECK(folder.names().size() == 3);
}

TEST_CASE("a standard error that is full or closed leaves the status", "[cli][files]") {
  const scratch folder;
  folder.write("bad.csv", kBadRow);
  const std::string streams = GENERATE("2>/dev/full", "2>&-", "<&- 2>&-", "<&- >&- 2>&-");
  CAPTURE(streams);
  for (const char* arguments :
       {"simulate --stimulus bad.csv --results o.csv", "polish", "simulate --format q9",
        "model nobody --points bad.csv --results o.csv", "export --output bad.csv"}) {
    CAPTURE(arguments);
    CHECK(shell(folder, fmt::format("\"$BLYSK\" {} {}", arguments, streams)) == 2);
  }
  CHECK(sorted_names(folder) == std::vector<std::string>{"bad.csv"});
  CHECK(slurp(folder.path("bad.csv")) == kBadRow);
}

TEST_CASE("no file takes the number of a closed standard stream", "[cli][files]") {
  const scratch folder;
  folder.write("in.csv", kRow);
  // The summary has nowhere to go, the results have.
  CHECK(shell(folder, "\"$BLYSK\" simulate --stimulus in.csv --results o.csv <&- >&- 2>&-") == 2);
  const std::string result = slurp(folder.path("o.csv"));
  CHECK(result.starts_with(kResult));
  CHECK(std::count(result.begin(), result.end(), '\n') == 2);
  CHECK(shell(folder, "\"$BLYSK\" simulate --stimulus in.csv --results - >&- 2>error") == 2);
  check_message(slurp(folder.path("error")), "standard output: cannot be written (Bad file descriptor)");
  CHECK(shell(folder, "\"$BLYSK\" simulate --stimulus - --results o.csv <&- 2>error") == 2);
  check_message(slurp(folder.path("error")), "standard input: cannot be read (Bad file descriptor)");
}

TEST_CASE("permissions of the file decide, not those of its folder", "[cli][files]") {
  const scratch folder;
  const std::string user = as_user(folder);
  if (user.empty()) {
    WARN("no user but root reaches the program");
    return;
  }
  folder.write("in.csv", kRow);
  folder.write("bad.csv", kBadRow);
  REQUIRE(shell(folder,
                "mkdir fixed && echo old >fixed/o.csv && chmod 666 fixed/o.csv && echo old >only.csv"
                " && chmod 644 in.csv bad.csv && chmod 444 only.csv && { [ \"$(id -u)\" != 0 ] ||"
                " chown 65534 . fixed fixed/o.csv only.csv; } && chmod 555 fixed") == 0);
  const std::string simulate = user + "\"$BLYSK\" simulate --engine systemc --vcd w.vcd --stimulus ";
  CHECK(shell(folder, simulate + "bad.csv --results fixed/o.csv 2>/dev/null") == 2);
  CHECK(slurp(folder.path("fixed/o.csv")) == "old\n");
  CHECK(shell(folder, simulate + "in.csv --results fixed/o.csv >/dev/null") == 0);
  CHECK(slurp(folder.path("fixed/o.csv")).starts_with(kResult));
  CHECK(shell(folder, "ls -A fixed | wc -l | grep -qx 1") == 0);
  CHECK(shell(folder, user + "\"$BLYSK\" simulate --engine systemc --stimulus in.csv --results p.csv"
                             " --vcd fixed/o.csv >/dev/null") == 0);
  CHECK(slurp(folder.path("fixed/o.csv")).find("$enddefinitions") != std::string::npos);

  CHECK(shell(folder, simulate + "in.csv --results only.csv 2>error") == 2);
  check_message(slurp(folder.path("error")), "only.csv: cannot be written (Permission denied)");
  CHECK(slurp(folder.path("only.csv")) == "old\n");
  CHECK(shell(folder, simulate + "in.csv --results fixed/new.csv 2>error") == 2);
  check_message(slurp(folder.path("error")), "fixed/new.csv: cannot be written (Permission denied)");
  CHECK(shell(folder, "chmod 755 fixed") == 0);
}

TEST_CASE("a file that nobody may write is refused, to root too", "[cli][files]") {
  const scratch folder;
  folder.write("in.csv", kRow);
  REQUIRE(shell(folder, "echo old >only.csv && chmod 444 only.csv") == 0);
  CHECK(shell(folder, "\"$BLYSK\" simulate --stimulus in.csv --results only.csv 2>error") == 2);
  check_message(slurp(folder.path("error")), "only.csv: cannot be written (Permission denied)");
  CHECK(slurp(folder.path("only.csv")) == "old\n");
}

TEST_CASE("a file that something is mounted on is written in place", "[cli][files]") {
  const scratch folder;
  if (shell(folder, "unshare -rm true 2>/dev/null") != 0) {
    WARN("no mounts for this user");
    return;
  }
  folder.write("in.csv", kRow);
  folder.write("o.csv", "old, and longer than what comes: " + std::string(1000, 'x'));
  folder.write("mounted.csv", "");
  CHECK(shell(folder,
              "unshare -rm sh -c 'mount --bind o.csv mounted.csv &&"
              " \"$0\" simulate --stimulus in.csv --results mounted.csv' \"$BLYSK\" >/dev/null") == 0);
  const std::string result = slurp(folder.path("o.csv"));
  CHECK(result.starts_with(kResult));
  CHECK(std::count(result.begin(), result.end(), '\n') == 2);
  CHECK(sorted_names(folder) == std::vector<std::string>{"in.csv", "mounted.csv", "o.csv"});
}

TEST_CASE("hard links and links into nothing lead where they did", "[cli][files]") {
  const scratch folder;
  folder.write("in.csv", kRow);
  folder.write("o.csv", "old");
  fs::create_hard_link(folder.path("o.csv"), folder.path("other.csv"));
  fs::create_directory(folder.path("below"));
  fs::create_symlink("below/new.csv", folder.path("link.csv"));
  CHECK(shell(folder, "\"$BLYSK\" simulate --stimulus in.csv --results o.csv >/dev/null") == 0);
  CHECK(slurp(folder.path("other.csv")).starts_with(kResult));
  CHECK(shell(folder, "\"$BLYSK\" simulate --stimulus in.csv --results link.csv >/dev/null") == 0);
  CHECK(fs::is_symlink(folder.path("link.csv")));
  CHECK(slurp(folder.path("below/new.csv")).starts_with(kResult));
  CHECK(shell(folder, "\"$BLYSK\" simulate --stimulus o.csv --results other.csv 2>error") == 2);
  check_message(slurp(folder.path("error")), "other.csv: is given by --stimulus and --results");
  fs::create_symlink("later.csv", folder.path("l1"));
  fs::create_symlink("later.csv", folder.path("l2"));
  CHECK(shell(folder,
              "\"$BLYSK\" simulate --stimulus in.csv --engine timed --format q8 --results l1 --settling l2 "
              "2>error") == 2);
  check_message(slurp(folder.path("error")), "l2: is given by --results and --settling");
}

TEST_CASE("a file that is read through standard input is not written over", "[cli][files]") {
  const scratch folder;
  folder.write("in.csv", kRow);
  const auto refused = [&](const std::string& command) {
    CAPTURE(command);
    CHECK(shell(folder, command + " 2>error") == 2);
    check_message(slurp(folder.path("error")), "expected different files");
    CHECK(slurp(folder.path("in.csv")) == kRow);
  };
  refused("\"$BLYSK\" simulate --stimulus - --results in.csv <in.csv");
  refused("\"$BLYSK\" simulate --stimulus - --results - <in.csv 1<>in.csv");
  refused("\"$BLYSK\" simulate --stimulus in.csv --results - >>in.csv");
  refused("\"$BLYSK\" simulate --stimulus /dev/fd/0 --results in.csv <in.csv");
  refused("\"$BLYSK\" simulate --stimulus /proc/self/fd/3 --results in.csv 3<in.csv");
  refused("\"$BLYSK\" simulate --stimulus /proc/self/cwd/in.csv --results in.csv");
  // A terminal or a pipe is no such file.
  CHECK(shell(folder, "cat in.csv | \"$BLYSK\" simulate --stimulus - --results in.csv >/dev/null") == 0);
}

TEST_CASE("a file that a path of /proc or /dev leads to is replaced as others are", "[cli][files]") {
  const scratch folder;
  folder.write("bad.csv", "n,cos,r,g,b\n0,0.99,1,2,3\n");
  for (const std::string& path :
       {std::string("/proc/self/cwd/keep.csv"), "/dev/.." + folder.path("keep.csv")}) {
    CAPTURE(path);
    folder.write("keep.csv", "precious\n");
    CHECK(shell(folder, "\"$BLYSK\" simulate --stimulus bad.csv --results " + path + " 2>error") == 2);
    CHECK(slurp(folder.path("keep.csv")) == "precious\n");
  }
}

TEST_CASE("a caller that ignores the ends of its children changes nothing", "[cli][files]") {
  const scratch folder;
  fs::create_directory(folder.path("bin"));
  fs::permissions(folder.write("bin/ffmpeg", "#!/bin/sh\nfor last; do :; done\necho GIF89a >\"$last\"\n"),
                  fs::perms::owner_all);
  CHECK(shell(folder,
              "PATH=\"$PWD/bin:$PATH\" env --ignore-signal=CHLD \"$BLYSK\" render sphere --size 8x8 "
              "--density 8 --animate 2 --output f.png --film f.gif >/dev/null") == 0);
  CHECK(slurp(folder.path("f.gif")) == "GIF89a\n");
}

TEST_CASE("a picture that cannot be written has no line", "[cli][files]") {
  const scratch folder;
  CHECK(shell(folder, "\"$BLYSK\" render sphere --size 8x8 --output - >/dev/full 2>error") == 2);
  check_message(slurp(folder.path("error")), "blysk: standard output: cannot be written (No space left");
}

TEST_CASE("a folder of the name - is not standard input", "[cli][files]") {
  const scratch folder;
  folder.write("in.csv", kRow);
  fs::create_directory(folder.path("-"));
  CHECK(shell(folder, "\"$BLYSK\" simulate --stimulus - --results out.csv <in.csv >/dev/null") == 0);
  CHECK(slurp(folder.path("out.csv")).starts_with(kResult));
}

TEST_CASE("waves that vcd2fst did not write are refused", "[cli][files]") {
  const scratch folder;
  folder.write("in.csv", kRow);
  folder.write("vcd2fst", "#!/bin/sh\nexit 0\n");
  const std::string simulate =
      "chmod +x vcd2fst && PATH=\"$PWD:$PATH\" \"$BLYSK\" simulate --format q8 --engine systemc --stimulus "
      "in.csv"
      " --results out.csv --vcd w.fst 2>error";
  CHECK(shell(folder, simulate) == 2);
  check_message(slurp(folder.path("error")), "w.fst: cannot be made: vcd2fst failed");
  CHECK(sorted_names(folder) == std::vector<std::string>{"error", "in.csv", "vcd2fst"});
}

TEST_CASE("help and version that cannot be printed say why", "[cli][files]") {
  const scratch folder;
  for (const std::string arguments : {"--version", "--help", "simulate --help"}) {
    CAPTURE(arguments);
    CHECK(shell(folder, "\"$BLYSK\" " + arguments + " >/dev/full 2>error") == 2);
    check_message(slurp(folder.path("error")), "cannot be written (No space left on device)");
    CHECK(shell(folder, "\"$BLYSK\" " + arguments + " >&- 2>error") == 2);
    check_message(slurp(folder.path("error")), "cannot be written (Bad file descriptor)");
  }
}

TEST_CASE("a limit of size or of time leaves nothing behind", "[cli][files]") {
  const scratch folder;
  const std::string endless = "(echo n,cos,r,g,b; yes 10,0.5,1,2,3) | ";
  const std::string simulate =
      "\"$BLYSK\" simulate --engine systemc --stimulus - --results o.csv --vcd w.vcd 2>error";
  CHECK(shell(folder, "ulimit -f 64; " + endless + simulate) == 2);
  check_message(slurp(folder.path("error")), "cannot be written");
  CHECK(sorted_names(folder) == std::vector<std::string>{"error"});
  // Seconds of processor time, so the machine's speed does not matter. A soft limit of one second does not exist.
  for (const char* seconds : {"1", "2"}) {
    CAPTURE(seconds);
    CHECK(shell(folder, fmt::format("ulimit -t {}; ", seconds) + endless + simulate + " || [ $? = 152 ]") ==
          0);  // 128 + SIGXCPU
    CHECK(sorted_names(folder) == std::vector<std::string>{"error"});
  }
}

TEST_CASE("a limit of open files is one line, and leaves nothing behind", "[cli][files]") {
  const scratch folder;
  folder.write("in.csv", kRow);
  int refused = 0;
  for (int limit = 5; limit <= 12; ++limit) {
    CAPTURE(limit);
    // Exchanged for the program, the shell needs no numbers of its own.
    const int status =
        shell(folder, fmt::format("exec >/dev/null 2>error && ulimit -n {} && exec \"$BLYSK\" simulate"
                                  " --engine systemc --stimulus in.csv --results o.csv --vcd w.vcd",
                                  limit));
    CHECK((status == 0 || status == 2));
    if (status == 0) continue;
    ++refused;
    check_message(slurp(folder.path("error")), "(Too many open files)");
    CHECK(sorted_names(folder) == std::vector<std::string>{"error", "in.csv"});
  }
  CHECK(refused > 1);
}

TEST_CASE("what a tool leaves beside its file goes with it", "[cli][files]") {
  const scratch folder;
  folder.write("in.csv", kRow);
  // vcd2fst writes such a file while it works.
  const auto tool = [&](const std::string& then) {
    fs::create_directory(folder.path("bin"));
    folder.write("bin/vcd2fst", "#!/bin/sh\necho $$ >tool_id\ntouch \"$2.hier\" begun\n" + then);
    fs::permissions(folder.path("bin/vcd2fst"), fs::perms::owner_all);
  };
  const std::string simulate =
      "PATH=\"$PWD/bin:$PATH\" && export PATH && \"$BLYSK\" simulate --engine systemc --stimulus in.csv"
      " --results o.csv --vcd w.fst 2>error >/dev/null";
  const std::vector<std::string> left{"begun", "bin", "error", "in.csv", "tool_id"};
  tool("exit 1\n");
  CHECK(shell(folder, simulate) == 2);
  check_message(slurp(folder.path("error")), "w.fst: cannot be made: vcd2fst failed");
  CHECK(sorted_names(folder) == left);

  fs::remove(folder.path("begun"));
  tool("exec sleep 1000\n");
  CHECK(shell(folder, "{ " + simulate +
                          " & } && until [ -e begun ]; do sleep 0.01; done && kill -TERM $! &&"
                          " { wait $!; [ $? = 143 ]; } && ! kill -0 $(cat tool_id) 2>/dev/null") == 0);
  CHECK(sorted_names(folder) == left);
}

TEST_CASE("the longest name that a folder takes is written", "[cli][files]") {
  const scratch folder;
  folder.write("in.csv", kRow);
  const long longest = pathconf(folder.path("").c_str(), _PC_NAME_MAX);
  REQUIRE(longest > 200);
  // Of two bytes each, so that a cut can fall into a character.
  std::string name;
  while (name.size() + 2 + 4 <= static_cast<std::size_t>(longest)) name += "\xD1\x89";
  const std::string csv = name + ".csv";
  const std::string vcd = name + ".vcd";
  CHECK(run_blysk(folder, "simulate --engine systemc --stimulus " + quoted(folder.path("in.csv")) +
                              " --results " + quoted(folder.path(csv)) + " --vcd " + quoted(folder.path(vcd)))
            .status == 0);
  CHECK(sorted_names(folder) == std::vector<std::string>{"in.csv", csv, vcd});
}

TEST_CASE("a stimulus without rows has waves: the state at 0", "[cli][files]") {
  const scratch folder;
  const std::string in = folder.write("in.csv", "n,cos,r,g,b\n");
  const outcome done =
      run_blysk(folder, "simulate --engine systemc --stimulus " + quoted(in) + " --results " +
                            quoted(folder.path("o.csv")) + " --vcd " + quoted(folder.path("w.vcd")));
  CAPTURE(done.err);
  CHECK(done.status == 0);
  CHECK(done.err.empty());
  CHECK(done.out.find("0 rows") != std::string::npos);
  CHECK(slurp(folder.path("o.csv")) == "n,cos,r,g,b,brdf,red,green,blue\n");
  const std::string waves = slurp(folder.path("w.vcd"));
  CHECK(waves.find("$dumpvars") != std::string::npos);
  CHECK(waves.ends_with("$end\n\n#1\n"));

  folder.write("in.csv", kBadRow);
  check_message(run_blysk(folder, "simulate --engine systemc --stimulus " + quoted(in) +
                                      " --results - --vcd " + quoted(folder.path("w.vcd")))
                    .err,
                "in.csv:2: n is '0'");
}

TEST_CASE("an export goes beside hidden files and leaves them", "[cli][files]") {
  const scratch folder;
  fs::create_directory(folder.path("rtl"));
  folder.write("rtl/.gitkeep", "kept");
  CHECK(run_blysk(folder, "export --format q8 --output " + quoted(folder.path("rtl"))).status == 0);
  CHECK(slurp(folder.path("rtl/.gitkeep")) == "kept");
  CHECK(fs::exists(folder.path("rtl/" + top_of("q8") + ".v")));
}

TEST_CASE("what comes from outside is shown as one line of printable UTF-8", "[cli][files]") {
  const auto [field, shown] = GENERATE(table<std::string, std::string>({
      {"caf\xE9", "caf\\xE9"},  // Latin-1
      {"\x9B"
       "31m",
       "\\x9B31m"},                                 // C1 as a byte
      {"\xC2\x9B", "\\u009B"},                      // C1 as UTF-8
      {"\x1B[31m\x7F\x07", "\\x1B[31m\\x7F\\x07"},  // C0
      {"a\xE2\x80\xAE"
       "b",
       "a\\u202Eb"},                                 // right-to-left override
      {"\xE2\x81\xA6", "\\u2066"},                   // isolate
      {"\xE2\x80\xA8", "\\u2028"},                   // line separator
      {"\xED\xA0\x80", "\\xED\\xA0\\x80"},           // surrogate
      {"\xC0\xAF", "\\xC0\\xAF"},                    // overlong
      {"\xF4\x90\x80\x80", "\\xF4\\x90\\x80\\x80"},  // above 10FFFF
      {"\xF3\xA0\x80\xA0", "\\U000E0020"},           // tag
      {"\xF3\xA0\x84\x80", "\\U000E0100"},           // selector of variants
      {"\xC2\xAD", "\\u00AD"},                       // soft hyphen
      {"\xE1\xA0\x8E", "\\u180E"},                   // not shown, once a blank
      {"\xE3\x85\xA4", "\\u3164"},                   // filler, shown as a blank
      {"\xD1\x89\xE2\x82\xAC\xF0\x9F\x92\xA1", "\xD1\x89\xE2\x82\xAC\xF0\x9F\x92\xA1"},
      {std::string(50, '\x9B'), "\\x9B\\x9B..."},
  }));
  const scratch folder;
  CAPTURE(shown);
  CHECK(blysk::printable(field).starts_with(shown.substr(0, shown.find("..."))));
  // In a field, in the header, in an argument, in the name of a file.
  const std::string in = folder.write("in.csv", "n,cos,r,g,b\n" + field + ",0.5,1,2,3\n");
  check_message(run_blysk(folder, "simulate --results - --stimulus " + quoted(in)).err,
                shown + "', expected");
  folder.write("in.csv", field + "\n");
  check_message(run_blysk(folder, "simulate --results - --stimulus " + quoted(in)).err,
                "header is '" + shown.substr(0, 4));
  const std::string whole = blysk::printable(field);
  for (const std::string option : {" --format ", " --colour"}) {
    check_message(run_blysk(folder, "simulate --stimulus a --results b" + option + quoted(field)).err, whole);
  }
  check_message(run_blysk(folder, quoted(field)).err, "'" + whole + "' is no verb");
  check_message(run_blysk(folder, "model blinn --results - --points " + quoted(folder.path(field))).err,
                whole + ": cannot be read");
}

TEST_CASE("a file's name may be several lines, its message is one", "[cli][files]") {
  const scratch folder;
  const std::string name = folder.path("a\nb\x1B[2J");
  check_message(run_blysk(folder, "simulate --results - --stimulus " + quoted(name)).err,
                "a\\x0Ab\\x1B[2J: cannot be read (No such file or directory)");
  const outcome done = run_blysk(folder, "export --format q8 --output " + quoted(name));
  CHECK(done.status == 0);
  CHECK(done.out.find("a\\x0Ab\\x1B[2J: read it") != std::string::npos);
  CHECK(std::count(done.out.begin(), done.out.end(), '\n') == 1);
  const std::string utf16 = folder.write("in.csv", std::string("\xFF\xFEn\0,\0", 6));
  check_message(run_blysk(folder, "simulate --results - --stimulus " + quoted(utf16)).err,
                "in.csv:1: is UTF-16, expected text in UTF-8");
  folder.write("in.csv", std::string("n\0,\0", 4));  // without its byte order mark
  check_message(run_blysk(folder, "simulate --results - --stimulus " + quoted(utf16)).err,
                "in.csv:1: header is 'n\\x00,\\x00', expected n,cos,r,g,b");
}

}  // namespace
