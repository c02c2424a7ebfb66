// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/qformat.h"

namespace blysk {

/// Constant node: wires tied to logic one and zero, y_o = raw.
///
/// Instances  node31 (slope), node32 (offset), carry28 (1), carry30 (0) of [P] fig. 1.
/// Formats    y_o: Q; raw is the integer on the wires.
/// Timing     none.   Error  none.
template <class Q>
struct constant : sc_core::sc_module {
  sc_core::sc_out<typename Q::raw_t> SC_NAMED(y_o);

  using SC_CURRENT_USER_MODULE = constant;  // what SC_METHOD asks for; SystemC 3 deprecates SC_HAS_PROCESS
  constant(const sc_core::sc_module_name& name, std::int64_t raw) : sc_core::sc_module(name), raw_(raw) {
    SC_METHOD(eval);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("constant", "Constant: y_o = RAW, the integer on the wires.");
    reader.drive(y_o, reader.parameter("RAW", raw_, Q{}), Q{});
  }

 private:
  void eval() { y_o.write(raw_); }

  const std::int64_t raw_;
};

}  // namespace blysk
