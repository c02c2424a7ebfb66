// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

#include <array>
#include <cstddef>

namespace blysk {

/// Read-only memory as logic, filled at elaboration: y_o = words[a_i], 0 beyond their end.
///
/// Instances  rom2 of UA 71489.
/// Formats    a_i: Index unsigned, y_o: Word.
/// \tparam Words  how many there are
/// Timing     combinational.   Error  that of the words.
template <class Index, class Word, std::size_t Words>
struct filled_rom : sc_core::sc_module {
  using memory = std::array<std::int64_t, Words>;

  sc_core::sc_in<typename Index::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename Word::raw_t> SC_NAMED(y_o);

  using SC_CURRENT_USER_MODULE = filled_rom;
  filled_rom(const sc_core::sc_module_name& name, const memory& words)
      : sc_core::sc_module(name), words_(words) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class T>
  static constexpr T law(const memory& words, T address) {
    using law::lookup;
    return lookup(words, address);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("filled_rom", "Read-only memory: y_o = the word at a_i, 0 beyond the last one.");
    reader.drive(y_o, law(words_, reader.read(a_i, Index{})), Word{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(words_, a_i.read().to_int64())); }

  const memory words_;
};

}  // namespace blysk
