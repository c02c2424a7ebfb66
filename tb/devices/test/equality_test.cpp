// SPDX-License-Identifier: Apache-2.0
// The bit-accurate model of a device against its hardware. One process per case: SystemC elaborates once.
#include "tb/devices/test/asked.h"
#include "tb/devices/test/comparison.h"
#include "tb/harness/systemc_engine.h"

namespace {

using namespace blysk;
using test::asked_for;

constexpr std::uint64_t kSimulated = 1'100'000;  // all inputs of q10, about two seconds

/// What the device's tests.cmake says, or kSimulated.
std::uint64_t simulated() {
  const char* const asked = std::getenv("BLYSK_SIMULATED");
  return asked == nullptr || *asked == '\0' ? kSimulated : std::stoull(asked);
}

}  // namespace

TEST_CASE("systemc = bit", "[variants]") {
  const selection asked = asked_for();
  test::comparison compared(asked, harness::make_systemc(asked), asked.of().make_bit(asked));
  test::compare(compared, asked, simulated());
}

TEST_CASE("word lengths of the format = bit", "[variants]") {
  const selection asked = asked_for();
  const device& tested = asked.of();
  test::comparison compared(asked, tested.make_bit(asked, tested.widths(asked)), tested.make_bit(asked));
  test::compare(compared, asked, kSimulated);
}

TEST_CASE("wrong word lengths are refused") {
  const selection asked = asked_for();
  const device& tested = asked.of();
  const word_lengths right = tested.widths(asked);
  const auto message = [&](const word_lengths& bits) -> std::string {
    try {
      tested.make_bit(asked, bits);
    } catch (const std::invalid_argument& refusal) {
      return refusal.what();
    }
    return "";
  };
  CHECK(message(right).empty());
  word_lengths wrong = right;
  wrong["nosuch"] = 8;
  CHECK(test::is_line_with(message(wrong), "nosuch"));
  for (const auto& [name, bits] : right) {
    CAPTURE(name, bits);
    for (const int each : {-1, 0, 64}) {
      wrong = right;
      wrong[name] = each;
      CHECK(test::is_line_with(message(wrong), name + " " + std::to_string(each)));
      CHECK(test::is_line_with(message(wrong), "expected"));
    }
    wrong = right;
    wrong.erase(name);
    CHECK(test::is_line_with(message(wrong), name));
  }
}
