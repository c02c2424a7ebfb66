// SPDX-License-Identifier: Apache-2.0
/// What ties a measured figure to the hardware that it was measured of.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tb/device.h"

namespace blysk::cost {

/// "sha256:" and 64 hexadecimal digits of the Verilog modules in the order of their names, each as name, line feed, text
/// and a zero byte. File lists and constraints do not count: they change no gate.
/// \throws std::runtime_error if the library of SHA-256 fails
std::string verilog_digest(const std::map<std::string, std::string>& files);

/// The digests of what the devices export, in their order; empty where a device cannot be exported. SystemC elaborates
/// once in a process, so each is made in a child of its own; the caller has elaborated nothing.
std::vector<std::string> exported_digests(const std::vector<selection>& asked);

}  // namespace blysk::cost
