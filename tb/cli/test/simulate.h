// SPDX-License-Identifier: Apache-2.0
/// `blysk simulate` as tests call it.
#pragma once

#include <string>

#include "tb/cli/test/program.h"

inline std::string simulate(const std::string& in, const std::string& out, const std::string& more = "") {
  return "simulate --stimulus " + quoted(in) + " --results " + quoted(out) + " " + more;
}

inline const std::string kGood =
    "n,cos,r,g,b\n1,0,255,0,1\n10,0.99,200,100,50\n1000,1,255,255,255\n50,0.5,3,2,1\n";
