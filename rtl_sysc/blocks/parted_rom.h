// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

#include <array>
#include <cstddef>

namespace blysk {

/// Read-only memory as logic, filled at elaboration, in parts of 2^Place::frac words: y_o = the word at a_i of part part_i,
/// 0 where a_i is 1 or more, and beyond the last part.
///
/// Instances  rom1 of UA 71489.
/// Formats    part_i: Part unsigned, the upper address bits; a_i: Place unsigned, in [0, 1); y_o: Word.
/// \tparam Most  words of as many parts as there can be; `words` of them are there
/// Timing     combinational.   Error  that of the words.
template <class Part, class Place, class Word, std::size_t Most>
struct parted_rom : sc_core::sc_module {
  static_assert(Part::frac == 0 && !Place::is_signed);
  using memory = std::array<std::int64_t, Most>;

  sc_core::sc_in<typename Part::raw_t> SC_NAMED(part_i);
  sc_core::sc_in<typename Place::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename Word::raw_t> SC_NAMED(y_o);

  using SC_CURRENT_USER_MODULE = parted_rom;
  parted_rom(const sc_core::sc_module_name& name, const memory& all, std::size_t words)
      : sc_core::sc_module(name), all_(all), words_(words) {
    SC_METHOD(eval);
    sensitive << part_i << a_i;
  }

  template <class T>
  static constexpr T law(const memory& all, std::size_t words, T part, T place) {
    return law_of(all, words, part, place, Place::frac);
  }

  /// The same for any memory and number of address bits.
  template <class Memory, class T>
  static constexpr T law_of(const Memory& all, std::size_t words, T part, T place, int bits) {
    using law::lookup;
    using law::select;
    const T end = static_cast<T>(std::int64_t(1) << bits);
    return select(place < end, lookup(all, words, static_cast<T>((part << bits) + place)), static_cast<T>(0));
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("parted_rom",
                    "Read-only memory in parts: y_o = the word at a_i of part_i, 0 from a_i = 1 on.");
    const auto part = reader.read(part_i, Part{});
    reader.drive(y_o, law(all_, words_, part, reader.read(a_i, Place{})), Word{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(all_, words_, part_i.read().to_int64(), a_i.read().to_int64())); }

  const memory all_;
  const std::size_t words_;
};

}  // namespace blysk
