// SPDX-License-Identifier: Apache-2.0
/// Who writes a batch into a SystemC device and reads the results back, by the device's protocol.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "tb/columns.h"
#include "tb/netlist/elaborated.h"

namespace blysk::harness {

class host {
 public:
  virtual ~host() = default;

  /// As engine::run().
  virtual void run(const columns& in, columns& out) = 0;

  virtual std::uint64_t cycles() const = 0;  ///< of the clock, those of the reset included
  virtual std::uint64_t writes()
      const = 0;  ///< rows taken; with strobes also what confirms the last row of a run
};

/// Called when a row of the results has been read, with its number in the run.
using row_watcher = std::function<void(std::size_t)>;

/// A host for the device's protocol, as a SystemC module of its own. Before simulation starts.
/// \param clock_period_ns  of the device's clock
/// \throws std::logic_error for a device without a protocol
std::unique_ptr<host> make_host(const netlist::elaborated& device, double clock_period_ns,
                                row_watcher watcher = {});

}  // namespace blysk::harness
