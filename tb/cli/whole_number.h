// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

namespace blysk::cli {

/// Checks that an option is given digits alone, no sign, blank or base, that make a number from least to most: the reader of
/// the command line itself takes -1 for 18446744073709551615, and 010 for eight. For transform(): check() would leave the
/// zeros in front.
CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);

}  // namespace blysk::cli
