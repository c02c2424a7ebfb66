// SPDX-License-Identifier: Apache-2.0
/// What all ways of computing a device have in common: a batch of writes and their results.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace blysk {

/// Writes to a device's registers, element i of each array is write i; all arrays have the same length.
struct batch {
  std::vector<std::uint16_t> n;                         ///< UQ10.0, 1..1000
  std::vector<std::uint32_t> cos_delta;                 ///< UQ1.f, 0..2^f
  std::vector<std::uint8_t> red_ks, green_ks, blue_ks;  ///< UQ8.0

  std::size_t size() const { return n.size(); }
  void resize(std::size_t rows) {
    n.resize(rows);
    cos_delta.resize(rows);
    red_ks.resize(rows);
    green_ks.resize(rows);
    blue_ks.resize(rows);
  }
};

/// What the device computed, as raw integers: SQ8.f for brdf, SQ16.f for colours (they fit UQ1.f and UQ8.f unless
/// as_published).
struct results {
  std::vector<std::int64_t> brdf, red, green, blue;

  std::size_t size() const { return brdf.size(); }
  void resize(std::size_t rows) {
    brdf.resize(rows);
    red.resize(rows);
    green.resize(rows);
    blue.resize(rows);
  }

  friend bool operator==(const results&, const results&) = default;
};

/// One way to compute a device on integers. Results come in the order of the writes.
class engine {
 public:
  virtual ~engine() = default;

  /// Computes out[i] from in[i] for all i; resizes out. Values outside the formats' legal ranges are not checked.
  virtual void run(const batch& in, results& out) = 0;
};

/// An engine with a clock.
class clocked_engine : public engine {
 public:
  /// Clock cycles simulated so far, those of the reset included.
  virtual std::uint64_t cycles() const = 0;

  /// Writes to register 2 so far, the confirming ones at the end of each run() included.
  virtual std::uint64_t writes() const = 0;
};

}  // namespace blysk
