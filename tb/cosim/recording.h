// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "tb/wave_values.h"

class VerilatedVcdC;

namespace blysk::cosim {

/// Waves of a Verilated class as a VCD file, timescale 1 ps, and the values of its ports beside them, TOP.values.*.
/// Verilator leaves out what the disk does not take without a word; here it is noticed.
class recording {
 public:
  /// \param comment  for the head of the file
  /// \param clock    position of the clock in device::ports()
  recording(std::string path, const std::string& comment, std::size_t clock, wave_values values);
  ~recording();
  recording(const recording&) = delete;
  recording& operator=(const recording&) = delete;

  /// For the class's trace(), before open().
  VerilatedVcdC& waves() { return *waves_; }

  void open();

  /// Records the state as it is, for half a clock period from now on.
  /// \param levels  what each port carries, in the order of device::ports()
  void sample(std::span<const std::int64_t> levels);

  bool is_empty() const { return time_ps_ == 0; }

  /// Ends the file.
  /// \return  whether all of it was written
  bool close();

 private:
  class file;

  void write_values(std::span<const std::int64_t> levels);

  std::string path_;
  std::unique_ptr<file> file_;  // before waves_, which writes to it to its end
  std::unique_ptr<VerilatedVcdC> waves_;
  std::uint64_t time_ps_ = 0;
  std::size_t clock_;
  wave_values values_;
  std::vector<std::int64_t> before_;  // the levels of the sample before
  std::vector<double> written_;       // empty before the first sample
};

}  // namespace blysk::cosim
