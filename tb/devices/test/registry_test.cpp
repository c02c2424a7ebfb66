// SPDX-License-Identifier: Apache-2.0
// The list of devices, and what choose() accepts of it.
#include <algorithm>
#include <set>

#include "tb/catch.h"
#include "tb/device.h"

namespace {

using namespace blysk;

const std::string kFormat{format_names[0]};

/// What choose() says, empty if it accepts.
std::string refusal(const std::string& device, const std::string& format,
                    const std::map<std::string, std::string>& options = {},
                    purpose is_for = purpose::hardware) {
  try {
    choose(device, format, options, is_for);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// "a, b, c"
template <class Range>
std::string listed(const Range& words, const std::string& before = "") {
  std::string text;
  for (const auto& each : words) text += (text.empty() ? "" : ", ") + before + std::string(each);
  return text;
}

}  // namespace

TEST_CASE("devices have names of their own, and say what they are", "[registry]") {
  REQUIRE_FALSE(devices().empty());
  std::set<std::string> names;
  for (const device* each : devices()) {
    CAPTURE(each->name());
    CHECK(names.insert(each->name()).second);
    CHECK_FALSE(each->title().empty());
    CHECK_FALSE(each->source().empty());
    CHECK_FALSE(each->figure().empty());
    CHECK_FALSE(each->good_for().empty());
    CHECK(each->identifier().find('-') == std::string::npos);
    std::set<std::string> options;
    for (const option& known : each->options()) {
      CAPTURE(known.name);
      CHECK(options.insert(known.name).second);
      CHECK_FALSE(known.help.empty());
      CHECK((known.values.empty() || std::ranges::count(known.values, known.preset) == 1));
    }
  }
}

TEST_CASE("every device is made in every format", "[registry]") {
  for (const device* each : devices()) {
    for (const auto format : format_names) {
      const std::string name{format};
      CAPTURE(each->name(), name);
      const selection chosen = choose(each->name(), name);
      CHECK(&chosen.of() == each);
      CHECK(chosen.is_preset());
      CHECK(std::to_string(chosen.fraction()) == name.substr(1));
      CHECK(chosen.folder_name() == each->identifier() + "_" + name);
      CHECK(chosen.top_name() == std::string("blysk_").append(chosen.folder_name()));
      CHECK(chosen.text().starts_with("device " + each->name() + ", format " + name));
      CHECK(choose(each->name(), name, {}, purpose::formula).is_for() == purpose::formula);
    }
  }
}

TEST_CASE("an unknown device is refused", "[registry]") {
  std::vector<std::string> names;
  for (const device* each : devices()) {
    names.push_back(each->name());
    for (const device_alias& other : each->aliases()) names.push_back(other.name);
  }
  CHECK(refusal("nosuch", kFormat) == "device nosuch does not exist, expected " + listed(names));
  CHECK(refusal("", kFormat) == "device  does not exist, expected " + listed(names));
}

TEST_CASE("an alias is its device with its options", "[registry]") {
  for (const device* each : devices()) {
    for (const device_alias& other : each->aliases()) {
      CAPTURE(other.name);
      const selection asked = choose(other.name, kFormat);
      CHECK(&asked.of() == each);
      CHECK(asked.text() == choose(each->name(), kFormat, other.options).text());
      CHECK(choose(other.name, kFormat, other.options).text() == asked.text());
      for (const auto& [name, value] : other.options) {
        for (const option& own : each->options()) {
          if (own.name != name) continue;
          for (const std::string& another : own.values) {
            if (another == value) continue;
            CHECK(refusal(other.name, kFormat, {{name, another}}) == "device " + other.name + " has " + name +
                                                                         " " + value + ", expected no --" +
                                                                         name + " " + another);
          }
        }
      }
    }
  }
}

TEST_CASE("an unknown format is refused", "[registry]") {
  for (const std::string wrong : {"q9", "", "Q8", "q8 "}) {
    CHECK(refusal(devices().front()->name(), wrong) ==
          "format " + wrong + " does not exist, expected " + listed(format_names));
  }
}

TEST_CASE("an option that the device does not have is refused", "[registry]") {
  for (const device* each : devices()) {
    std::vector<std::string> names;
    for (const option& known : each->options()) names.push_back(known.name);
    CHECK(refusal(each->name(), kFormat, {{"nosuch", "1"}}) ==
          "device " + each->name() + " has no option --nosuch, expected " +
              (names.empty() ? "none" : listed(names, "--")));
    // What another device has is no option of this one either.
    for (const device* other : devices()) {
      for (const option& theirs : other->options()) {
        if (std::ranges::count(names, theirs.name) > 0) continue;
        CHECK(refusal(each->name(), kFormat, {{theirs.name, theirs.preset}})
                  .starts_with("device " + each->name() + " has no option --" + theirs.name));
      }
    }
  }
}

TEST_CASE("a value that the option does not have is refused", "[registry]") {
  int checked = 0;
  for (const device* each : devices()) {
    for (const option& known : each->options()) {
      if (known.values.empty()) continue;
      CAPTURE(each->name(), known.name);
      const std::string head = "--" + known.name + " is nosuch, expected ";
      CHECK(refusal(each->name(), kFormat, {{known.name, "nosuch"}}) == head + listed(known.values));
      for (const std::string& value : known.values)
        CHECK(refusal(each->name(), kFormat, {{known.name, value}}).empty());
      if (!known.is_wired) {
        std::vector<std::string> all = known.values;
        all.insert(all.end(), known.formula_values.begin(), known.formula_values.end());
        CHECK(refusal(each->name(), kFormat, {{known.name, "nosuch"}}, purpose::formula) ==
              head + listed(all));
      }
      ++checked;
    }
  }
  CHECK(checked > 0);
}

TEST_CASE("a value that only the formula has is refused for hardware", "[registry]") {
  int checked = 0;
  for (const device* each : devices()) {
    for (const option& known : each->options()) {
      for (const std::string& value : known.formula_values) {
        CAPTURE(each->name(), known.name, value);
        CHECK(refusal(each->name(), kFormat, {{known.name, value}}) ==
              "--" + known.name + " " + value + " has no wires, expected " + listed(known.values) +
                  ", or engine golden");
        CHECK(refusal(each->name(), kFormat, {{known.name, value}}, purpose::formula).empty());
        ++checked;
      }
    }
  }
  CHECK(checked > 0);
}

TEST_CASE("an option of wires is refused for the formula", "[registry]") {
  int checked = 0;
  for (const device* each : devices()) {
    for (const option& known : each->options()) {
      if (!known.is_wired) continue;
      CAPTURE(each->name(), known.name);
      CHECK(refusal(each->name(), kFormat, {{known.name, "1"}}, purpose::formula) ==
            "--" + known.name + " chooses wires and engine golden has none, expected another engine");
      CHECK(refusal(each->name(), kFormat, {{known.name, known.preset}}, purpose::formula).empty());
      ++checked;
    }
  }
  CHECK(checked > 0);
}

TEST_CASE("an option that is given is no preset", "[registry]") {
  for (const device* each : devices()) {
    for (const option& known : each->options()) {
      for (const std::string& value : known.values) {
        CAPTURE(each->name(), known.name, value);
        const selection chosen = choose(each->name(), kFormat, {{known.name, value}});
        CHECK(chosen.value(known.name) == value);
        CHECK(chosen.is_preset() == (value == known.preset));
        if (known.is_flag()) CHECK(chosen.flag(known.name) == (value == "on"));
      }
    }
  }
}
