// SPDX-License-Identifier: Apache-2.0
// Scene files: whatever the text is, a scene of a built-in shape or one line.
#include "tb/fuzz/fuzz.h"
#include "tb/scene/read_scene.h"
#include "tb/usage_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blysk;
  try {
    // A folder that is not there: no file is read.
    const auto read = scene::read_scene_file("/nosuch/a.json", std::string(fuzz::text_of(data, size)), 2);
    fuzz::expect(!read.of.surface.triangles.empty(), "a scene without triangles");
    if (read.of.view) scene::check_camera("camera", *read.of.view);
  } catch (const usage_error& error) {
    fuzz::expect_message(error.what());
  }
  return 0;
}
