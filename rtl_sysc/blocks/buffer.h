// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/qformat.h"

namespace blysk {

/// A control wire that enters a device and leaves it again, y_o = a_i.
///
/// Instances  buf29: strobe 17 leaves as output 29 of [P] fig. 1.
/// Timing     combinational.   Error  none.
struct buffer : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(a_i);
  sc_core::sc_out<bool> SC_NAMED(y_o);

  SC_CTOR(buffer) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("buffer", "Wire: y_o = a_i.");
    reader.drive(y_o, reader.read(a_i));
  }

 private:
  void eval() { y_o.write(a_i.read()); }
};

}  // namespace blysk
