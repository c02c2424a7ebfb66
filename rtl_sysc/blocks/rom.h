// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "rtl_sysc/blocks/clocked.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/qformat.h"

namespace blysk {

/// Read-only memory as logic: y_o = contents[a_i], 0 beyond its end.
///
/// Instances  rom6 of the prototype UA 22802, in the place of multiplier 6 and adder 15 of [P] fig. 1; rom33 and rom9 of
///            [T] fig. 3.1.
/// Formats    a_i: Index unsigned, y_o: Word.
/// \tparam Contents  has a static constexpr array `words` of arrays of std::int64_t, raw words; the constructor's `which`
///                   chooses among them, from 0
/// Timing     combinational.   Error  that of the words.
template <class Index, class Word, class Contents>
struct rom : sc_core::sc_module {
  sc_core::sc_in<typename Index::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename Word::raw_t> SC_NAMED(y_o);

  using SC_CURRENT_USER_MODULE = rom;  // what SC_METHOD asks for; SystemC 3 deprecates SC_HAS_PROCESS
  rom(const sc_core::sc_module_name& name, int which) : sc_core::sc_module(name), which_(which) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class T>
  static constexpr T law(int which, T address) {
    using law::lookup;
    return lookup(Contents::words[static_cast<std::size_t>(which)], address);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("rom", "Read-only memory: y_o = the word at a_i, 0 beyond the last one.");
    reader.drive(y_o, law(which_, reader.read(a_i, Index{})), Word{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(which_, a_i.read().to_int64())); }

  const int which_;
};

/// Read-only memory with a register at its output, which synthesis tools map to a block RAM: at each rising edge of clk
/// y_o = contents[a_i], 0 beyond its end.
///
/// Instances, formats and contents are those of rom.
/// Timing     y_o changes after the rising edge of clk.   Reset  rst_n low at a rising edge of clk: 0.
template <class Index, class Word, class Contents>
struct rom_clocked : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<typename Index::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<typename Word::raw_t> SC_NAMED(y_o);

  using SC_CURRENT_USER_MODULE = rom_clocked;
  rom_clocked(const sc_core::sc_module_name& name, int which) : sc_core::sc_module(name), which_(which) {
    BLYSK_CLOCKED(load);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("rom_clocked",
                    "Read-only memory: y_o = the word at a_i, 0 beyond the last one, after clk.");
    const auto word = rom<Index, Word, Contents>::law(which_, reader.read(a_i, Index{}));
    reader.reg(clk, rst_n, reader.constant(1), word, y_o, Word{});
  }

 private:
  BLYSK_CLOCKED_BODY(load)
  void load() {
    if (!rst_n.read()) {
      y_o.write(0);
    } else {
      y_o.write(rom<Index, Word, Contents>::template law<std::int64_t>(which_, a_i.read().to_int64()));
    }
  }

  const int which_;
};

}  // namespace blysk
