// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "tb/render/picture.h"

namespace blysk::render {

inline constexpr int kTextHeight = 14;  ///< pixels of a line, its lead included

/// Writes white capitals, digits and common signs, 8 pixels each, its upper left corner at (x, y). What does not fit is
/// cut off; characters that it does not know are blanks.
void write_text(picture& on, int x, int y, std::string_view text);

/// Pixels that a line takes.
int text_width(std::string_view text);

}  // namespace blysk::render
