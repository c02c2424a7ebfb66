// SPDX-License-Identifier: Apache-2.0
/// What the library that reads meshes passes over in silence: an end that is missing, an index of nothing, what a file requires
/// of its reader.
#pragma once

#include <string>
#include <string_view>

namespace blysk::scene {

/// \param ending  of the file's name, ".off", in small letters; formats that it does not know are not looked at
/// \param bytes   of the file
/// \throws usage_error for what the library would not say
void check_file(const std::string& path, const std::string& ending, std::string_view bytes);

/// Whether check_file() looks at files of the ending.
bool is_checked(const std::string& ending);

}  // namespace blysk::scene
