// SPDX-License-Identifier: Apache-2.0
// The options that choose a device: the input's lines are the words of a command line. What is chosen has its values and
// ports; anything else is refused.
#include "tb/device_arguments.h"

#include <stdexcept>
#include <string>
#include <vector>

#include "tb/fuzz/fuzz.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;

/// A command line that is made once, as that takes longer than to read it.
struct command_line {
  explicit command_line(purpose is_for) { add_device_arguments(program, arguments, is_for); }

  CLI::App program{"fuzz"};
  asked_device arguments;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const purpose is_for = data[0] % 2 == 0 ? purpose::hardware : purpose::formula;
  std::vector<std::string> words;
  std::string_view text = fuzz::text_of(data + 1, size - 1);
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find('\n'));
    words.insert(words.begin(), std::string(word));  // CLI11 takes the last one first
    text.remove_prefix(std::min(text.size(), word.size() + 1));
  }
  static command_line for_hardware(purpose::hardware);
  static command_line for_formula(purpose::formula);
  auto& [program, arguments] = is_for == purpose::hardware ? for_hardware : for_formula;
  arguments = {};
  try {
    program.parse(words);
    const selection asked = arguments.choose(is_for);
    fuzz::expect(asked.of().name() == arguments.device && asked.format() == arguments.format,
                 "another device was chosen");
    for (const auto& [name, value] : arguments.options)
      fuzz::expect(asked.value(name) == value, "another value was chosen");
    fuzz::expect_message(asked.text());
    fuzz::expect(!asked.of().ports(asked).empty(), "no ports");
  } catch (const CLI::Error&) {
  } catch (const std::invalid_argument& error) {
    fuzz::expect_message(printable(error.what()));
  }
  return 0;
}
