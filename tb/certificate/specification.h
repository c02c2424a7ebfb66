// SPDX-License-Identifier: Apache-2.0
/// What is exact in a device, and what Gappa has to be told of it: the files tb/devices/<identifier>/certificate*.
///
/// {F+4}, {2F+1} and {F/2-1} stand for that number, F the fraction bits of cos(delta), and {#F+2} for the bits that F + 2 has as
/// an integer. Lines that begin with # are comments.
///   let NAME = EXPRESSION                  of the inputs' nets, and of numbers that facts give
///   fact FORMULA                           given
///   memory NET ~ NAME within W [from N]    the words differ from what NAME is by at most W last places, from address N on, up
///                                          to the next such line; proved for each address: the expression of NAME taken there,
///                                          or, without one, the number that `number` says
///   number NAME = FUNCTION                 of the address, in 50 digits: one of numbers_of() in tb/certificate/curves.h
///   words EXPRESSION >= 0                  of memories of one address; proved for each address, then given
///   curve B + C * P ~ NAME = FUNCTION from X over LENGTH, half B
///                                          lines: B and C words of memories, P the place in a segment; NAME is the FUNCTION, one of
///                                          curves.h, where the line stands for it: over LENGTH in all, from X on. B has the
///                                          constant `half` more, for a cut to be a rounding. With ", relative" at the end the
///                                          relative error is told too
///   groups NET N1 N2 ... [where CONDITION] the addresses from 0, N1, N2, ... on are told apart; on a way with the condition
///                                          alone, if there is one. x/y stands for that part of the addresses. Groups of two
///                                          nets on one way: each of the one with each of the other
///   claim FORMULA                          proved of the formula, then given
///   case NAME >= 0: VALUE [if FORMULA]     the exact BRDF there; if it is that where a formula holds, this is proved too
///   case NAME <= 0: VALUE [if FORMULA]
///   where CONDITION: VALUE [if FORMULA]    the exact BRDF on a way through the netlist with this condition; the same
///   hint EXPRESSION -> EXPRESSION          a rewriting rule; Gappa proves it
///   split WHAT                             cases that Gappa tries one by one
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace blysk {

using named_texts = std::vector<std::pair<std::string, std::string>>;

struct memory_claim {
  std::string net, name, within;
  std::size_t from = 0;  ///< address
};

struct curve_claim {
  std::string begin, change, place, name, function, from, length, half;
  bool is_relative = false;
};

struct address_groups {
  std::string net;
  std::vector<std::string> firsts;  ///< of the second group and so on
  std::string condition;            ///< empty: on every way
};

struct exact_case {
  std::string condition, value, if_formula;
};

struct specification {
  named_texts lets, numbers;
  std::vector<std::string> facts, claims, hints, splits, words;
  std::vector<memory_claim> memories;
  std::vector<curve_claim> curves;
  std::vector<address_groups> groups;
  std::vector<exact_case> cases, ways;
};

/// \param fraction  F
/// \throws usage_error for a line that is none of these, and for other cases than NAME >= 0 and NAME <= 0
specification read_specification(const std::string& path, int fraction);

}  // namespace blysk
