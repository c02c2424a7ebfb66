// SPDX-License-Identifier: Apache-2.0
/// The datapath of a device as definitions for Gappa, read from its netlist.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tb/netlist/elaborated.h"

namespace blysk::netlist {

/// What is made wrong in the netlist as it is read, so that a proof can be seen to fail.
enum class planted_fault {
  none,
  no_rounding,   ///< roundings drop their bits
  narrow_words,  ///< wired constants and words of memories lose their two lowest bits
};

/// A net that a memory drives.
struct memory_net {
  std::string net, index;           ///< the net, and the one that addresses it
  int frac;                         ///< fraction bits of the net
  std::vector<std::int64_t> words;  ///< raw, by address
};

/// A net that a normaliser drives, with 2^frac of its input 1: its mantissa or the number of zeros.
struct normalised_net {
  std::string net, from;
  int frac;
  bool is_mantissa;
};

/// One way through the selections of the datapath, with the nets that it asks for.
struct gappa_path {
  std::vector<std::string>
      definitions;  ///< "cos2 = cos_delta * cos_delta;" in the order of data, real numbers by net
  std::vector<std::string> conditions;  ///< "brdf_1 >= 0": what makes the selections choose this way
  std::vector<std::string> hints;       ///< rewriting rules of the roundings
  std::vector<std::string> facts;       ///< the legal codes of the inputs, "cos_i_code in [0, 256]"
};

struct gappa_netlist {
  std::vector<memory_net> memories;
  std::vector<normalised_net> normalised;
  std::vector<gappa_path> paths;
};

/// The path from the device's data ports to a net, each net a real number by its format, registers transparent: laws are
/// taken at the netlist's own formats, a right shift as a rounding down to the last place that is kept.
///
/// floor((floor(x) + k) / 2^d) is taken as floor((x + k) / 2^d), k an integer; both are equal. Nets are taken not to wrap,
/// what no_overflow() of the device's formats excludes for legal inputs. Dividers, normalisers and barrel shifters have laws
/// of many selections. They are taken as what they say of themselves, what their own tests show: the quotient, rounded down;
/// a_i = m_o 2^(-zeros_o - 1), of which both are free numbers; and a way for each number of places, floor(floor(x) / 2^d)
/// being floor(x / 2^d).
/// \param result  name of the net
/// \throws std::logic_error for a law that cannot be told to Gappa
gappa_netlist read_gappa(const elaborated& device, const std::string& result, planted_fault fault);

}  // namespace blysk::netlist
