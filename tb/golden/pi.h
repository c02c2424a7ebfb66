// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/math/constants/constants.hpp>

namespace blysk::golden {

/// pi in any number type: Boost has it for those that it knows, others specialise this.
template <class Real>
Real pi() {
  return boost::math::constants::pi<Real>();
}

}  // namespace blysk::golden
