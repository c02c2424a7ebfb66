// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/file_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "tb/line_reader.h"
#include "tb/scene/ply_check.h"
#include "tb/scene/text_lines.h"
#include "tb/usage_error.h"

namespace blysk::scene {
namespace {

std::string missing_vertex(std::uint64_t index, std::uint64_t count) {
  return fmt::format("vertex {} does not exist, expected less than {}", index, count);
}

// --- OFF: "OFF", the counts of vertices, faces and edges, a line for each vertex, a line for each face

std::optional<std::uint64_t> count_of(std::string_view word) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

/// \throws usage_error with the line
void check_off(const std::string& path, std::string_view text) {
  text_lines line(text);
  if (!line.next()) return;
  // With dimensions of its own (nOFF, 4OFF) a file has other lines.
  const std::string_view kind = line.keyword();
  if (!kind.ends_with("OFF") || kind.find_first_of("n4") != std::string_view::npos) return;
  std::string_view first;  // word of the line, until it is taken
  std::string_view rest = line.value();
  const auto next_line = [&] {
    if (!line.next()) return false;
    first = line.keyword();
    rest = line.value();
    return true;
  };
  const auto next_word = [&] { return first.empty() ? take_word(rest) : std::exchange(first, {}); };
  if (rest.starts_with("BINARY") || (rest.empty() && !next_line())) return;
  std::array<std::uint64_t, 2> counts{};
  for (std::uint64_t& each : counts) {
    const std::string_view word = next_word();
    const auto count = count_of(word);
    if (!count) throw file_error(path, line.number(), fmt::format("has '{}', expected a count", shown(word)));
    each = *count;
  }
  const auto fail_at_end = [&](std::uint64_t at, std::uint64_t count, const char* what) {
    throw file_error(path, 0, fmt::format("has {} of {} {}, expected all of them", at, count, what));
  };
  for (std::uint64_t i = 0; i < counts[0]; ++i) {
    if (!next_line()) fail_at_end(i, counts[0], "vertices");
    for (int k = 0; k < 3; ++k) {
      const std::string_view word = next_word();
      if (!number_of(word))
        throw file_error(path, line.number(),
                         fmt::format("vertex has '{}', expected three numbers", shown(word)));
    }
  }
  for (std::uint64_t i = 0; i < counts[1]; ++i) {
    if (!next_line()) fail_at_end(i, counts[1], "faces");
    const std::string_view size_word = next_word();
    const auto size = count_of(size_word);
    if (!size)
      throw file_error(path, line.number(),
                       fmt::format("face has '{}', expected how many corners", shown(size_word)));
    for (std::uint64_t k = 0; k < *size; ++k) {
      const std::string_view word = next_word();
      const auto index = count_of(word);
      if (!index)
        throw file_error(path, line.number(),
                         fmt::format("face has '{}', expected {} indices", shown(word), *size));
      if (*index >= counts[0]) throw file_error(path, line.number(), missing_vertex(*index, counts[0]));
    }
  }
}

// --- 3DS: chunks of an identifier of 16 bits, a size of 32 with these six bytes, and what is in them

class chunk_reader {
 public:
  explicit chunk_reader(std::string_view bytes) : bytes_(bytes) {}

  bool next() {
    if (bytes_.size() < kHead) return false;
    const std::size_t size = number(bytes_, 2) | number(bytes_, 4) << 16;
    if (size < kHead || size > bytes_.size()) return false;
    id_ = number(bytes_, 0);
    inside_ = bytes_.substr(kHead, size - kHead);
    bytes_.remove_prefix(size);
    return true;
  }
  std::size_t id() const { return id_; }
  std::string_view inside() const { return inside_; }

  /// 16 bits, the lower eight first.
  static std::size_t number(std::string_view bytes, std::size_t at) {
    return static_cast<unsigned char>(bytes[at]) | std::size_t{static_cast<unsigned char>(bytes[at + 1])}
                                                       << 8;
  }

 private:
  static constexpr std::size_t kHead = 6;

  std::string_view bytes_, inside_;
  std::size_t id_ = 0;
};

std::string fault_of_3ds_mesh(std::string_view bytes) {
  constexpr std::size_t kVertices = 0x4110;
  constexpr std::size_t kFaces = 0x4120;
  constexpr std::size_t kFaceBytes = 8;  // three indices and flags
  std::size_t vertices = 0;
  std::string_view faces;
  for (chunk_reader chunk(bytes); chunk.next();) {
    if (chunk.inside().size() < 2) continue;
    if (chunk.id() == kVertices) vertices = chunk_reader::number(chunk.inside(), 0);
    if (chunk.id() == kFaces) faces = chunk.inside();
  }
  if (faces.empty()) return {};
  const std::size_t count = chunk_reader::number(faces, 0);
  faces.remove_prefix(2);
  if (faces.size() / kFaceBytes < count)
    return fmt::format("has {} of {} faces of a mesh, expected all of them", faces.size() / kFaceBytes,
                       count);
  for (std::size_t face = 0; face < count; ++face) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t index = chunk_reader::number(faces, face * kFaceBytes + 2 * k);
      if (index >= vertices) return missing_vertex(index, vertices);
    }
  }
  return {};
}

/// \param depth  of chunks in chunks: a mesh is the fourth
std::string fault_of_3ds(std::string_view bytes, int depth = 0) {
  constexpr int kDeepest = 4;
  if (depth == kDeepest) return {};
  constexpr std::size_t kFile = 0x4D4D;
  constexpr std::size_t kEditor = 0x3D3D;
  constexpr std::size_t kObject = 0x4000;
  constexpr std::size_t kMesh = 0x4100;
  for (chunk_reader chunk(bytes); chunk.next();) {
    std::string_view inside = chunk.inside();
    if (chunk.id() == kMesh) {
      if (std::string fault = fault_of_3ds_mesh(inside); !fault.empty()) return fault;
      continue;
    }
    if (chunk.id() == kObject)
      inside.remove_prefix(std::min(inside.size(), inside.find('\0') + 1));  // its name
    else if (chunk.id() != kFile && chunk.id() != kEditor)
      continue;
    if (std::string fault = fault_of_3ds(inside, depth + 1); !fault.empty()) return fault;
  }
  return {};
}

// --- glTF

std::string_view json_of_glb(std::string_view bytes) {
  constexpr std::size_t kHead = 20;  // of the file, and of its first chunk
  if (bytes.size() < kHead || !bytes.starts_with("glTF") || bytes.substr(16, 4) != "JSON") return {};
  const std::size_t size = chunk_reader::number(bytes, 12) | chunk_reader::number(bytes, 14) << 16;
  return bytes.substr(kHead, size);
}

/// Extensions that change where vertices are, and that the library passes over.
bool is_of_shape(std::string_view extension) {
  constexpr std::array kOfShape{"KHR_mesh_quantization", "EXT_meshopt_compression", "KHR_meshopt_compression",
                                "EXT_mesh_gpu_instancing"};
  return std::ranges::find(kOfShape, extension) != kOfShape.end();
}

std::string fault_of_gltf(std::string_view text) {
  using nlohmann::json;
  const json read = json::parse(text, nullptr, false);
  if (!read.is_object() || !read.contains("extensionsRequired")) return {};
  for (const json& each : read["extensionsRequired"]) {
    if (each.is_string() && is_of_shape(each.get<std::string>()))
      return fmt::format("requires the extension {}, expected a file without it",
                         shown(each.get<std::string>()));
  }
  return {};
}

// --- DXF

std::string fault_of_dxf(std::string_view text) {
  if (text.starts_with("AutoCAD Binary DXF")) return {};
  // Programs of DOS put more behind it.
  const std::size_t at = text.rfind("EOF");
  if (at != std::string_view::npos && at > 0 &&
      (text[at - 1] == '\n' || text[at - 1] == '\r' || text[at - 1] == ' '))
    return {};
  return "ends without EOF, expected the whole file";
}

}  // namespace

void check_file(const std::string& path, const std::string& ending, std::string_view bytes) {
  if (ending == ".ply") {
    if (const std::optional<ply_fault> fault = fault_of_ply(bytes))
      throw file_error(path, fault->line, fault->what);
  }
  if (ending == ".off") check_off(path, bytes);
  const std::string fault = ending == ".3ds"    ? fault_of_3ds(bytes)
                            : ending == ".gltf" ? fault_of_gltf(bytes)
                            : ending == ".glb"  ? fault_of_gltf(json_of_glb(bytes))
                            : ending == ".dxf"  ? fault_of_dxf(bytes)
                                                : "";
  if (!fault.empty()) throw file_error(path, 0, fault);
}

bool is_checked(const std::string& ending) {
  constexpr std::array kChecked{".ply", ".off", ".3ds", ".gltf", ".glb", ".dxf"};
  return std::ranges::find(kChecked, ending) != kChecked.end();
}

}  // namespace blysk::scene
