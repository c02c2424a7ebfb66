// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Control of a device that takes its inputs into registers and then finds the digits of a result, one each clock cycle: a
/// counter of the digits that are left.
///
/// Instances  control of iterative devices.
/// Ports      take_o = start_i while no digit is left; first_o is one in the cycle that finds the first digit, the one after
///            take_o; step_o in each cycle that finds a digit, the first one too; ready_o while none is left; done_o in the
///            cycle after the last digit.
/// \tparam Digits  1 or more
/// Timing     take_o follows start_i; the others change after the rising edge of clk.   Reset  ready, no digit left.
template <int Digits>
struct digit_control : sc_core::sc_module {
  using count = uq<7, 0>;
  static_assert(1 <= Digits && Digits <= count::max);

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(start_i);
  sc_core::sc_out<bool> SC_NAMED(take_o);
  sc_core::sc_out<bool> SC_NAMED(first_o);
  sc_core::sc_out<bool> SC_NAMED(step_o);
  sc_core::sc_out<bool> SC_NAMED(ready_o);
  sc_core::sc_out<bool> SC_NAMED(done_o);

  SC_CTOR(digit_control) {
    BLYSK_CLOCKED(count_digits);
    SC_METHOD(decode);
    sensitive << start_i << left;
  }

  /// 1 while all digits are left.
  template <class T>
  static constexpr T is_first(T now) {
    return static_cast<T>(now == static_cast<T>(Digits));
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("digit_control", "Control: takes the inputs, then counts the digits of a result.",
                    Digits);
    const auto start = reader.read(start_i);
    const auto now = reader.read(left);
    reader.reg(clk, rst_n, reader.constant(1), law::count_down(start, reader.constant(Digits), now), left,
               count{});
    reader.reg(clk, rst_n, reader.constant(1), law::is_last(now), done_o);
    reader.drive(take_o, law::starts(start, now));
    reader.drive(first_o, is_first(now));
    reader.drive(step_o, law::is_active(now));
    reader.drive(ready_o, law::is_idle(now));
  }

 private:
  BLYSK_CLOCKED_BODY(count_digits)
  void count_digits() {
    if (!rst_n.read()) {
      left.write(0);
      done_o.write(false);
    } else {
      const std::int64_t now = left.read().to_int64();
      left.write(law::count_down<std::int64_t>(start_i.read() ? 1 : 0, Digits, now));
      done_o.write(law::is_last(now) != 0);
    }
  }
  void decode() {
    const std::int64_t now = left.read().to_int64();
    take_o.write(law::starts<std::int64_t>(start_i.read() ? 1 : 0, now) != 0);
    first_o.write(is_first(now) != 0);
    step_o.write(law::is_active(now) != 0);
    ready_o.write(law::is_idle(now) != 0);
  }

  sc_core::sc_signal<typename count::raw_t> SC_NAMED(left);
};

}  // namespace blysk
