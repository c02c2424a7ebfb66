// SPDX-License-Identifier: Apache-2.0
/// Whether a PLY file is whole: the library that reads its mesh takes what is there, and makes up the rest.
#pragma once

#include <string>
#include <string_view>

namespace blysk::scene {

/// What is missing of the elements that the header promises, such as "has 1 of 2 elements 'face', expected all of
/// them"; empty if nothing is, or the header is none that this function understands.
/// \param text  of the file, in ASCII or binary of either byte order
std::string missing_of_ply(std::string_view text);

}  // namespace blysk::scene
