// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Decoder of the exponent: part_o = n_i below FIRST, else 0, the upper bits of a memory's address.
///
/// Instances  dec of UA 71489, whose four outputs are the four highest address bits of ROM 1. FIRST is k of [A], so that
///            an exponent below k has a part of its own, which holds cos^n itself.
/// Formats    n_i: N unsigned, part_o: Part unsigned; FIRST is in 1..2^Part::width.
/// Timing     combinational.   Error  none.
template <class N, class Part>
struct part_decoder : sc_core::sc_module {
  using first_number = uq<Part::width + 1, 0>;
  static_assert(N::frac == 0 && Part::frac == 0 && first_number::width <= N::width);

  sc_core::sc_in<typename N::raw_t> SC_NAMED(n_i);
  sc_core::sc_out<typename Part::raw_t> SC_NAMED(part_o);

  using SC_CURRENT_USER_MODULE = part_decoder;
  part_decoder(const sc_core::sc_module_name& name, std::int64_t first)
      : sc_core::sc_module(name), first_(first) {
    SC_METHOD(eval);
    sensitive << n_i;
  }

  template <class T>
  static constexpr T law(T n, T first) {
    using law::select;
    return select(n < first, n, static_cast<T>(0));
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("part_decoder", "Decoder: part_o = n_i below FIRST, else 0.");
    reader.drive(part_o, law(reader.read(n_i, N{}), reader.parameter("FIRST", first_, first_number{})),
                 Part{});
  }

 private:
  void eval() { part_o.write(law<std::int64_t>(n_i.read().to_int64(), first_)); }

  const std::int64_t first_;
};

}  // namespace blysk
