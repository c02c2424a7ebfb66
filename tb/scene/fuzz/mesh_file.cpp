// SPDX-License-Identifier: Apache-2.0
// What is checked of a mesh file before a library reads it. The text's first line is the ending of its name, ".ply".
#include <algorithm>

#include "tb/fuzz/fuzz.h"
#include "tb/scene/file_checks.h"
#include "tb/usage_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blysk;
  const std::string_view text = fuzz::text_of(data, size);
  const std::size_t end = std::min(text.find('\n'), text.size());
  try {
    scene::check_file("a mesh", std::string(text.substr(0, end)),
                      text.substr(std::min(end + 1, text.size())));
  } catch (const usage_error& error) {
    fuzz::expect_message(error.what());
  }
  return 0;
}
