// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <string>

class VerilatedVcdC;

namespace blysk::cosim {

/// Waves of a Verilated class as a VCD file, timescale 1 ps. Verilator leaves out what the disk does not take without a
/// word; here it is noticed.
class recording {
 public:
  /// \param comment  for the head of the file
  recording(std::string path, const std::string& comment);
  ~recording();
  recording(const recording&) = delete;
  recording& operator=(const recording&) = delete;

  /// For the class's trace(), before open().
  VerilatedVcdC& waves() { return *waves_; }

  void open();

  /// Records the state as it is, for half a clock period from now on.
  void sample();

  bool is_empty() const { return time_ps_ == 0; }

  /// Ends the file.
  /// \return  whether all of it was written
  bool close();

 private:
  class file;

  std::string path_;
  std::unique_ptr<file> file_;  // before waves_, which writes to it to its end
  std::unique_ptr<VerilatedVcdC> waves_;
  std::uint64_t time_ps_ = 0;
};

}  // namespace blysk::cosim
