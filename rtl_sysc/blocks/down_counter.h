// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Counter that is loaded and counts down.
///
/// Instances  cnt of UA 71489: the pixels of a scan line.
/// Formats    d_i: Q unsigned. carry_o is one while 1 or 0 is left.
/// Timing     at a rising edge of clk: while load_i is one it takes d_i; else, while count_i is one, it goes down by one,
///            to 0.
/// Reset      rst_n low at a rising edge of clk: 0.
template <class Q>
struct down_counter : sc_core::sc_module {
  static_assert(!Q::is_signed && Q::frac == 0);

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(load_i);
  sc_core::sc_in<bool> SC_NAMED(count_i);
  sc_core::sc_in<typename Q::raw_t> SC_NAMED(d_i);
  sc_core::sc_out<bool> SC_NAMED(carry_o);

  SC_CTOR(down_counter) {
    BLYSK_CLOCKED(count);
    SC_METHOD(decode);
    sensitive << left;
  }

  /// What the counter takes.
  template <class T>
  static constexpr T next(T load, T d, T q) {
    using law::select;
    return select(load, d, law::one_less(q));
  }
  template <class T>
  static constexpr T is_end(T q) {
    return static_cast<T>(q < static_cast<T>(2));
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("down_counter",
                    "Counter: takes d_i while load_i is one, else goes down while count_i is.");
    const auto load = reader.read(load_i);
    const auto q = reader.read(left);
    reader.reg(clk, rst_n, load || reader.read(count_i), next(load, reader.read(d_i, Q{}), q), left, Q{});
    reader.drive(carry_o, is_end(q));
  }

 private:
  BLYSK_CLOCKED_BODY(count)
  void count() {
    if (!rst_n.read()) {
      left.write(0);
    } else if (load_i.read() || count_i.read()) {
      left.write(next<std::int64_t>(load_i.read() ? 1 : 0, d_i.read().to_int64(), left.read().to_int64()));
    }
  }
  void decode() { carry_o.write(is_end(left.read().to_int64()) != 0); }

  sc_core::sc_signal<typename Q::raw_t> SC_NAMED(left);
};

}  // namespace blysk
