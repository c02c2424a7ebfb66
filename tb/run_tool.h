// SPDX-License-Identifier: Apache-2.0
/// Programs of others, where they are installed.
#pragma once

#include <string>
#include <vector>

namespace blysk {

/// Whether a program of that name is on the PATH.
bool is_installed(const std::string& program);

/// Runs a program without input, and drops what it says.
/// \param words  its name, to be found on the PATH, and its arguments
/// \return  whether it ended with exit status 0
bool runs_well(std::vector<std::string> words);

/// Ends the program that runs_well() waits for, if there is one. For handlers of signals: calls only what they may.
void end_running_tool() noexcept;

/// A path of this process as another process reaches it: "/proc/self" is this one.
std::string seen_by_others(const std::string& path);

}  // namespace blysk
