// SPDX-License-Identifier: Apache-2.0
// The interpreter on small devices that are none of the project's. One process per case: SystemC elaborates once.
#include "tb/netlist/interpreter.h"

#include <array>
#include <string>

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/buffer.h"
#include "rtl_sysc/blocks/law.h"
#include "rtl_sysc/blocks/reg_level.h"
#include "rtl_sysc/blocks/reg_trailing.h"
#include "rtl_sysc/formats.h"
#include "rtl_sysc/pin.h"
#include "tb/catch.h"

namespace {

using namespace blysk;
using netlist::elaborated;
using netlist::make_interpreter;

/// y_o = Law(a_i, b_i); the SystemC side is not run.
template <class Law, class A, class B, class Y>
struct law_block : sc_core::sc_module {
  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<typename B::raw_t> SC_NAMED(b_i);
  sc_core::sc_out<typename Y::raw_t> SC_NAMED(y_o);

  explicit law_block(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {}

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("law", "Law of a test.");
    reader.drive(y_o, Law::law(reader.read(a_i, A{}), reader.read(b_i, B{})), Y{});
  }
};

/// One block between the ports.
template <class Law, class A, class B, class Y>
struct law_device : sc_core::sc_module {
  sc_core::sc_in<typename A::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<typename B::raw_t> SC_NAMED(b_i);
  sc_core::sc_out<typename Y::raw_t> SC_NAMED(y_o);
  law_block<Law, A, B, Y> SC_NAMED(block);

  explicit law_device(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
    block.a_i(a_i), block.b_i(b_i), block.y_o(y_o);
  }

  template <class Reader>
  static void pins(Reader& reader) {
    using d = law_device;
    reader.data(&d::a_i, {"a_i", "", "a", "a"}, A{}, "a");
    reader.data(&d::b_i, {"b_i", "", "b", "b"}, B{}, "b");
    reader.result(&d::y_o, {"y_o", "", "y", "y"}, Y{}, "y");
  }
  auto blocks() const { return std::tie(block); }
};

template <class Device>
elaborated elaborate() {
  return elaborated(std::make_unique<Device>("device"), 0);
}

/// Every pair of the formats' codes, compared with the law on `Integer` cut to Y's bits.
template <class Integer, class Law, class A, class B, class Y>
void check_codes(const std::vector<std::int64_t>& a_codes, const std::vector<std::int64_t>& b_codes) {
  const elaborated device = elaborate<law_device<Law, A, B, Y>>();
  const auto interpreter = make_interpreter(device);
  const std::vector<port> ports = ports_of<law_device<Law, A, B, Y>>();
  columns in(ports, port::role::data);
  columns out;
  in.resize(a_codes.size() * b_codes.size());
  for (std::size_t row = 0; row < in.size(); ++row) {
    in[0].set(row, a_codes[row / b_codes.size()]);
    in[1].set(row, b_codes[row % b_codes.size()]);
  }
  interpreter->run(in, out);
  REQUIRE(out.size() == in.size());
  REQUIRE(in.size() > 0);
  for (std::size_t row = 0; row < in.size(); ++row) {
    const std::int64_t a = in[0].get(row);
    const std::int64_t b = in[1].get(row);
    const Integer value = Law::law(static_cast<Integer>(a), static_cast<Integer>(b));
    const std::int64_t expected = typename Y::raw_t(static_cast<std::int64_t>(value)).to_int64();
    if (out[0].get(row) != expected) {
      CAPTURE(row, a, b, expected, out[0].get(row));
      FAIL("the interpreter differs");
    }
  }
}

std::vector<std::int64_t> all_codes(std::int64_t min, std::int64_t max) {
  std::vector<std::int64_t> codes;
  for (std::int64_t code = min; code <= max; ++code) codes.push_back(code);
  return codes;
}

constexpr std::array<std::int64_t, 3> kTable{3, -2, 9};

/// Every operation, each in five bits of its own.
struct every_operation {
  template <class T>
  static T law(T a, T b) {
    using law::lookup;
    using law::select;
    const T five(31);
    T word(0);
    int place = 0;
    const auto append = [&](const T& value) {
      word = T(word | T((value & five) << place));
      place += 5;
    };
    append(T(a + b));
    append(T(a - b));
    append(T(a * b));
    append(T(~a));
    append(T(a << 1));
    append(T(a >> 2));
    append(T(T(a < b) | T(T(a == b) << 1) | T(T(!b) << 2)));
    append(T(T(a && b) | T(T(a || b) << 1)));
    append(T(a & b));
    append(T(a | b));
    append(T(a ^ b));
    append(T(select(a < b, a, b)) + T(lookup(kTable, b)));
    return word;
  }
};

struct sum {
  template <class T>
  static T law(T a, T b) {
    return a + b;
  }
};

struct wide_product {
  template <class T>
  static T law(T a, T b) {
    return (a * b * a) >> 40;
  }
};

}  // namespace

TEST_CASE("every operation is that of a C++ integer", "[netlist]") {
  check_codes<std::int64_t, every_operation, sq<3, 0>, uq<3, 0>, uq<60, 0>>(all_codes(-8, 7),
                                                                            all_codes(0, 7));
}

TEST_CASE("a drive wraps to an unsigned port", "[netlist]") {
  check_codes<std::int64_t, sum, sq<3, 0>, uq<3, 0>, uq<2, 0>>(all_codes(-8, 7), all_codes(0, 7));
}

TEST_CASE("a drive wraps to a signed port", "[netlist]") {
  check_codes<std::int64_t, sum, sq<3, 0>, uq<3, 0>, sq<2, 0>>(all_codes(-8, 7), all_codes(0, 7));
}

TEST_CASE("a law that needs more than 64 bits is computed with more", "[netlist]") {
  const std::vector<std::int64_t> ends{-(1LL << 31), -123456789, -1, 0, 1, 987654321, (1LL << 31) - 1};
  check_codes<netlist::wide_int, wide_product, sq<31, 0>, sq<31, 0>, sq<55, 0>>(ends, ends);
}

TEST_CASE("a sum that needs 65 bits wraps to 64", "[netlist]") {
  const std::vector<std::int64_t> ends{sq<63, 0>::min, sq<63, 0>::min + 1, -1, 0, 1, sq<63, 0>::max};
  check_codes<netlist::wide_int, sum, sq<63, 0>, sq<63, 0>, sq<63, 0>>(ends, ends);
}

namespace {

using byte = uq<8, 0>;

/// q_o: two registers in a row, one of each kind, then the sum with the input.
struct pipeline : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(we_i);
  sc_core::sc_in<byte::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<carry::raw_t> SC_NAMED(carry_i);
  sc_core::sc_out<byte::raw_t> SC_NAMED(y_o);
  sc_core::sc_out<bool> SC_NAMED(valid_o);

  reg_level<byte> SC_NAMED(first);
  reg_trailing<byte> SC_NAMED(second);
  add<byte, byte, byte> SC_NAMED(adder);
  buffer SC_NAMED(wire);
  sc_core::sc_signal<byte::raw_t> SC_NAMED(first_q);
  sc_core::sc_signal<byte::raw_t> SC_NAMED(second_q);

  explicit pipeline(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
    first.clk(clk), first.rst_n(rst_n), first.we_i(we_i), first.d_i(a_i), first.q_o(first_q);
    second.clk(clk), second.rst_n(rst_n), second.we_i(we_i), second.d_i(first_q), second.q_o(second_q);
    adder.a_i(second_q), adder.b_i(a_i), adder.carry_i(carry_i), adder.s_o(y_o);
    wire.a_i(we_i), wire.y_o(valid_o);
  }

  template <class Reader>
  static void pins(Reader& reader) {
    using d = pipeline;
    reader.clock(&d::clk, {"clk", "", "clk", "clock"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "reset"});
    reader.strobe(&d::we_i, {"we_i", "", "we", "write"}, "a_i", write_edge::level);
    reader.data(&d::a_i, {"a_i", "", "a", "a"}, byte{}, "a");
    reader.data(&d::carry_i, {"carry_i", "", "carry", "carry"}, carry{}, "carry");
    reader.inner_result(&d::second_q, {"second_q", "", "q", "q"}, byte{}, "q");
    reader.result(&d::y_o, {"y_o", "", "y", "y"}, byte{}, "y");
    reader.valid(&d::valid_o, {"valid_o", "", "valid", "valid"});
  }
  auto blocks() const { return std::tie(adder, second, wire, first); }  // not in the order of data
};

}  // namespace

TEST_CASE("registers are transparent, and nets inside are results", "[netlist]") {
  const elaborated device = elaborate<pipeline>();
  const auto interpreter = make_interpreter(device);
  columns in(ports_of<pipeline>(), port::role::data);
  columns out;
  in.resize(512);
  for (std::size_t row = 0; row < in.size(); ++row) {
    in[0].set(row, row % 256);
    in[1].set(row, row / 256);
  }
  interpreter->run(in, out);
  REQUIRE(out.width() == 2);
  for (std::size_t row = 0; row < in.size(); ++row) {
    CAPTURE(row);
    REQUIRE(out[0].get(row) == in[0].get(row));
    REQUIRE(out[1].get(row) == (2 * in[0].get(row) + in[1].get(row)) % 256);
  }
  CHECK(sc_core::sc_time_stamp() == sc_core::SC_ZERO_TIME);
}

TEST_CASE("batches of any length are computed whole", "[netlist]") {
  const elaborated device = elaborate<law_device<sum, byte, byte, uq<9, 0>>>();
  const auto interpreter = make_interpreter(device);
  columns in({storage::u8, storage::u8});
  columns out;
  for (const std::size_t size : {0u, 1u, 255u, 256u, 257u, 1000u, 3u}) {
    in.resize(size);
    for (std::size_t row = 0; row < size; ++row) {
      in[0].set(row, row % 251);
      in[1].set(row, row % 241);
    }
    interpreter->run(in, out);
    CAPTURE(size);
    REQUIRE(out.size() == size);
    for (std::size_t row = 0; row < size; ++row)
      REQUIRE(out[0].get(row) == static_cast<std::int64_t>(row % 251 + row % 241));
  }
}

TEST_CASE("codes beyond the wires are cut to them", "[netlist]") {
  using three = uq<3, 0>;
  const elaborated device = elaborate<law_device<sum, three, three, uq<4, 0>>>();
  const auto interpreter = make_interpreter(device);
  columns in({storage::u8, storage::u8});
  columns out;
  in.resize(1);
  in[0].set(0, 8 + 5);
  in[1].set(0, 2);
  interpreter->run(in, out);
  CHECK(out[0].get(0) == 7);
}

namespace {

enum class fault { loop, loop_through_register, undriven, of_strobe };

/// y_o = a_i + what Fault puts at the adder's other input.
template <fault Fault>
struct faulty : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(we_i);
  sc_core::sc_in<byte::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<carry::raw_t> SC_NAMED(carry_i);
  sc_core::sc_out<byte::raw_t> SC_NAMED(y_o);
  sc_core::sc_signal<byte::raw_t> SC_NAMED(ring);
  sc_core::sc_signal<byte::raw_t> SC_NAMED(next);
  sc_core::sc_signal<bool> SC_NAMED(level);

  /// Takes the strobe as a number.
  struct tap : sc_core::sc_module {
    sc_core::sc_in<bool> SC_NAMED(a_i);
    sc_core::sc_out<byte::raw_t> SC_NAMED(y_o);
    explicit tap(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {}
    template <class Reader>
    void describe(Reader& reader) const {
      reader.block_is("tap", "Number of a strobe.");
      reader.drive(y_o, reader.read(a_i), byte{});
    }
  };

  add<byte, byte, byte> SC_NAMED(first);
  add<byte, byte, byte> SC_NAMED(second);
  reg_level<byte> SC_NAMED(kept);
  tap SC_NAMED(number);

  explicit faulty(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
    sc_core::sc_signal<byte::raw_t>& other = Fault == fault::undriven ? spare : ring;
    first.a_i(a_i), first.b_i(other), first.carry_i(carry_i), first.s_o(next);
    second.a_i(next), second.b_i(a_i), second.carry_i(carry_i), second.s_o(y_o);
    kept.clk(clk), kept.rst_n(rst_n), kept.we_i(we_i), kept.d_i(next);
    kept.q_o(Fault == fault::loop_through_register ? ring : unused);
    number.a_i(we_i), number.y_o(Fault == fault::of_strobe ? ring : strobe_number);
    if (Fault == fault::loop) back = std::make_unique<add<byte, byte, byte>>("back");
    if (back) back->a_i(next), back->b_i(a_i), back->carry_i(carry_i), back->s_o(ring);
  }

  template <class Reader>
  static void pins(Reader& reader) {
    using d = faulty;
    reader.clock(&d::clk, {"clk", "", "clk", "clock"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "reset"});
    reader.strobe(&d::we_i, {"we_i", "", "we", "write"}, "a_i", write_edge::level);
    reader.data(&d::a_i, {"a_i", "", "a", "a"}, byte{}, "a");
    reader.data(&d::carry_i, {"carry_i", "", "carry", "carry"}, carry{}, "carry");
    reader.result(&d::y_o, {"y_o", "", "y", "y"}, byte{}, "y");
  }
  auto blocks() const {
    if constexpr (Fault == fault::loop) {
      return std::tie(first, second, kept, number, *back);
    } else {
      return std::tie(first, second, kept, number);
    }
  }

  std::unique_ptr<add<byte, byte, byte>> back;
  sc_core::sc_signal<byte::raw_t> spare, unused, strobe_number;
};

/// The message of the refusal, empty if there is none.
template <fault Fault>
std::string refusal() {
  const elaborated device = elaborate<faulty<Fault>>();
  try {
    make_interpreter(device);
  } catch (const std::logic_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a loop is refused", "[netlist]") {
  CHECK(refusal<fault::loop>() == "device.first is in a loop");
}
TEST_CASE("a loop through a register is refused", "[netlist]") {
  CHECK(refusal<fault::loop_through_register>() == "device.first is in a loop");
}
TEST_CASE("an input that nothing drives is refused", "[netlist]") {
  CHECK(refusal<fault::undriven>() == "device.first.b_i is driven by nothing");
}
TEST_CASE("a result that depends on a strobe is refused", "[netlist]") {
  CHECK(refusal<fault::of_strobe>() == "y_o depends on a port that is no column of the stimulus");
}

namespace {

/// A counter: its register's d is made of its q, within one block.
struct counter : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<byte::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<byte::raw_t> SC_NAMED(y_o);
  sc_core::sc_signal<byte::raw_t> SC_NAMED(count_q);
  explicit counter(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {}
  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("counter", "Adds a_i to itself.");
    const auto sum = reader.read(count_q) + reader.read(a_i, byte{});
    reader.reg(clk, rst_n, reader.constant(1), sum, count_q);
    reader.drive(y_o, reader.read(count_q), byte{});
  }
};

struct counter_device : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<byte::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<byte::raw_t> SC_NAMED(y_o);
  counter SC_NAMED(count);
  explicit counter_device(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
    count.clk(clk), count.rst_n(rst_n), count.a_i(a_i), count.y_o(y_o);
  }
  template <class Reader>
  static void pins(Reader& reader) {
    using d = counter_device;
    reader.clock(&d::clk, {"clk", "", "clk", "clock"});
    reader.reset(&d::rst_n, {"rst_n", "", "rst_n", "reset"});
    reader.data(&d::a_i, {"a_i", "", "a", "a"}, byte{}, "a");
    reader.result(&d::y_o, {"y_o", "", "y", "y"}, byte{}, "y");
  }
  auto blocks() const { return std::tie(count); }
};

}  // namespace

TEST_CASE("a register that feeds itself is refused", "[netlist]") {
  const elaborated device = elaborate<counter_device>();
  CHECK_THROWS_WITH(make_interpreter(device), "count_q is in a loop");
}
