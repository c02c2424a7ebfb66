// SPDX-License-Identifier: Apache-2.0
// `blysk export`: what it writes, and what it leaves as it was.
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tb/catch.h"
#include "tb/cli/test/program.h"

namespace {

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

}  // namespace
