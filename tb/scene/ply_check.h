// SPDX-License-Identifier: Apache-2.0
/// Whether a PLY file is whole and says what it means: the library that reads its mesh takes what is there, and makes up the
/// rest.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace blysk::scene {

struct ply_fault {
  std::size_t line;  ///< 0: of none
  std::string what;  ///< "has 1 of 2 elements 'face', expected all of them"
};

/// The first fault of the elements that the header promises: one that is not there, a word that is no number, an index of a
/// vertex that does not exist; in text, a line that is no element. None also for a header that this function does not understand.
/// \param text  of the file, in ASCII or binary of either byte order
std::optional<ply_fault> fault_of_ply(std::string_view text);

}  // namespace blysk::scene
