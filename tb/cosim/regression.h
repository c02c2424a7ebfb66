// SPDX-License-Identifier: Apache-2.0
/// What a mutant of an exported device meets.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "tb/device.h"

namespace blysk::cosim {

/// A single fault, as yosys lists it.
struct mutation {
  std::string block;  // instance in the device
  std::string place;  // port of its cell and wire there
  std::string what;
  // The outputs remain a function of what was written last: the fault sits at a cell of the datapath, or at the input or
  // the output of a data register.
  bool is_datapath;
  bool is_protocol;  // at a cell that valid_o or ready_o depend on
};

/// What the tests of a device do to its mutants.
class regression {
 public:
  virtual ~regression() = default;

  /// What may become of a mutant; the last two are "equivalent" and "alive".
  virtual std::span<const char* const> fates() const = 0;

  /// \param number  of the mutant, counted from 1 over all modules of mutants_table()
  /// \return        position in fates()
  virtual std::size_t run(unsigned number, const mutation& what) = 0;
};

/// Of a device that takes rows by start and ready.
/// \param own_rows   further rows that the device's tests send, none if empty
/// \param is_proved  whether the mutant with the number is proved to be the device, see mutants.sh
std::unique_ptr<regression> make_row_regression(const selection& asked, columns own_rows,
                                                std::function<bool(unsigned)> is_proved);

}  // namespace blysk::cosim
