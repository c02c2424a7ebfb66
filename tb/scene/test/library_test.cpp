// SPDX-License-Identifier: Apache-2.0
// Debian's test models of assimp: our reader of OBJ against the library, and files that are broken.
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "tb/catch.h"
#include "tb/scene/library_reader.h"
#include "tb/scene/read_scene.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;
using namespace blysk::scene;
namespace fs = std::filesystem;

const fs::path kModels = "/usr/share/assimp/models";

struct measures {
  double area = 0;
  vec moment{0, 0, 0};  // of the area
};

measures measure(const mesh& of) {
  measures sum;
  for (const triangle& each : of.triangles) {
    const auto at = [&](std::size_t k) { return of.positions[each.position[k]]; };
    const vec twice = cross(at(1) - at(0), at(2) - at(0));
    const double area = std::sqrt(golden::dot(twice, twice)) / 2;
    sum.area += area;
    sum.moment = sum.moment + area / 3 * (at(0) + at(1) + at(2));
  }
  return sum;
}

/// The mesh, or what was said instead.
std::string outcome_of(const fs::path& path, mesh& made) {
  try {
    made = read_scene(path.string()).of.surface;
    return "";
  } catch (const usage_error& error) {
    return error.what();
  }
}

TEST_CASE("our reader of OBJ and assimp see the same surfaces", "[scene][models]") {
  std::size_t compared = 0;
  for (const auto& entry : fs::directory_iterator(kModels / "OBJ")) {
    if (entry.path().extension() != ".obj") continue;
    CAPTURE(entry.path());
    mesh ours;
    const std::string refusal = outcome_of(entry.path(), ours);
    if (!refusal.empty()) {
      CAPTURE(refusal);
      CHECK(refusal.starts_with(entry.path().string() + ":"));
      continue;
    }
    std::vector<std::string> messages;
    mesh theirs;
    try {
      theirs = read_by_library(entry.path().string(), messages).surface;
    } catch (const usage_error&) {
      continue;  // UTF-16 that it takes for an empty file
    }
    const measures a = measure(ours);
    const measures b = measure(theirs);
    // The library keeps floats: each coordinate is off by half an ulp of its size.
    double largest = 0;
    for (const vec& at : ours.positions)
      largest = std::max({largest, std::abs(at.x), std::abs(at.y), std::abs(at.z)});
    const double ulp = largest * 0x1p-24;
    const double margin =
        12 * ulp * std::sqrt(a.area * static_cast<double>(ours.triangles.size())) + 1e-12 * a.area;
    CHECK(std::abs(a.area - b.area) <= margin);
    for (const double off : {a.moment.x - b.moment.x, a.moment.y - b.moment.y, a.moment.z - b.moment.z})
      CHECK(std::abs(off) <= 2 * largest * margin);
    ++compared;
  }
  CHECK(compared >= 15);
}

TEST_CASE("what is not printed yet is printed once", "[scene]") {
  std::string path = (fs::temp_directory_path() / "blysk-XXXXXX.ply").string();
  const int file = mkstemps(path.data(), 4);
  REQUIRE(file != -1);
  std::cout.flush();  // what Catch2 has said
  // A process of its own, whose standard output is a file, and so written when its buffer is full.
  const pid_t child = fork();
  if (child == 0) {
    dup2(file, STDOUT_FILENO);
    std::setvbuf(stdout, nullptr, _IOFBF, 1 << 12);
    std::fputs("ply\n", stdout);
    std::vector<std::string> messages;
    try {
      read_by_library(path, messages);  // no mesh
    } catch (const usage_error&) {
    }
    std::fflush(stdout);
    _exit(0);
  }
  int status = -1;
  CHECK(waitpid(child, &status, 0) == child);
  CHECK(status == 0);
  std::array<char, 64> text{};
  const ssize_t size = pread(file, text.data(), text.size(), 0);
  CHECK(std::string_view(text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))) == "ply\n");
  close(file);
  fs::remove(path);
}

TEST_CASE("every model is a mesh or one line", "[scene][models][full]") {
  std::size_t meshes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kModels)) {
    std::string ending = entry.path().extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending != ".obj" && ending != ".3ds" && ending != ".ply" && ending != ".gltf" && ending != ".glb")
      continue;
    CAPTURE(entry.path());
    mesh made;
    const std::string refusal = outcome_of(entry.path(), made);
    CHECK(printable(refusal) == refusal);
    if (!refusal.empty()) continue;
    ++meshes;
    for (const triangle& each : made.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(each.position[k] < made.positions.size());
        REQUIRE(each.normal[k] < made.normals.size());
      }
      REQUIRE(each.material < made.materials.size());
    }
    for (const vec& at : made.positions) REQUIRE(std::abs(at.x + at.y + at.z) <= 3 * mesh::kLargest);
    for (const material& each : made.materials) {
      REQUIRE(each.n >= 1);
      REQUIRE(each.n <= 1000);
    }
  }
  CHECK(meshes >= 50);
}

}  // namespace
