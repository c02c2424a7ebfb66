// SPDX-License-Identifier: Apache-2.0
/// Runs of SystemC's processes, which its kernel does not count.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace blysk::harness {

/// Counts the runs of the methods of a simulation from outside: blocks, hosts and clocks are as they are without it.
///
/// After each update phase it looks which signals have changed. What is sensitive to one of them runs once in the next
/// evaluation phase, whatever the number of its signals. A clock changes by a run of a process of its own. Methods without
/// dont_initialize() run once at the start.
/// It looks at signals of bool, sc_uint and sc_int, and knows static sensitivities only. A signal that is bound to an output of
/// a module is looked at when a process of this module has run, all others always: those that hosts and clocks drive.
/// While it exists the simulation takes longer; without it, nothing is different.
class process_counter {
 public:
  /// Before the simulation starts; it counts from its start on. No signal is to be written before.
  process_counter();
  ~process_counter();

  /// Of all processes.
  /// \throws std::logic_error at the simulation's start for a thread, and for a method that waits for anything but a signal
  std::uint64_t runs() const;

  /// Of one, by its name in SystemC, "host.drive".
  /// \throws std::out_of_range if there is none
  std::uint64_t runs(const std::string& process) const;

  /// To look at every signal after every update phase: slower, for tests.
  void look_at_all();

 private:
  class watch;
  std::unique_ptr<watch> watch_;
};

}  // namespace blysk::harness
