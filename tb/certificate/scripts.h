// SPDX-License-Identifier: Apache-2.0
/// Scripts for Gappa that together say how far a netlist is from what its specification calls exact.
#pragma once

#include <filesystem>
#include <string>

#include "tb/certificate/specification.h"
#include "tb/netlist/gappa_path.h"

namespace blysk {

/// The net whose error is bounded.
inline constexpr const char* kCertifiedNet = "brdf";

/// Writes into the folder, one goal or some hundred in each:
///   memory_NET_*.g  each word beside the number that it stands for
///   words_*.g       what the specification says of the words of one address
///   claim_*.g       its claims
///   case_*.g        the error, for each way through the selections, each group of addresses and each case of the formula
/// \param title  for the first line of each
/// \param bound  of |kCertifiedNet - exact|; empty: case_*.g ask for the error instead
/// \throws std::logic_error where the specification does not fit the netlist
void write_scripts(const specification& exact, const netlist::gappa_netlist& netlist,
                   const std::string& title, const std::string& bound, const std::filesystem::path& folder);

}  // namespace blysk
