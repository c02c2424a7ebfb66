// SPDX-License-Identifier: Apache-2.0
/// The main function of every program.
#pragma once

#include <functional>
#include <string_view>

namespace blysk {

/// One line "NAME: WHAT" of printable UTF-8 on standard error. The middle of more than 2000 bytes is left out. A standard
/// error that is full or closed changes nothing.
void say(std::string_view name, std::string_view what) noexcept;

/// Runs the body of a main function. What it throws becomes one line "NAME: what()" of printable UTF-8 on standard
/// error and the exit status 2, and so does a standard output that cannot be written to its end. A standard error that
/// is full or closed changes nothing of that.
///
/// Standard input, output and error that the caller closed fail when they are used; no file takes their number. A file
/// that grows beyond `ulimit -f` is an error like a full disk, and `ulimit -t` ends the program with SIGXCPU, which
/// takes unfinished files with it.
/// \return  the exit status: the body's, or 2
int run_program(std::string_view name, const std::function<int()>& body) noexcept;

}  // namespace blysk
