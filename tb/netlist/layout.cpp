// SPDX-License-Identifier: Apache-2.0
#include "tb/netlist/layout.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "tb/engine.h"
#include "tb/wave_values.h"

namespace blysk::netlist {
namespace {

/// Rows of a .gtkw file. The flags of a row are those of GTKWave's analyzer.h.
class rows {
 public:
  explicit rows(const std::string& root)
      : root_(root), values_(fmt::format("{}.{}", root.substr(0, root.find('.')), kValueScope)) {}

  void begin(const std::string& title) { text_ += fmt::format("@800200\n-{}\n", title); }
  void end(const std::string& title) { text_ += fmt::format("@1000200\n-{}\n", title); }

  /// \param alias  what the row shows instead of the signal's name, if not empty
  void add(const std::string& signal, const std::optional<wire_format>& carries,
           const std::string& alias = "", bool is_analogue = false) {
    const std::string name = alias.empty() ? "" : fmt::format("+{{{}}} ", alias);
    if (!carries) {
      text_ += fmt::format("@28\n{}{}.{}\n", name, root_, signal);
      return;
    }
    unsigned flags = carries->is_signed ? kSigned : kDecimal;
    if (carries->frac > 0) flags |= kFixedPoint;
    if (is_analogue) flags |= kAnalogue;
    text_ += fmt::format("@{:x}\n", flags);
    if (carries->frac > 0) text_ += fmt::format("[fpshift_count] {}\n", carries->frac);
    const std::string range = carries->width() == 1 ? "" : fmt::format("[{}:0]", carries->width() - 1);
    text_ += fmt::format("{}{}.{}{}\n", name, root_, signal, range);
    if (is_analogue) text_ += kHeight;
  }

  void add_value(const std::string& name, bool is_analogue = false) {
    if (name.empty()) return;
    text_ += fmt::format("@{:x}\n{}.{}\n", is_analogue ? kReal | kAnalogue : kReal, values_, name);
    if (is_analogue) text_ += kHeight;
  }

  const std::string& text() const { return text_; }

 private:
  static constexpr const char* kHeight = "@20000\n-\n-\n-\n";  // of an analogue trace
  static constexpr unsigned kReal = 0x20;                      // to the right, as the others
  static constexpr unsigned kDecimal = 0x24;
  static constexpr unsigned kSigned = 0x420;
  static constexpr unsigned kAnalogue = 0x8000;
  static constexpr unsigned kFixedPoint = 0x40000000;

  std::string root_, values_;
  std::string text_;
};

const port* strobe_of(const std::vector<port>& ports, const port& data) {
  const auto found = std::ranges::find_if(
      ports, [&](const port& each) { return each.is == port::role::strobe && each.writes == data.name; });
  return found == ports.end() ? nullptr : &*found;
}

/// Named markers A, B and C at the first write of a run, as the engines drive it: the trailing edge of the strobe that writes by
/// it, the clock edge that loads its register, and the leading edge of valid that confirms the results. ps; -1 is none.
std::vector<std::int64_t> markers(const std::vector<port>& ports, waves_of whose) {
  std::vector<std::int64_t> times(26, -1);
  if (protocol_of(ports) != protocol::strobes) return times;
  constexpr std::int64_t kHalfPeriod = 5000;
  // SystemC's host lets a cycle pass after the reset.
  const std::int64_t begin =
      2 * kHalfPeriod * (static_cast<std::int64_t>(kResetCycles) - (whose == waves_of::verilog ? 1 : 0));
  const std::int64_t settling = 2 * kHalfPeriod * ports[find_role(ports, port::role::valid)].settling_cycles;
  times[0] = begin + 3 * kHalfPeriod;
  times[1] = begin + 4 * kHalfPeriod;
  times[2] = begin + 5 * kHalfPeriod + settling;
  return times;
}

}  // namespace

std::string layout_text(const elaborated& device, const std::string& title, const std::string& root,
                        waves_of whose) {
  std::vector<port> ports;
  for (const auto& each : device.ports()) ports.push_back(each->what);
  rows out(root);
  const auto of = [&](port::role role) { return of_role(ports, role); };
  const auto name_of = [&](const port& of_port) -> const std::string& {
    return whose == waves_of::systemc ? of_port.wave : of_port.name;
  };

  out.begin("clock");
  for (const port::role role :
       {port::role::clock, port::role::reset, port::role::control, port::role::start, port::role::ready}) {
    for (const port& each : of(role)) out.add(name_of(each), {});
  }
  out.end("clock");
  std::vector<port> level, trailing;
  for (const port& each : of(port::role::data)) {
    const port* const strobe = strobe_of(ports, each);
    (strobe != nullptr && strobe->edge == write_edge::trailing ? trailing : level).push_back(each);
  }
  const auto add_writes = [&](const std::vector<port>& data, bool is_analogue) {
    for (const port& each : data) {
      if (const port* const strobe = strobe_of(ports, each)) out.add(name_of(*strobe), {});
      out.add(name_of(each), each.carries, "", is_analogue);
      out.add_value(value_name(each));
    }
  };
  std::string writing;
  for (const port& each : trailing) {
    if (const port* const strobe = strobe_of(ports, each))
      writing += fmt::format("{} writes by its trailing edge, ", name_of(*strobe));
  }
  const bool is_handshake = protocol_of(ports) == protocol::handshake;
  for (const port& each : of(port::role::valid))
    writing += fmt::format("{} confirms {}", name_of(each),
                           is_handshake ? "while it is at one" : "by its leading edge");
  const std::string held =
      is_handshake ? "taken while start and ready are at one" : "written while the strobe is at one";
  out.begin(writing);
  add_writes(trailing, true);
  for (const port& each : of(port::role::valid)) out.add(name_of(each), {});
  bool is_first = true;
  for (const port& each : of(port::role::result)) {
    if (!each.is_inner) {
      out.add(name_of(each), each.carries, "", is_first);
      is_first = false;
    }
    out.add_value(value_name(each));
  }
  // The room of an analogue trace would stay where waves lack the values.
  out.add_value(kErrorName, whose == waves_of::systemc);
  out.end(writing);
  out.begin(held);
  add_writes(level, false);
  out.end(held);

  out.begin("blocks");
  for (const sc_core::sc_module* module : in_order_of_data(device, registers_are::sources)) {
    const block& part = *device.parts().find(*module);
    for (const auto& [name, trace] : part.traces()) {
      const std::string path = device.path_of(*module);
      out.add(fmt::format("{}.{}", path, name), part.described(name).carries,
              part.traces().size() == 1 ? path : "");
    }
  }
  out.end("blocks");
  return fmt::format(
      "[*] SPDX-License-Identifier: Apache-2.0\n"
      "[*] GTKWave's layout for {}.\n"
      "[*] This file is generated; do not edit it.\n"
      "[timestart] 0\n"
      "[size] 1600 1000\n"
      "[pos] -1 -1\n"
      "*-15.500000 30000 {}\n"
      "[treeopen] {}.\n"
      "[sst_width] 60\n"
      "[signals_width] 190\n"
      "[sst_expanded] 0\n"
      "[sst_vpaned_height] 300\n"
      "{}",
      title, fmt::join(markers(ports, whose), " "), root, out.text());
}

}  // namespace blysk::netlist
