// SPDX-License-Identifier: Apache-2.0
/// ContainsSubstring(TEXT), as Catch2 3 names the matcher that Catch2 2 calls Contains.
#pragma once

#include "tb/catch.h"

#if __has_include(<catch2/catch_all.hpp>)
using Catch::Matchers::ContainsSubstring;
#else
inline auto ContainsSubstring(const std::string& text) {
  return Catch::Matchers::Contains(text);
}
#endif
