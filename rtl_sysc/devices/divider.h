// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/pin.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// What devices that divide a difference of intensities by a run length share: their ports.
/// \tparam Formats  has difference, length and increment
template <class Formats>
struct divider : sc_core::sc_module {
  template <class Q>
  using net = sc_core::sc_signal<typename Q::raw_t>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<typename Formats::difference::raw_t> SC_NAMED(difference_i);
  sc_core::sc_in<typename Formats::length::raw_t> SC_NAMED(length_i);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_out<bool> SC_NAMED(ready_o);
  sc_core::sc_out<typename Formats::increment::raw_t> SC_NAMED(increment_o);
  sc_core::sc_out<bool> SC_NAMED(valid_o);

  explicit divider(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {}

  /// The ports and what they are for; no figure gives them numbers.
  template <class Reader>
  static void pins(Reader& reader) {
    using d = divider;
    reader.clock(&d::clk, {"clk", "", "clk", "clock"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "synchronous, active low"});
    reader.data(&d::difference_i,
                {"difference_i", "", "difference", "difference of the intensities at the ends"},
                typename Formats::difference{}, "difference");
    reader.data(&d::length_i, {"length_i", "", "length", "pixels between the ends"},
                typename Formats::length{}, "length");
    reader.start(&d::start_i, {"start_i", "", "start", "takes the inputs while ready_o is one"});
    reader.ready(&d::ready_o, {"ready_o", "", "ready", "start_i takes the inputs"});
    reader.result(&d::increment_o, {"increment_o", "", "increment", "difference / length"},
                  typename Formats::increment{}, "increment");
    reader.valid(&d::valid_o, {"valid_o", "", "valid", "increment_o is valid"});
  }
};

}  // namespace blysk
