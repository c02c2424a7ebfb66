// SPDX-License-Identifier: Apache-2.0
/// Catch2 of either generation: 2.13 (Debian 12) and 3 (Debian 13) name their header differently.
#pragma once

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
