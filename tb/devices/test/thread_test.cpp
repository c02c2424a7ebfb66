// SPDX-License-Identifier: Apache-2.0
// The devices as synthesis front-ends see them, registers as clocked threads: compiled with __SC_TOOL__, for BLYSK_FORMAT.
// This program brings the netlists of that format itself; those of the library, compiled without the macro, would be a
// second definition.
#include "tb/devices/per_format.cpp"  // NOLINT(bugprone-suspicious-include)

#include "tb/devices/test/asked.h"
#include "tb/devices/test/comparison.h"
#include "tb/harness/systemc_engine.h"

#ifndef __SC_TOOL__
#error "__SC_TOOL__ is not defined"
#endif

namespace blysk {

template <class Q>
std::vector<port> ports_in(const selection&) {
  throw std::logic_error("only one format is here");
}
template <class Q>
std::unique_ptr<netlist::elaborated> elaborate_in(const selection&, double) {
  throw std::logic_error("only one format is here");
}
// The registry asks for all formats; a table that others could see keeps them.
extern decltype(&ports_in<BLYSK_FORMAT>) const all_ports[];
decltype(&ports_in<BLYSK_FORMAT>) const all_ports[] = {
#define BLYSK_NAMED_FORMAT(name) &ports_in<name>,
#include "tb/formats.def"
#undef BLYSK_NAMED_FORMAT
};
extern decltype(&elaborate_in<BLYSK_FORMAT>) const all_elaborations[];
decltype(&elaborate_in<BLYSK_FORMAT>) const all_elaborations[] = {
#define BLYSK_NAMED_FORMAT(name) &elaborate_in<name>,
#include "tb/formats.def"
#undef BLYSK_NAMED_FORMAT
};

}  // namespace blysk

TEST_CASE("systemc of clocked threads = bit") {
  using namespace blysk;
  const selection asked = test::asked_for();
  auto systemc = harness::make_systemc(asked);
  int threads = 0;
  for (const sc_core::sc_object* part : sc_core::sc_get_top_level_objects()) {
    for (const sc_core::sc_object* block : part->get_child_objects()) {
      for (const sc_core::sc_object* process : block->get_child_objects())
        threads += std::string(process->kind()) == "sc_cthread_process" ? 1 : 0;
    }
  }
  REQUIRE(threads > 0);
  test::comparison compared(asked, std::move(systemc), asked.of().make_bit(asked));
  test::compare(compared, asked, 300'000);
}
