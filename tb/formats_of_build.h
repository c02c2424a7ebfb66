// SPDX-License-Identifier: Apache-2.0
/// A build may have some of the named formats only: CMake's BLYSK_FORMATS.
#pragma once

#include <string_view>

namespace blysk {

/// Whether devices have ports and netlists in the named format in this build.
bool is_in_build(std::string_view format);

/// \throws std::invalid_argument if they have not
void expect_in_build(std::string_view format);

}  // namespace blysk
