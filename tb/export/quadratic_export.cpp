// SPDX-License-Identifier: Apache-2.0
// Compiled once for each named format, BLYSK_FORMAT.
#include "rtl_sysc/devices/quadratic.h"
#include "tb/export/export.h"

namespace blysk::verilog {

template <class Q, lobe Lobe>
files export_quadratic(const device_options& options);

template <>
files export_quadratic<BLYSK_FORMAT, lobe::clamped>(const device_options& options) {
  quadratic<quadratic_formats<BLYSK_FORMAT, lobe::clamped>> device("quadratic", wire_constants(options));
  return export_files(device, options);
}

template <>
files export_quadratic<BLYSK_FORMAT, lobe::as_published>(const device_options& options) {
  quadratic<quadratic_formats<BLYSK_FORMAT, lobe::as_published>> device("quadratic", wire_constants(options));
  return export_files(device, options);
}

}  // namespace blysk::verilog
