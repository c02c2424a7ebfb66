// SPDX-License-Identifier: Apache-2.0
/// What all ways of computing a device have in common.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "tb/columns.h"

namespace blysk {

/// One way to compute a device. Results come in the order of the writes.
class engine {
 public:
  virtual ~engine() = default;

  /// Computes row i of `out` from row i of `in` for all i, or, for a device that delivers any number of rows, their rows one
  /// after the other. Codes outside the formats' legal ranges are not checked.
  /// \param in   a column for each data port, of the storage of its format
  /// \param out  becomes a column for each result; what it holds keeps its memory
  void run(const columns& in, columns& out) {
    if (!out.has_layout(results_)) out = columns(results_);
    out.resize(in.size());
    compute(in, out);
  }

 protected:
  /// \param results  storage of the results: that of their formats, or f64 for a formula
  explicit engine(std::vector<storage> results) : results_(std::move(results)) {}

 private:
  virtual void compute(const columns& in, columns& out) = 0;

  std::vector<storage> results_;
};

/// What a device needs before its first row.
inline constexpr std::uint64_t kResetCycles = 2;

/// After so many clock cycles in which it takes no row and does not come to its end an engine gives a device up.
inline constexpr std::uint64_t kPatienceCycles = 1 << 16;

/// An engine with a clock.
class clocked_engine : public engine {
 public:
  /// Clock cycles simulated so far, those of the reset included.
  virtual std::uint64_t cycles() const = 0;

  /// Rows that the device has taken; with strobes, the confirming write at the end of each run() counts as one.
  virtual std::uint64_t writes() const = 0;

 protected:
  using engine::engine;
};

/// An engine whose signals can be recorded.
class recorded_engine : public clocked_engine {
 public:
  /// Records the waves from now on in a VCD file, timescale 1 ps. Before the first run.
  /// \param path  ends with .vcd
  /// \throws std::logic_error if the engine was made without waves
  virtual void trace(const std::string& path) = 0;

  /// Ends the record and closes its file.
  /// \return  whether all of it is in the file, as far as can be known
  virtual bool stop_trace() = 0;

 protected:
  using clocked_engine::clocked_engine;
};

}  // namespace blysk
