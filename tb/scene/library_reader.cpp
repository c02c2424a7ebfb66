// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/library_reader.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <assimp/DefaultIOSystem.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <exception>
#include <filesystem>

#include "tb/scene/file_checks.h"
#include "tb/scene/material.h"
#include "tb/scene/mesh_builder.h"
#include "tb/scene/read_scene.h"
#include "tb/scene/text_lines.h"
#include "tb/usage_error.h"

namespace blysk::scene {
namespace {

// --- What goes through the pipe: a letter and a payload. 'm' a mesh follows, 'e' the text of an error.

class pipe_writer {
 public:
  explicit pipe_writer(int to) : to_(to) {}
  void bytes(const void* from, std::size_t size) {
    const auto* next = static_cast<const char*>(from);
    while (size > 0) {
      const ssize_t written = write(to_, next, size);
      if (written <= 0) _exit(1);
      next += written;
      size -= static_cast<std::size_t>(written);
    }
  }
  template <class T>
  void value(const T& from) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes(&from, sizeof from);
  }
  void text(const std::string& from) {
    value(from.size());
    bytes(from.data(), from.size());
  }
  void texts(const std::vector<std::string>& from) {
    value(from.size());
    for (const std::string& each : from) text(each);
  }
  template <class T>
  void list(const std::vector<T>& from) {
    value(from.size());
    for (const T& each : from) value(each);
  }

 private:
  int to_;
};

class pipe_reader {
 public:
  explicit pipe_reader(int from) : from_(from) {}
  bool bytes(void* to, std::size_t size) {
    auto* next = static_cast<char*>(to);
    while (size > 0) {
      const ssize_t got = read(from_, next, size);
      if (got <= 0) return false;
      next += got;
      size -= static_cast<std::size_t>(got);
    }
    return true;
  }
  template <class T>
  bool value(T& to) {
    return bytes(&to, sizeof to);
  }
  bool text(std::string& to) {
    std::size_t size = 0;
    if (!value(size)) return false;
    to.resize(size);
    return bytes(to.data(), size);
  }
  bool texts(std::vector<std::string>& to) {
    std::size_t count = 0;
    if (!value(count)) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if (!text(to.emplace_back())) return false;
    }
    return true;
  }
  template <class T>
  bool list(std::vector<T>& to) {
    std::size_t size = 0;
    if (!value(size)) return false;
    to.resize(size);
    return bytes(to.data(), size * sizeof(T));
  }

 private:
  int from_;
};

// --- In the process of the library

std::optional<rgb> colour_of(const aiMaterial& from, const char* key, unsigned type, unsigned index) {
  aiColor3D colour;
  if (from.Get(key, type, index, colour) != aiReturn_SUCCESS) return {};
  return rgb{colour.r, colour.g, colour.b};
}

/// Files of these formats name a way to shade; what has a highlight is the model with specular light.
void take_shading(const aiMaterial& from, raw_material& to) {
  const bool has_highlight = to.ks && *to.ks != rgb{0, 0, 0};
  to.illum = has_highlight ? 2 : 1;
  int model = 0;
  if (from.Get(AI_MATKEY_SHADING_MODEL, model) != aiReturn_SUCCESS) return;
  if (model == aiShadingMode_NoShading) {
    to.illum = 0;
    to.notes.emplace_back("without shading, its diffuse colour is taken as it is");
  } else if (model == aiShadingMode_Flat || model == aiShadingMode_Gouraud) {
    to.illum = 1;
    if (has_highlight) to.notes.emplace_back("matte by its shading, Ks dropped");
  }
}

/// Ks times how strong the highlight is said to be.
void take_strength(const aiMaterial& from, raw_material& to) {
  float strength = 1;
  if (!to.ks || from.Get(AI_MATKEY_SHININESS_STRENGTH, strength) != aiReturn_SUCCESS ||
      std::abs(strength - 1) < 1e-4)  // 3DS has percents
    return;
  for (double& each : *to.ks) each *= strength;
  to.notes.push_back(fmt::format("Ks times its strength {:.4g}", strength));
}

void note_textures(const aiMaterial& from, raw_material& to) {
  unsigned count = 0;
  for (int each = aiTextureType_NONE + 1; each <= AI_TEXTURE_TYPE_MAX; ++each)
    count += from.GetTextureCount(static_cast<aiTextureType>(each));
  if (count > 0) to.notes.emplace_back("textures dropped");
  float number = 0;
  // Where a file has glossiness, the library makes the two up.
  if (from.Get(AI_MATKEY_GLOSSINESS_FACTOR, number) == aiReturn_SUCCESS) return;
  if (from.Get(AI_MATKEY_METALLIC_FACTOR, number) == aiReturn_SUCCESS ||
      from.Get(AI_MATKEY_ROUGHNESS_FACTOR, number) == aiReturn_SUCCESS)
    to.notes.emplace_back("metallic and roughness factors dropped");
}

raw_material material_of(const aiMaterial& from) {
  raw_material raw;
  raw.name = from.GetName().C_Str();
  raw.ka = colour_of(from, AI_MATKEY_COLOR_AMBIENT);
  raw.kd = colour_of(from, AI_MATKEY_COLOR_DIFFUSE);
  raw.ks = colour_of(from, AI_MATKEY_COLOR_SPECULAR);
  raw.ke = colour_of(from, AI_MATKEY_COLOR_EMISSIVE);
  float number = 0;
  if (from.Get(AI_MATKEY_SHININESS, number) == aiReturn_SUCCESS) raw.n = number;
  if (from.Get(AI_MATKEY_OPACITY, number) == aiReturn_SUCCESS && number != 1)
    raw.notes.push_back(fmt::format("opacity {} dropped, surfaces are opaque", number));
  note_textures(from, raw);
  // Lists of numbers, so that a NaN is found here.
  for (auto* each : {&raw.ka, &raw.kd, &raw.ks, &raw.ke}) {
    if (*each && (std::isnan((**each)[0]) || std::isnan((**each)[1]) || std::isnan((**each)[2])))
      throw usage_error("a material's colour is NaN, expected a number");
  }
  if (raw.n && std::isnan(*raw.n)) throw usage_error("a material's exponent is NaN, expected a number");
  take_strength(from, raw);
  take_shading(from, raw);
  return raw;
}

vec checked(const aiVector3D& from) {
  const vec at{from.x, from.y, from.z};
  for (const double each : {at.x, at.y, at.z}) {
    if (!(std::abs(each) <= mesh::kLargest))
      throw usage_error(
          fmt::format("a vertex has {}, expected a number of at most {}", each, mesh::kLargest));
  }
  return at;
}

/// What a mesh has that is not drawn, counted.
struct undrawn {
  std::size_t coloured = 0;  ///< vertices with a colour of their own
  std::size_t narrow = 0;    ///< points and lines: faces of fewer than three corners
  std::size_t morphed = 0;   ///< meshes with other shapes to blend in
  std::size_t boned = 0;     ///< meshes that bones would move
};

void append(const aiMesh& from, std::size_t materials, mesh_builder& to, undrawn& left) {
  const auto first = static_cast<std::uint32_t>(to.positions.size());
  const auto first_normal = static_cast<std::uint32_t>(to.normals.size());
  const bool has_normals = from.HasNormals();
  if (from.HasVertexColors(0)) left.coloured += from.mNumVertices;
  if (from.mNumAnimMeshes > 0) ++left.morphed;
  if (from.HasBones()) ++left.boned;
  for (unsigned i = 0; i < from.mNumVertices; ++i) {
    to.positions.push_back(checked(from.mVertices[i]));
    if (!has_normals) continue;
    const aiVector3D& normal = from.mNormals[i];
    const bool is_number = std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z);
    to.normals.push_back(is_number ? vec{normal.x, normal.y, normal.z} : vec{0, 0, 0});
  }
  if (from.mMaterialIndex >= materials) throw usage_error("a mesh has no material, expected an index of one");
  std::vector<mesh_builder::corner> corners;
  for (unsigned i = 0; i < from.mNumFaces; ++i) {
    const aiFace& face = from.mFaces[i];
    corners.clear();
    for (unsigned k = 0; k < face.mNumIndices; ++k) {
      const unsigned index = face.mIndices[k];
      if (index >= from.mNumVertices)
        throw usage_error(
            fmt::format("vertex {} does not exist, expected less than {}", index, from.mNumVertices));
      corners.push_back({first + index, has_normals ? first_normal + index : mesh_builder::kNoNormal});
    }
    if (corners.size() >= 3)
      to.add(corners, from.mMaterialIndex, mesh_builder::kUnsaid);
    else
      ++left.narrow;
  }
}

/// What the library gives to a file, or a mesh, without a material: to 3DS a name that no file has; to OFF, which has no
/// materials, anything; to X one without a name, which those of files get; to glTF a white one behind all others, without a
/// name; to PLY, STL and RAW a grey one without a name, to AC one that shines white, to B3D one without colours; to others a
/// name of its own, with no exponent or 0.
bool is_missing(const aiMaterial& of, const std::string& ending, bool is_last) {
  const std::string_view called = of.GetName().C_Str();
  if (called == "%%%DEFAULT" || ending == ".off") return true;
  if (ending == ".x") return called.empty();
  const auto kd = colour_of(of, AI_MATKEY_COLOR_DIFFUSE);
  const auto ks = colour_of(of, AI_MATKEY_COLOR_SPECULAR);
  if (ending == ".gltf" || ending == ".glb") return is_last && called.empty() && kd == rgb{1, 1, 1};
  float exponent = 0;
  if (of.Get(AI_MATKEY_SHININESS, exponent) == aiReturn_SUCCESS && exponent != 0) return false;
  if (called == AI_DEFAULT_MATERIAL_NAME) return true;
  const bool is_grey = kd && (*kd)[0] == (*kd)[1] && (*kd)[1] == (*kd)[2];
  if (ending == ".raw") return called.empty() && !ks && is_grey;
  if (ending == ".ac")
    return called.empty() && is_grey && ks == rgb{1, 1, 1} &&
           colour_of(of, AI_MATKEY_COLOR_AMBIENT) == rgb{0, 0, 0};
  return called.empty() && kd == ks && (!kd || is_grey);
}

/// The files, with a note of each that the library opens.
class noted_files final : public Assimp::DefaultIOSystem {
 public:
  /// \param opened  outlives the object
  explicit noted_files(std::vector<std::string>& opened) : opened_(opened) {}

  Assimp::IOStream* Open(const char* file, const char* mode) override {
    Assimp::IOStream* const stream = DefaultIOSystem::Open(file, mode);
    if (stream != nullptr && std::ranges::find(opened_, file) == opened_.end()) opened_.emplace_back(file);
    return stream;
  }

 private:
  std::vector<std::string>& opened_;
};

library_mesh import(const std::string& path, std::vector<std::string>& messages) {
  library_mesh made;
  Assimp::Importer importer;
  importer.SetIOHandler(new noted_files(made.files));  // the importer's from then on
  // Instances become triangles in the world's coordinates.
  const aiScene* read = importer.ReadFile(path, aiProcess_PreTransformVertices);
  if (read == nullptr)
    throw usage_error(fmt::format("cannot be read ({}), expected a mesh that the library assimp reads",
                                  importer.GetErrorString()));
  mesh_builder built;
  std::vector<bool> is_used(read->mNumMaterials, false);
  for (unsigned i = 0; i < read->mNumMeshes; ++i) {
    if (read->mMeshes[i]->mMaterialIndex < is_used.size()) is_used[read->mMeshes[i]->mMaterialIndex] = true;
  }
  const std::string ending = ending_of(path);
  for (unsigned i = 0; i < read->mNumMaterials; ++i) {
    std::vector<std::string> of_unused;
    std::vector<std::string>& said = is_used[i] ? messages : of_unused;
    if (is_missing(*read->mMaterials[i], ending, i + 1 == read->mNumMaterials)) {
      said.emplace_back("a mesh has no material, a plain one taken");
      built.materials.push_back(plain_material());
    } else {
      built.materials.push_back(make_legal(material_of(*read->mMaterials[i]), said));
    }
  }
  undrawn left;
  for (unsigned i = 0; i < read->mNumMeshes; ++i) append(*read->mMeshes[i], read->mNumMaterials, built, left);
  if (built.triangles() == 0) throw usage_error("has no triangle with an area, expected one");
  if (left.coloured > 0) messages.push_back(fmt::format("colours of {} vertices dropped", left.coloured));
  if (left.narrow > 0)
    messages.push_back(fmt::format("{} faces of fewer than three corners dropped", left.narrow));
  if (left.morphed > 0) messages.push_back(fmt::format("other shapes of {} meshes dropped", left.morphed));
  if (left.boned > 0) messages.push_back(fmt::format("bones of {} meshes dropped", left.boned));
  if (read->HasAnimations()) messages.push_back(fmt::format("{} animations dropped", read->mNumAnimations));
  if (read->HasLights()) messages.push_back(fmt::format("{} lights of the file dropped", read->mNumLights));
  if (read->HasCameras())
    messages.push_back(fmt::format("{} cameras of the file dropped", read->mNumCameras));
  made.surface = std::move(built).finish(messages);
  return made;
}

// Sanitizers take terabytes of addresses for themselves.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kLimitsMemory = false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kLimitsMemory = false;
#else
constexpr bool kLimitsMemory = true;
#endif
#else
constexpr bool kLimitsMemory = true;
#endif

[[noreturn]] void serve(const std::string& path, int to) {
  // It hangs or grows on some broken files: seconds of processor time and bytes of memory by the size of the file.
  std::error_code ignored;
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);
  const rlim_t seconds = 5 + size / 1'000'000;
  const rlimit time{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &time);
  const rlim_t bytes = (rlim_t{1} << 31) + 100 * size;
  const rlimit memory{bytes, bytes};
  if (kLimitsMemory) setrlimit(RLIMIT_AS, &memory);
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // it ends with the program
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  // The program's handlers remove files that are the program's.
  for (int each = 1; each <= SIGRTMAX; ++each) std::signal(each, SIG_DFL);
  // What the library prints would come between the program's own lines, and what the program has not printed yet would
  // come twice if this process flushed its streams.
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere == -1 || dup2(nowhere, STDOUT_FILENO) == -1 || dup2(nowhere, STDERR_FILENO) == -1) _exit(1);
  pipe_writer out(to);
  try {
    std::vector<std::string> messages;
    const auto [made, files] = import(path, messages);
    out.value('m');
    out.texts(messages);
    out.texts(files);
    out.list(made.positions);
    out.list(made.normals);
    out.list(made.triangles);
    out.value(made.materials.size());
    for (const material& each : made.materials) {
      out.text(each.name);
      for (const rgb& colour : {each.emitted, each.ka, each.kd, each.ks}) out.value(colour);
      out.value(each.n);
    }
  } catch (const std::exception& error) {
    out.value('e');
    out.text(error.what());
  }
  _exit(0);
}

// --- In the program's process

bool receive(pipe_reader& in, library_mesh& to, std::vector<std::string>& messages, std::string& error) {
  char kind = 0;
  if (!in.value(kind)) return false;
  if (kind == 'e') return in.text(error);
  if (!in.texts(messages) || !in.texts(to.files)) return false;
  mesh& made = to.surface;
  std::size_t count = 0;
  if (!in.list(made.positions) || !in.list(made.normals) || !in.list(made.triangles) || !in.value(count))
    return false;
  for (std::size_t i = 0; i < count; ++i) {
    material& each = made.materials.emplace_back();
    if (!in.text(each.name)) return false;
    for (rgb* colour : {&each.emitted, &each.ka, &each.kd, &each.ks}) {
      if (!in.value(*colour)) return false;
    }
    if (!in.value(each.n)) return false;
  }
  return true;
}

}  // namespace

library_mesh read_by_library(const std::string& path, std::vector<std::string>& messages) {
  if (access(path.c_str(), R_OK) != 0) throw file_error(path, 0, "cannot be read (" + system_reason() + ")");
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown))
    throw file_error(path, 0, "is no regular file, expected a mesh");
  if (const std::string ending = ending_of(path); is_checked(ending))
    check_file(path, ending, read_file(path));
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) throw file_error(path, 0, "cannot be read (" + system_reason() + ")");
  const pid_t child = fork();
  if (child < 0) throw file_error(path, 0, "cannot be read (" + system_reason() + ")");
  if (child == 0) {
    close(ends[0]);
    serve(path, ends[1]);
  }
  close(ends[1]);
  library_mesh made;
  std::string error;
  pipe_reader in(ends[0]);
  const bool is_whole = receive(in, made, messages, error);
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (!error.empty()) throw file_error(path, 0, error);
  if (!is_whole || !WIFEXITED(status)) {
    const int by = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    const std::string reason = by == SIGXCPU || by == SIGKILL ? "does not end"
                               : by != 0                      ? fmt::format("ends by signal {}", by)
                                                              : "gives half a mesh";
    throw file_error(path, 0,
                     fmt::format("the library assimp {} on it, expected a file that it can read", reason));
  }
  return made;
}

}  // namespace blysk::scene
