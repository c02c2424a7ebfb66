// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace blysk::harness {

/// What the signals of a waveform carry over time.
class wave_changes {
 public:
  /// Reads a VCD file, all of it.
  /// \throws usage_error if it cannot be read, or is not whole
  explicit wave_changes(const std::string& vcd);

  /// The comment in its head, a line each.
  const std::vector<std::string>& comment() const { return comment_; }

  /// The value of a signal, in the words of the file without their first letter: "0", "101", "0.25".
  /// \param name  with its scopes, "SystemC.rg1.q_o"
  /// \param time  in units of the file's timescale; what changes at that time has changed
  /// \throws std::invalid_argument if there is no such signal, or it has no value yet
  const std::string& at(const std::string& name, std::uint64_t time) const;

 private:
  using values = std::map<std::uint64_t, std::string>;  // by the time from which on they hold

  std::vector<std::string> comment_;
  std::map<std::string, std::string> codes_;  // by name
  std::map<std::string, values> changes_;     // by code
};

}  // namespace blysk::harness
