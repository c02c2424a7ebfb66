// SPDX-License-Identifier: Apache-2.0
#include "tb/netlist/layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace blysk::netlist {
namespace {

/// Rows of a .gtkw file. The flags of a row are those of GTKWave's analyzer.h.
class rows {
 public:
  explicit rows(const std::string& root) : root_(root) {}

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
    if (is_analogue) text_ += "@20000\n-\n-\n-\n";  // its height
  }

  const std::string& text() const { return text_; }

 private:
  static constexpr unsigned kDecimal = 0x24;  // to the right, as the others
  static constexpr unsigned kSigned = 0x420;
  static constexpr unsigned kAnalogue = 0x8000;
  static constexpr unsigned kFixedPoint = 0x40000000;

  std::string root_;
  std::string text_;
};

const port* strobe_of(const std::vector<port>& ports, const port& data) {
  const auto found = std::ranges::find_if(
      ports, [&](const port& each) { return each.is == port::role::strobe && each.writes == data.name; });
  return found == ports.end() ? nullptr : &*found;
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
    if (each.is_inner) continue;
    out.add(name_of(each), each.carries, "", is_first);
    is_first = false;
  }
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
      "*-15.500000 30000{}\n"
      "[treeopen] {}.\n"
      "[sst_width] 60\n"
      "[signals_width] 190\n"
      "[sst_expanded] 0\n"
      "[sst_vpaned_height] 300\n"
      "{}",
      title,
      [] {
        std::string marks;
        for (int i = 0; i < 27; ++i) marks += " -1";
        return marks;
      }(),
      root, out.text());
}

}  // namespace blysk::netlist
