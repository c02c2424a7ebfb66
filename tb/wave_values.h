// SPDX-License-Identifier: Apache-2.0
/// What the wires of a device stand for, as real numbers in its waves: every viewer draws them, without a layout.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tb/columns.h"
#include "tb/engine.h"
#include "tb/port.h"

namespace blysk {

/// Scope of the values below the top of a waveform: "SystemC.values.brdf_real", "TOP.values.brdf_real".
inline constexpr const char* kValueScope = "values";

/// The device minus its formula.
inline constexpr const char* kErrorName = "error_real";

/// Name of a port's value, "brdf_real" of the column brdf. Empty for ports without one: what carries no number, and
/// integers of the stimulus.
std::string value_name(const port& of);

/// Position of the port that kErrorName is of: the net brdf, or the first result of a device that reports none.
/// \throws std::logic_error for a device without results
std::size_t error_port(const std::vector<port>& ports);

/// The values of a device's ports: code times 2^-fraction bits, in double; and its error.
///
/// The formula sees the rows that the device has taken, by the protocol of its ports: what its registers hold, or what came
/// with `start`. The error is 0 while there is nothing to compare: before every register holds a legal code, and while
/// `valid` of a device with `start` is at zero.
class wave_values {
 public:
  /// \param golden  the device's formula at the codes of its inputs, results in the order of the ports
  wave_values(const std::vector<port>& ports, std::unique_ptr<engine> golden);

  /// In the order of the ports; the error is last.
  const std::vector<std::string>& names() const { return names_; }

  /// The clock rises.
  /// \param levels  what each port carries before that
  void rise(std::span<const std::int64_t> levels);

  /// The values, in the order of names().
  /// \param levels  what each port carries
  std::span<const double> at(std::span<const std::int64_t> levels);

 private:
  /// A port with a value.
  struct number {
    std::size_t port;
    double ulp;
  };

  /// A data port, and what its register holds.
  struct data_register {
    std::size_t port;
    std::size_t strobe;  ///< of a device with strobes
    wire_format carries;
    std::int64_t held = 0;
    bool was_up = false;  ///< the strobe
  };

  void load(std::span<const std::int64_t> levels);
  void evaluate();

  std::vector<port> ports_;
  protocol talks_;
  std::unique_ptr<engine> golden_;
  std::vector<std::string> names_;
  std::vector<number> numbers_;
  std::vector<data_register> registers_;
  std::size_t reset_ = 0, start_ = 0, ready_ = 0, valid_ = 0;
  std::size_t error_column_ = 0;  ///< of the results
  number error_{};
  columns row_, formula_;
  std::deque<double>
      expected_;  ///< what the formula gives for the rows of results to come, the next one first
  std::vector<double> values_;
};

}  // namespace blysk
