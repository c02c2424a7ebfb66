// SPDX-License-Identifier: Apache-2.0
// Columns and ports: the words that all rooms share.
#include <limits>
#include <type_traits>

#include "rtl_sysc/qformat.h"
#include "tb/catch.h"
#include "tb/columns.h"
#include "tb/engine.h"
#include "tb/port.h"

namespace {

using namespace blysk;

template <class Q>
constexpr storage kind_of() {
  using T = stored<Q>;
  return std::is_same_v<T, std::uint8_t>    ? storage::u8
         : std::is_same_v<T, std::uint16_t> ? storage::u16
         : std::is_same_v<T, std::uint32_t> ? storage::u32
         : std::is_same_v<T, std::int32_t>  ? storage::i32
                                            : storage::i64;
}

/// The storage of a type is that of its format, and holds its ends.
template <class Q>
void check_storage(storage expected) {
  CAPTURE(Q::width, Q::is_signed);
  CHECK(storage_of(Q::width, Q::is_signed) == expected);
  CHECK(storage_of(format_of(Q{})) == expected);
  CHECK(kind_of<Q>() == expected);
  column ends(expected);
  ends.resize(2);
  ends.set(0, Q::min);
  ends.set(1, Q::max);
  CHECK(ends.get(0) == Q::min);
  CHECK(ends.get(1) == Q::max);
}

}  // namespace

TEST_CASE("a column is as wide as its format needs", "[columns]") {
  check_storage<uq<1, 0>>(storage::u8);
  check_storage<uq<8, 0>>(storage::u8);
  check_storage<uq<9, 0>>(storage::u16);
  check_storage<uq<8, 8>>(storage::u16);
  check_storage<uq<1, 16>>(storage::u32);
  check_storage<uq<8, 24>>(storage::u32);
  check_storage<uq<9, 24>>(storage::i64);
  check_storage<uq<63, 0>>(storage::i64);
  check_storage<sq<0, 1>>(storage::i32);
  check_storage<sq<31, 0>>(storage::i32);
  check_storage<sq<31, 1>>(storage::i64);
  check_storage<sq<63, 0>>(storage::i64);
}

TEST_CASE("a column keeps its kind and gives its elements back", "[columns]") {
  for (const storage kind :
       {storage::u8, storage::u16, storage::u32, storage::i32, storage::i64, storage::f64}) {
    column each(kind);
    CAPTURE(static_cast<int>(kind));
    CHECK(each.kind() == kind);
    CHECK(each.size() == 0);
    each.resize(3);
    CHECK(each.size() == 3);
    CHECK(each.get(2) == 0);
    each.set(1, 100);
    CHECK(each.get(1) == 100);
    CHECK(each.real(1) == 100.0);
    CHECK(each.visit([](const auto& of) { return of.size(); }) == 3);
  }
}

TEST_CASE("integers are cut to a column's bits, reals to integers", "[columns]") {
  column bytes(storage::u8);
  bytes.resize(1);
  bytes.set(0, 256 + 7);
  CHECK(bytes.get(0) == 7);
  column reals(storage::f64);
  reals.resize(1);
  reals.set(0, 1.75);
  CHECK(reals.real(0) == 1.75);
  CHECK(reals.get(0) == 1);
}

TEST_CASE("elements are read as what they are only", "[columns]") {
  column words(storage::u16);
  words.resize(1);
  words.set(0, 40000);
  CHECK(words.data<std::uint16_t>()[0] == 40000);
  CHECK(words.as<std::uint16_t>().size() == 1);
  CHECK_THROWS_AS(words.data<std::uint32_t>(), std::bad_variant_access);
  CHECK_THROWS_AS(words.as<double>(), std::bad_variant_access);
}

TEST_CASE("columns have a layout, one length, and compare by both", "[columns]") {
  const std::vector<storage> layout{storage::u16, storage::f64};
  columns some(layout);
  CHECK(some.layout() == layout);
  CHECK(some.width() == 2);
  CHECK(some.size() == 0);
  CHECK(columns().size() == 0);
  some.resize(4);
  CHECK(some[0].size() == 4);
  CHECK(some[1].size() == 4);
  columns others(layout);
  CHECK_FALSE(some == others);
  others.resize(4);
  CHECK(some == others);
  others[1].set(3, 0.5);
  CHECK_FALSE(some == others);
  columns wider({storage::u32, storage::f64});
  wider.resize(4);
  CHECK_FALSE(some == wider);
}

namespace {

/// Reads no instance: port_list takes types alone.
struct toy {
  int clk, a, we, level, mode, b, inner, ready;

  template <class Reader>
  static void pins(Reader& reader) {
    reader.clock(&toy::clk, {"clk", "", "clk", "clock"});
    reader.result(&toy::b, {"b_o", "7", "out7", "a product"}, sq<3, 30>{}, "product");
    reader.data(&toy::a, {"a_i", "3", "in3", "an angle"}, uq<2, 3>{}, "turn");
    reader.strobe(&toy::we, {"a_we_i", "4", "we4", "write"}, "a_i", write_edge::trailing);
    reader.data(&toy::level, {"level_i", "", "level", "a level"}, unit<8>{}, "level");
    reader.control(&toy::mode, {"mode_i", "", "mode", "a mode"});
    reader.inner_result(&toy::inner, {"sum", "", "sum", "a sum"}, uq<8, 0>{}, "sum");
    reader.valid(&toy::ready, {"valid_o", "29", "valid", "ready"});
  }
};

}  // namespace

TEST_CASE("pins become ports in their order", "[port]") {
  const std::vector<port> ports = ports_of<toy>();
  REQUIRE(ports.size() == 8);
  using role = port::role;
  const role roles[] = {role::clock, role::result,  role::data,   role::strobe,
                        role::data,  role::control, role::result, role::valid};
  for (std::size_t i = 0; i < ports.size(); ++i) {
    CAPTURE(i);
    CHECK(ports[i].is == roles[i]);
    CHECK(ports[i].is_input() == (i != 1 && i != 6 && i != 7));
    CHECK(ports[i].is_inner == (i == 6));
    CHECK(ports[i].carries.has_value() == (ports[i].is == role::data || ports[i].is == role::result));
  }
  CHECK(ports[1].width() == 34);
  CHECK(ports[2].width() == 5);
  CHECK(ports[3].width() == 1);
  CHECK(ports[3].writes == "a_i");
  CHECK(ports[3].edge == write_edge::trailing);
  CHECK(column_names(ports, role::data) == "turn,level");
  CHECK(column_names(ports, role::result) == "product,sum");
  CHECK(column_names(ports, role::reset).empty());
  CHECK(find_role(ports, role::data) == 2);
  CHECK_THROWS_AS(find_role(ports, role::reset), std::logic_error);
  CHECK(of_role(ports, role::data).back().name == "level_i");
}

TEST_CASE("a port says what it is in a line", "[port]") {
  const std::vector<port> ports = ports_of<toy>();
  CHECK(ports[0].text() == "clock");
  CHECK(ports[1].text() == "7: a product, SQ3.30");
  CHECK(ports[2].text() == "3: an angle, UQ2.3");
  CHECK(ports[4].text() == "a level, UQ1.8, codes 0..256");
  CHECK(ports[7].text() == "29: ready");
}

TEST_CASE("columns of ports are those of a role", "[columns]") {
  const std::vector<port> ports = ports_of<toy>();
  CHECK(columns(ports, port::role::data).layout() == std::vector{storage::u8, storage::u16});
  CHECK(columns(ports, port::role::result).layout() == std::vector{storage::i64, storage::u8});
}

namespace {

/// Doubles its column, and counts.
struct doubling final : engine {
  doubling() : engine({storage::u16}) {}
  void compute(const columns& in, columns& out) override {
    for (std::size_t row = 0; row < in.size(); ++row) out[0].set(row, 2 * in[0].get(row));
  }
};

}  // namespace

TEST_CASE("an engine lays its results out itself", "[engine]") {
  doubling twice;
  columns in({storage::u8});
  columns out({storage::f64, storage::f64});
  in.resize(2);
  in[0].set(0, 3);
  in[0].set(1, 200);
  twice.run(in, out);
  CHECK(out.layout() == std::vector{storage::u16});
  REQUIRE(out.size() == 2);
  CHECK(out[0].get(0) == 6);
  CHECK(out[0].get(1) == 400);
  in.resize(1);
  twice.run(in, out);
  CHECK(out.size() == 1);
}
