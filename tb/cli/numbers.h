// SPDX-License-Identifier: Apache-2.0
/// Numbers on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>

namespace blysk::cli {

/// Checks that an option is given digits alone, no sign, blank or base, that make a number from least to most: the reader of
/// the command line itself takes -1 for 18446744073709551615, and 010 for eight. For transform(): check() would leave the
/// zeros in front.
CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);

/// Checks that an option is given a decimal number, one from least to most if they are given: the reader of the command line
/// itself takes 0x10 for 16, and nan for one in any range. For transform().
CLI::Validator real_number(double least = -HUGE_VAL, double most = HUGE_VAL);

}  // namespace blysk::cli
