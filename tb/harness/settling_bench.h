// SPDX-License-Identifier: Apache-2.0
/// A device with the delays of its blocks under strobes whose gap is chosen write by write.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tb/delays.h"
#include "tb/device.h"

namespace blysk::harness {

/// Codes of the data ports, in their order.
using write_codes = std::vector<std::int64_t>;

/// How the outputs settled after a write, ps after the clock edge that loaded the registers.
struct settled_write {
  std::uint64_t after = 0;     ///< the last change of an output
  std::uint64_t busy_for = 0;  ///< until none could change any more
  std::string output;          ///< that changed last, as waveforms call it; empty if none did
  int bit = 0;                 ///< the highest that changed then
};

/// SystemC elaborates once: a process makes one, and nothing else that simulates.
class settling_bench {
 public:
  /// \throws std::invalid_argument for a device without strobes, or whose nets take no delays
  settling_bench(const selection& asked, device_delays delays);
  ~settling_bench();
  settling_bench(const settling_bench&) = delete;
  settling_bench& operator=(const settling_bench&) = delete;

  /// Writes by the strobes and waits until nothing changes any more.
  settled_write write(const write_codes& codes);

  /// Writes, raises the strobe `gap_ps` after the clock edge that loaded the registers, and reads the outputs at the leading
  /// edge of the valid port. Then waits until nothing changes any more.
  /// \return  the results that have a port, in their order
  std::vector<std::int64_t> read_after(const write_codes& codes, std::uint64_t gap_ps);

  /// The outputs now.
  std::vector<std::int64_t> outputs() const;

  /// Writes so far.
  std::uint64_t writes() const;

 private:
  class driver;
  std::unique_ptr<driver> driver_;
};

}  // namespace blysk::harness
