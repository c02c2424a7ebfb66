// SPDX-License-Identifier: Apache-2.0
// verilated_glue DEVICE FORMAT CLASS TOP --output FOLDER [--OPTION [VALUE]]...: what joins the class that Verilator makes of a
// Verilog module with the ports of the device to cosim::verilated, as FOLDER/glue.cpp. It includes the class's code, so that
// the two are one translation unit. FOLDER/public.vlt asks Verilator for the inner results. A file that is right already
// keeps its time.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tb/columns.h"
#include "tb/program.h"

namespace blysk::cosim {
namespace {

struct wanted {
  std::string class_name;  ///< Verilator's prefix
  std::string top;         ///< the Verilog module
  bool has_inner = true;   ///< the module has the nets of the inner results
  bool has_mutants = false;
  bool is_recorded = false;  ///< made with --trace
};

const char* element_of(const port& of) {
  switch (storage_of(*of.carries)) {
    case storage::u8:
      return "std::uint8_t";
    case storage::u16:
      return "std::uint16_t";
    case storage::u32:
      return "std::uint32_t";
    case storage::i32:
      return "std::int32_t";
    case storage::i64:
      return "std::int64_t";
    case storage::f64:
      break;
  }
  throw std::logic_error("a format has no real storage");
}

const char* storage_name(const port& of) {
  constexpr const char* kNames[] = {"u8", "u16", "u32", "i32", "i64", "f64"};
  return kNames[static_cast<int>(storage_of(*of.carries))];
}

class glue {
 public:
  glue(const std::vector<port>& ports, wanted what) : ports_(ports), what_(std::move(what)) {}

  std::string text() const {
    const protocol talks = protocol_of(ports_);
    const bool driven = talks != protocol::none;
    return fmt::format(
        R"(// Made by verilated_glue; do not edit.
{12}#include <{0}.h>
#include <{0}___024root.h>
#include <all.cpp>

#include "tb/cosim/{1}.h"

namespace blysk::cosim {{
namespace {{

struct glue {{
  static constexpr protocol kProtocol = protocol::{2};
  static constexpr std::size_t kPorts = {14};
  static constexpr std::size_t kDataColumns = {3};
  static constexpr std::array<storage, {4}> kResultStorage = {{{5}}};

  {0} top;
{13}{6}
  template <class Use>
  void inputs(Use use) {{
{7}  }}
  template <class Use>
  void outputs(Use use) {{
{8}  }}
{9}}};

}}  // namespace

std::unique_ptr<{10}> make_{0}() {{
  return std::make_unique<{11}>();
}}

}}  // namespace blysk::cosim
)",
        what_.class_name, what_.has_mutants ? "mutants_of" : "verilated", name_of(talks),
        std::ranges::count(ports_, port::role::data, &port::is),
        std::ranges::count(ports_, port::role::result, &port::is), result_storage(),
        driven ? control_text() : "", wires_text(true), wires_text(false), driven ? columns_text() : "",
        what_.has_mutants ? "mutants" : "verilator_engine",
        what_.has_mutants ? "mutants_of<glue>" : "verilated<glue>",
        what_.is_recorded ? "#include <verilated_vcd_c.h>\n" : "",
        what_.is_recorded ? "  void record(VerilatedVcdC& waves) { top.trace(&waves, 99); }\n" : "",
        ports_.size());
  }

  std::string configuration() const {
    std::string text = "// Made by verilated_glue; do not edit.\n`verilator_config\n";
    for (const port& each : ports_) {
      if (each.is_inner && what_.has_inner)
        text += fmt::format("public_flat_rd -module \"{}*\" -var \"{}\"\n", what_.top, each.name);
    }
    return text;
  }

 private:
  static const char* name_of(protocol talks) {
    return talks == protocol::strobes ? "strobes" : talks == protocol::handshake ? "handshake" : "none";
  }

  const port* strobe_of(const port& data) const {
    const auto found = std::ranges::find_if(
        ports_, [&](const port& each) { return each.is == port::role::strobe && each.writes == data.name; });
    return found == ports_.end() ? nullptr : &*found;
  }

  std::string result_storage() const {
    std::string text;
    for (const port& each : of_role(ports_, port::role::result))
      text += fmt::format("{}storage::{}", text.empty() ? "" : ", ", storage_name(each));
    return text;
  }

  /// A member of the class; an inner result that the module lacks reads as 0.
  std::string member(const port& of) const {
    if (!of.is_inner) return "top." + of.name;
    return what_.has_inner ? fmt::format("top.rootp->{}__DOT__{}", what_.top, of.name) : "std::uint64_t{0}";
  }

  /// Index, width, sign.
  std::string wire_of(const port& of) const {
    return fmt::format("{}, {}, {}", &of - ports_.data(), of.width(), of.carries && of.carries->is_signed);
  }

  std::string control_text() const {
    std::string text = fmt::format("  static constexpr int kSettlingCycles = {};\n",
                                   ports_[find_role(ports_, port::role::valid)].settling_cycles);
    const auto add = [&](const char* method, port::role role) {
      text +=
          fmt::format("  auto& {}() {{ return top.{}; }}\n", method, ports_[find_role(ports_, role)].name);
    };
    add("clock", port::role::clock);
    add("reset", port::role::reset);
    if (protocol_of(ports_) == protocol::handshake) {
      add("start", port::role::start);
      add("ready", port::role::ready);
      add("valid", port::role::valid);
    }
    return text;
  }

  std::string wires_text(bool are_inputs) const {
    std::string text;
    for (const port& each : ports_) {
      if (each.is_input() == are_inputs)
        text += fmt::format("    use(wire<{}>{{}}, {});\n", wire_of(each), member(each));
    }
    return text;
  }

  std::string columns_text() const {
    std::string data, trailing, level, results;
    std::size_t data_column = 0;
    std::size_t result_column = 0;
    for (const port& each : ports_) {
      const auto field = [&](std::size_t column) {
        return fmt::format("field<{}, {}, {}>{{}}, {}", wire_of(each), column, element_of(each),
                           member(each));
      };
      if (each.is == port::role::data) {
        const std::string described = field(data_column++);
        data += fmt::format("    use({});\n", described);
        if (const port* const strobe = strobe_of(each); strobe != nullptr) {
          (strobe->edge == write_edge::trailing ? trailing : level) +=
              fmt::format("    use({}, top.{});\n", described, strobe->name);
        }
      } else if (each.is == port::role::result) {
        results += fmt::format("    use({});\n", field(result_column++));
      }
    }
    const auto method = [](const char* name, const std::string& body) {
      return fmt::format("  template <class Use>\n  void {}(Use use) {{\n{}  }}\n", name, body);
    };
    return method("data", data) + method("trailing", trailing) + method("level", level) +
           method("results", results);
  }

  const std::vector<port>& ports_;
  wanted what_;
};

void write_if_new(const std::filesystem::path& path, const std::string& text) {
  std::ifstream old(path, std::ios::binary);
  if (old && std::string(std::istreambuf_iterator<char>(old), {}) == text) return;
  std::ofstream file;
  file.exceptions(std::ios::failbit | std::ios::badbit);
  file.open(path, std::ios::binary);
  file << text;
  file.close();
}

}  // namespace
}  // namespace blysk::cosim

int main(int argc, char** argv) {
  using namespace blysk;
  device_arguments arguments;
  cosim::wanted what;
  std::string folder;
  return run_program(
      argc, argv, "Writes the C++ that joins a Verilated class to the ports of its device",
      [&](CLI::App& program) {
        arguments.add_to(program);
        program.add_option("CLASS", what.class_name, "class, Verilator's prefix")->required();
        program.add_option("TOP", what.top, "Verilog module")->required();
        program.add_option("--output", folder, "folder for glue.cpp and public.vlt")->required();
        program.add_flag("--no-inner{false}", what.has_inner, "the module has no nets of inner results");
        program.add_flag("--mutants", what.has_mutants, "the module has an input that selects a mutant");
        program.add_flag("--recorded", what.is_recorded, "the class is made with --trace");
        arguments.add_options_to(program);
      },
      [&] {
        const selection asked = arguments.chosen();
        const std::vector<port> ports = asked.of().ports(asked);
        const cosim::glue glue(ports, what);
        std::filesystem::create_directories(folder);
        cosim::write_if_new(folder + "/glue.cpp", glue.text());
        cosim::write_if_new(folder + "/public.vlt", glue.configuration());
        return 0;
      });
}
