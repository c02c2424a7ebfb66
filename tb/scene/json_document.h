// SPDX-License-Identifier: Apache-2.0
/// A JSON text, and the lines in which its values stand.
#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace blysk::scene {

struct json_document {
  nlohmann::json root;
  /// By the place of a value, "lights[0].colour": the line of its key, or of its first character in an array. Values below
  /// kDeepest levels are not in it.
  std::map<std::string, std::size_t> lines;

  static constexpr std::size_t kDeepest = 8;
};

/// "lights.colour" of "lights" and "colour".
std::string member_place(const std::string& of, const std::string& key);

/// "lights[0]" of "lights" and 0.
std::string element_place(const std::string& of, std::size_t index);

/// \param path  for messages
/// \throws usage_error with the line, for what is no JSON, and for a key that stands twice in one object
json_document parse_document(const std::string& path, const std::string& text);

}  // namespace blysk::scene
