// SPDX-License-Identifier: Apache-2.0
// The exporter on a device that is none of the project's: what devices to come need of it.
#include <array>
#include <cstdlib>
#include <filesystem>

#include "rtl_sysc/blocks/add.h"
#include "rtl_sysc/blocks/constant.h"
#include "tb/catch.h"
#include "tb/export/export.h"
#include "tb/export/replay.h"
#include "tb/scratch.h"

namespace {

using namespace blysk;

using code = uq<10, 0>;
using word = sq<4, 12>;

constexpr std::array<std::int64_t, 1000> make_squares() {
  std::array<std::int64_t, 1000> words{};
  for (std::size_t i = 0; i < words.size(); ++i)
    words[i] = static_cast<std::int64_t>(i) * static_cast<std::int64_t>(i) % 65536 - 32768;
  return words;
}

constexpr std::array<std::int64_t, 1000> kSquares = make_squares();

/// y_o = table(a_i), a thousand words.
struct rom : sc_core::sc_module {
  sc_core::sc_in<code::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<word::raw_t> SC_NAMED(y_o);

  SC_CTOR(rom) {
    SC_METHOD(eval);
    sensitive << a_i;
  }

  template <class T>
  static constexpr T law(T a) {
    using law::lookup;
    return lookup(kSquares, a);
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("rom", "Table: y_o = (a_i^2 mod 2^16 - 2^15) ulp, 0 from code 1000 on.");
    reader.drive(y_o, law(reader.read(a_i, code{})), word{});
  }

 private:
  void eval() { y_o.write(law<std::int64_t>(a_i.read().to_int64())); }
};

/// sum_o += d_i, and a few bits of both; it starts at 1234.
struct accumulator : sc_core::sc_module {
  static constexpr std::int64_t kReset = 1234;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(add_i);
  sc_core::sc_in<word::raw_t> SC_NAMED(d_i);
  sc_core::sc_out<word::raw_t> SC_NAMED(sum_o);
  sc_core::sc_out<word::raw_t> SC_NAMED(bits_o);

  SC_CTOR(accumulator) {
    SC_METHOD(load);
    sensitive << clk.pos();
    dont_initialize();
    SC_METHOD(drive);
    sensitive << sum_q << d_i;
  }

  template <class T>
  static constexpr T mix(T sum, T d) {
    return (sum & d) ^ (sum | T{0x55});
  }

  template <class Reader>
  void describe(Reader& reader) const {
    reader.block_is("accumulator", "Register: adds d_i while add_i is one, modulo 2^17.");
    const auto sum = reader.read(sum_q);
    const auto d = reader.read(d_i, word{});
    reader.reg(clk, rst_n, reader.read(add_i), sum + d, sum_q, word{}, kReset);
    reader.drive(sum_o, sum, word{});
    reader.drive(bits_o, mix(sum, d), word{});
  }

 private:
  void load() {
    if (!rst_n.read()) {
      sum_q.write(kReset);
    } else if (add_i.read()) {
      sum_q.write(sum_q.read().to_int64() + d_i.read().to_int64());
    }
  }
  void drive() {
    sum_o.write(sum_q.read());
    bits_o.write(mix<std::int64_t>(sum_q.read().to_int64(), d_i.read().to_int64()));
  }

  sc_core::sc_signal<word::raw_t> SC_NAMED(sum_q);
};

/// A table and an accumulator of its words.
struct stage : sc_core::sc_module {
  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(add_i);
  sc_core::sc_in<code::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<word::raw_t> SC_NAMED(sum_o);
  sc_core::sc_out<word::raw_t> SC_NAMED(bits_o);

  rom SC_NAMED(rom1);
  accumulator SC_NAMED(acc2);
  sc_core::sc_signal<word::raw_t> SC_NAMED(looked_up);

  SC_CTOR(stage) {
    rom1.a_i(a_i);
    rom1.y_o(looked_up);
    acc2.clk(clk);
    acc2.rst_n(rst_n);
    acc2.add_i(add_i);
    acc2.d_i(looked_up);
    acc2.sum_o(sum_o);
    acc2.bits_o(bits_o);
  }

  auto blocks() const { return std::tie(rom1, acc2); }
};

/// Two equal stages, and the sum of their sums.
struct toy : sc_core::sc_module {
  using total = sq<6, 12>;

  sc_core::sc_in<bool> SC_NAMED(clk);
  sc_core::sc_in<bool> SC_NAMED(rst_n);
  sc_core::sc_in<bool> SC_NAMED(add_i);
  sc_core::sc_in<code::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<code::raw_t> SC_NAMED(b_i);
  sc_core::sc_out<total::raw_t> SC_NAMED(total_o);
  sc_core::sc_out<word::raw_t> SC_NAMED(a_bits_o);
  sc_core::sc_out<word::raw_t> SC_NAMED(b_bits_o);

  stage SC_NAMED(stage1);
  stage SC_NAMED(stage2);
  constant<uq<1, 0>> carry3;
  add<word, word, total> SC_NAMED(add4);
  sc_core::sc_signal<word::raw_t> SC_NAMED(a_sum);
  sc_core::sc_signal<word::raw_t> SC_NAMED(b_sum);
  sc_core::sc_signal<uq<1, 0>::raw_t> SC_NAMED(carry);

  SC_CTOR(toy) : carry3("carry3", 1) {
    for (stage* each : {&stage1, &stage2}) {
      each->clk(clk);
      each->rst_n(rst_n);
      each->add_i(add_i);
    }
    stage1.a_i(a_i);
    stage1.sum_o(a_sum);
    stage1.bits_o(a_bits_o);
    stage2.a_i(b_i);
    stage2.sum_o(b_sum);
    stage2.bits_o(b_bits_o);
    carry3.y_o(carry);
    add4.a_i(a_sum);
    add4.b_i(b_sum);
    add4.carry_i(carry);
    add4.s_o(total_o);
  }

  template <class Reader>
  static void pins(Reader& reader) {
    reader.clock(&toy::clk, {"clk", "", "clk", "samples add_i"});
    reader.reset(&toy::rst_n, {"rst_n", "", "rst_n", "synchronous"});
    reader.control(&toy::add_i, {"add_i", "", "add", "adds"});
    reader.data(&toy::a_i, {"a_i", "", "a", "to stage 1"}, code{}, "a");
    reader.data(&toy::b_i, {"b_i", "", "b", "to stage 2"}, code{}, "b");
    reader.result(&toy::total_o, {"total_o", "", "total", "both sums and an ulp"}, total{}, "total");
    reader.result(&toy::a_bits_o, {"a_bits_o", "", "a_bits", "of stage 1"}, word{}, "a_bits");
    reader.result(&toy::b_bits_o, {"b_bits_o", "", "b_bits", "of stage 2"}, word{}, "b_bits");
  }

  auto blocks() const { return std::tuple_cat(stage1.blocks(), stage2.blocks(), std::tie(carry3, add4)); }
};

constexpr const char* kAccumulator = "toy_accumulator_sq4_12_to_sq4_12_sq4_12.v";

}  // namespace

TEST_CASE("a table, an accumulator and two equal stages are exported, linted and simulated", "[export]") {
  const netlist::elaborated device(std::make_unique<toy>("toy"), 0);
  const verilog::files texts = verilog::export_files(device, "toy", "a toy");

  // One module per type, whatever the number of its instances.
  std::vector<std::string> modules;
  for (const auto& [name, text] : texts) {
    if (name.ends_with(".v")) modules.push_back(name);
  }
  CHECK(modules == std::vector<std::string>{"toy.v", kAccumulator, "toy_add_sq4_12_sq4_12_to_sq6_12.v",
                                            "toy_constant_uq1_0.v", "toy_rom_uq10_0_to_sq4_12.v",
                                            "toy_stage.v"});
  const std::string& top = texts.at("toy.v");
  CHECK(top.find("  toy_stage stage1 (") != std::string::npos);
  CHECK(top.find("  toy_stage stage2 (") != std::string::npos);
  CHECK(top.find("  wire signed [16:0] a_sum;  // stage1: SQ4.12\n") != std::string::npos);
  CHECK(texts.at(kAccumulator).find("sum_q <= 17'd1234;") != std::string::npos);

  const scratch made;
  const std::filesystem::path folder = made.path("");
  const auto in_folder = [&](const std::string& command) {
    return std::system(("cd '" + folder.string() + "' && " + command).c_str());
  };
  verilog::write_files(texts, folder);
  CHECK(in_folder("'" BLYSK_LINT "' . verilator icarus yosys") == 0);
  constexpr int kCycles = 5000;
  verilog::write_replay(device, "toy", kCycles, folder);
  CHECK(in_folder("iverilog -g2001 -s replay -o replay.vvp *.v && vvp -n replay.vvp > said") == 0);
  CHECK(slurp(folder / "said") == "5000 cycles replayed, 0 differ\n");

  // The bench sees a difference: one bit of the reset value.
  std::string wrong = texts.at(kAccumulator);
  wrong.replace(wrong.find("17'd1234"), 8, "17'd1235");
  verilog::write_files({{kAccumulator, wrong}}, folder);
  CHECK(in_folder("iverilog -g2001 -s replay -o replay.vvp *.v && vvp -n replay.vvp > said") == 0);
  CHECK(slurp(folder / "said") != "5000 cycles replayed, 0 differ\n");
}

namespace {

/// Constants of their own in two modules of one type.
struct holder : sc_core::sc_module {
  sc_core::sc_out<word::raw_t> SC_NAMED(y_o);
  constant<word> held;

  holder(const sc_core::sc_module_name& name, std::int64_t raw)
      : sc_core::sc_module(name), held("held", raw) {
    held.y_o(y_o);
  }
};

struct two_holders : sc_core::sc_module {
  sc_core::sc_out<word::raw_t> SC_NAMED(a_o);
  sc_core::sc_out<word::raw_t> SC_NAMED(b_o);
  holder one{"one", 1};
  holder two{"two", 2};

  SC_CTOR(two_holders) {
    one.y_o(a_o);
    two.y_o(b_o);
  }

  template <class Reader>
  static void pins(Reader& reader) {
    reader.result(&two_holders::a_o, {"a_o", "1", "a_o", ""}, word{}, "a_o");
    reader.result(&two_holders::b_o, {"b_o", "2", "b_o", ""}, word{}, "b_o");
  }
  auto blocks() const { return std::tie(one.held, two.held); }
};

}  // namespace

namespace {

/// Both inputs of a module on one net: the ports of the adder inside it have the same channel behind them.
struct inside : sc_core::sc_module {
  sc_core::sc_in<word::raw_t> SC_NAMED(a_i);
  sc_core::sc_in<word::raw_t> SC_NAMED(b_i);
  sc_core::sc_out<toy::total::raw_t> SC_NAMED(y_o);
  constant<uq<1, 0>> carry1;
  add<word, word, toy::total> SC_NAMED(add2);
  sc_core::sc_signal<uq<1, 0>::raw_t> SC_NAMED(carry);

  SC_CTOR(inside) : carry1("carry1", 0) {
    carry1.y_o(carry);
    add2.a_i(a_i);
    add2.b_i(b_i);
    add2.carry_i(carry);
    add2.s_o(y_o);
  }
};

struct doubled : sc_core::sc_module {
  sc_core::sc_in<word::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<toy::total::raw_t> SC_NAMED(y_o);
  inside SC_NAMED(sum);

  SC_CTOR(doubled) {
    sum.a_i(a_i);
    sum.b_i(a_i);
    sum.y_o(y_o);
  }

  template <class Reader>
  static void pins(Reader& reader) {
    reader.data(&doubled::a_i, {"a_i", "", "a_i", ""}, word{}, "a_i");
    reader.result(&doubled::y_o, {"y_o", "", "y_o", ""}, toy::total{}, "y_o");
  }
  auto blocks() const { return std::tie(sum.carry1, sum.add2); }
};

}  // namespace

TEST_CASE("a module of modules with two ports on one net is refused", "[export]") {
  const netlist::elaborated device(std::make_unique<doubled>("doubled"), 0);
  CHECK_THROWS_WITH(verilog::export_files(device, "doubled", ""),
                    Catch::Matchers::StartsWith("a_i and b_i of doubled.sum are bound to one net"));
}

TEST_CASE("two modules of one type that differ are refused", "[export]") {
  const netlist::elaborated device(std::make_unique<two_holders>("two_holders"), 0);
  CHECK_THROWS_AS(verilog::export_files(device, "two_holders", ""), std::logic_error);
}

namespace {

/// Adders for a number of [0, 1] and for any of UQ1.4: the same names by their formats, of other text.
struct two_kinds : sc_core::sc_module {
  sc_core::sc_in<uq<1, 4>::raw_t> SC_NAMED(a_i);
  sc_core::sc_out<uq<3, 4>::raw_t> SC_NAMED(y_o);
  sc_core::sc_out<uq<3, 4>::raw_t> SC_NAMED(z_o);
  constant<uq<1, 0>> carry1;
  add<uq<1, 4>, uq<1, 4>, uq<3, 4>> SC_NAMED(add2);
  add<unit<4>, unit<4>, uq<3, 4>> SC_NAMED(add3);
  sc_core::sc_signal<uq<1, 0>::raw_t> SC_NAMED(carry);

  SC_CTOR(two_kinds) : carry1("carry1", 0) {
    carry1.y_o(carry);
    add2.a_i(a_i);
    add2.b_i(a_i);
    add2.carry_i(carry);
    add2.s_o(y_o);
    add3.a_i(a_i);
    add3.b_i(a_i);
    add3.carry_i(carry);
    add3.s_o(z_o);
  }

  template <class Reader>
  static void pins(Reader& reader) {
    reader.data(&two_kinds::a_i, {"a_i", "", "a_i", ""}, uq<1, 4>{}, "a_i");
    reader.result(&two_kinds::y_o, {"y_o", "", "y_o", ""}, uq<3, 4>{}, "y_o");
    reader.result(&two_kinds::z_o, {"z_o", "", "z_o", ""}, uq<3, 4>{}, "z_o");
  }
  auto blocks() const { return std::tie(carry1, add2, add3); }
};

}  // namespace

TEST_CASE("kinds that formats do not tell apart are numbered", "[export]") {
  const netlist::elaborated device(std::make_unique<two_kinds>("two_kinds"), 0);
  const verilog::files texts = verilog::export_files(device, "two_kinds", "");
  CHECK(texts.contains("two_kinds_add_uq1_4_uq1_4_to_uq3_4.v"));
  CHECK(texts.contains("two_kinds_add_uq1_4_uq1_4_to_uq3_4_2.v"));
}
