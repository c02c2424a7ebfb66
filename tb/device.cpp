// SPDX-License-Identifier: Apache-2.0
#include "tb/device.h"

namespace blysk {

int fraction_bits(const device_options& options) {
  return visit_formats(options, []<class Q, lobe>() { return Q::frac; });
}

wired_constants wire_constants(const device_options& options) {
  const int bits =
      visit_formats(options, []<class Q, lobe Lobe>() { return quadratic_formats<Q, Lobe>::slope_bits; });
  wired_constants wired{};
  if (options.coefficient == "published") {
    wired = published_line(bits);
  } else if (options.coefficient == "derived") {
    wired = derived_line(bits);
  } else {
    throw std::invalid_argument("coefficient " + options.coefficient +
                                " cannot be wired, expected published or derived");
  }
  const std::string& constant = options.constant;
  if (!constant.empty()) {
    if (constant.front() != '1' || constant.find_first_not_of("01") != std::string::npos ||
        constant.size() > static_cast<std::size_t>(bits)) {
      throw std::invalid_argument("constant " + constant + " cannot be wired at node 31, expected 1 to " +
                                  std::to_string(bits) + " bits of 0 and 1, the first of them 1");
    }
    wired.slope = std::stoll(constant, nullptr, 2) << (bits - static_cast<int>(constant.size()));
  }
  return wired;
}

}  // namespace blysk
