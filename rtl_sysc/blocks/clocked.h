// SPDX-License-Identifier: Apache-2.0
/// The process of a register: a member function that runs at each rising edge of the port clk.
///
///     BLYSK_CLOCKED(load);        in the constructor
///     BLYSK_CLOCKED_BODY(load)    among the private members, before load() itself
///
/// Simulation runs it as a method, which takes no coroutine and is 18 % faster. Synthesis front-ends, which define
/// __SC_TOOL__, want a clocked thread around the same body.
#pragma once

#include <systemc>

#ifdef __SC_TOOL__
#define BLYSK_CLOCKED(body) SC_CTHREAD(body##_forever, clk.pos())
#define BLYSK_CLOCKED_BODY(body) \
  void body##_forever() {        \
    while (true) {               \
      body();                    \
      wait();                    \
    }                            \
  }
#else
#define BLYSK_CLOCKED(body) \
  SC_METHOD(body);          \
  sensitive << clk.pos();   \
  dont_initialize()
#define BLYSK_CLOCKED_BODY(body)
#endif
