// SPDX-License-Identifier: Apache-2.0
// Compiled once for each named format, BLYSK_FORMAT.
#include "rtl_sysc/devices/quadratic.h"
#include "tb/export/export.h"

namespace blysk::verilog {

template <>
std::unique_ptr<model> make_model<devices::quadratic, BLYSK_FORMAT>(const device_options& options) {
  const std::string words = "coefficient " + options.coefficient +
                            (options.constant.empty() ? "" : ", constant 0." + options.constant + "b") +
                            (options.as_published ? ", BRDF as published" : ", BRDF clamped to [0, 1]");
  const auto make = [&]<lobe Lobe>() {
    using device = quadratic<quadratic_formats<BLYSK_FORMAT, Lobe>>;
    return std::make_unique<model>(std::make_unique<device>("quadratic", wire_constants(options)), words);
  };
  return options.as_published ? make.template operator()<lobe::as_published>()
                              : make.template operator()<lobe::clamped>();
}

}  // namespace blysk::verilog
