// SPDX-License-Identifier: Apache-2.0
// The reader of OBJ and MTL: the text up to the line "--mtl" is the mesh, what follows the material library that any
// name leads to. Whatever is in them, what comes out is a legal mesh or one line.
#include "tb/scene/obj_reader.h"

#include <algorithm>
#include <cmath>

#include "tb/fuzz/fuzz.h"
#include "tb/scene/text_lines.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;

void expect_legal(const scene::mesh& of) {
  for (const scene::triangle& each : of.triangles) {
    fuzz::expect(each.material < of.materials.size(), "a triangle's material does not exist");
    for (std::size_t k = 0; k < 3; ++k) {
      fuzz::expect(each.position[k] < of.positions.size(), "a triangle's corner does not exist");
      fuzz::expect(each.normal[k] < of.normals.size(), "a triangle's normal does not exist");
      const scene::vec& normal = of.normals[each.normal[k]];
      fuzz::expect(std::abs(golden::dot(normal, normal) - 1) < 1e-9, "a normal is no unit vector");
    }
  }
  for (const scene::vec& at : of.positions) {
    for (const double each : {at.x, at.y, at.z})
      fuzz::expect(std::abs(each) <= scene::mesh::kLargest, "a vertex is not legal");
  }
  for (const scene::material& each : of.materials) {
    fuzz::expect(each.n >= 1 && each.n <= 1000, "an exponent is not legal");
    for (const scene::rgb& share : {each.emitted, each.ka, each.kd, each.ks})
      fuzz::expect(std::ranges::all_of(share, [](double part) { return part >= 0 && part <= 1; }),
                   "a share is not legal");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const auto split = text.find("--mtl\n");
  const std::string library(split == std::string_view::npos ? std::string_view{} : text.substr(split + 6));
  const auto open = [&](const std::string& name) { return scene::library_text{name, library}; };
  std::vector<std::string> messages;
  try {
    expect_legal(scene::read_obj("a.obj", scene::decoded("a.obj", std::string(text.substr(0, split))), open,
                                 messages));
    for (const std::string& each : messages) fuzz::expect_message(printable(each));
  } catch (const usage_error& error) {
    fuzz::expect_message(error.what());
  }
  return 0;
}
