// SPDX-License-Identifier: Apache-2.0
#include "tb/cosim/strobes.h"

#include <algorithm>

namespace blysk::cosim {

strobe_sequence::strobe_sequence(const selection& asked, codes which) : ports_(asked.of().ports(asked)) {
  const std::size_t enumerated = asked.of().enumerated();
  for (const port& each : ports_) {
    if (each.is != port::role::data) continue;
    const auto strobe = std::ranges::find_if(
        ports_, [&](const port& of) { return of.is == port::role::strobe && of.writes == each.name; });
    const wire_format& format = *each.carries;
    channel added{static_cast<std::size_t>(&each - ports_.data()),
                  static_cast<std::size_t>(strobe - ports_.begin()),
                  strobe != ports_.end() && strobe->edge == write_edge::trailing,
                  format.min,
                  format.max,
                  spread::even};
    if (which == codes::all) {
      const int magnitude = format.width() - (format.is_signed ? 1 : 0);
      added.max = static_cast<std::int64_t>((std::uint64_t{1} << magnitude) - 1);
      added.min = format.is_signed ? -added.max - 1 : 0;
    }
    // Of the ports that tests enumerate, integers are exponents and fractions cosines.
    if (channels_.size() < enumerated) added.likely = format.frac == 0 ? spread::small : spread::large;
    channels_.push_back(added);
  }
}

void strobe_sequence::next(std::span<std::int64_t> levels) {
  if (cycle_ % 16 == 0) {
    pattern_ = static_cast<pattern>(random_() % 4);
    unwritten_ = cycle_ % kResetEvery == 0 ? random_() % (channels_.size() + 1) : 0;
  }
  const std::uint64_t reset_cycles = cycle_ / kResetEvery % 2 == 0 ? 2 : 1;
  for (std::size_t i = 0; i < ports_.size(); ++i) {
    if (ports_[i].is == port::role::reset) levels[i] = cycle_ % kResetEvery >= reset_cycles ? 1 : 0;
    if (ports_[i].is == port::role::control || ports_[i].is == port::role::start) levels[i] = bit() ? 1 : 0;
  }
  for (const channel& each : channels_) levels[each.data] = code(each);
  const bool toggled = cycle_ % 2 == 0;
  const auto strobe = [&](bool is_trailing) {
    switch (pattern_) {
      case pattern::quiet:
        return false;
      case pattern::together:
        return toggled;
      case pattern::back_to_back:
        return is_trailing ? toggled : bit();
      case pattern::any:
        break;
    }
    return bit();
  };
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const channel& each = channels_[i];
    if (each.strobe < levels.size())
      levels[each.strobe] = strobe(each.is_trailing) && unwritten_ != i + 1 ? 1 : 0;
  }
  ++cycle_;
}

// Small exponents are as frequent as large ones, whose lobes are so narrow that most cosines lie beyond. Every fourth
// cosine lies within 64 codes of the largest, where the lobe of a large exponent is.
std::int64_t strobe_sequence::code(const channel& of) {
  const std::uint64_t codes = static_cast<std::uint64_t>(of.max - of.min) + 1;  // 0 for all of 64 bits
  const auto below = [&](std::uint64_t count) { return count == 0 ? random_() : random_() % count; };
  switch (of.likely) {
    case spread::small: {
      int bits = 0;
      while (bits < 63 && (std::uint64_t{1} << bits) < codes) ++bits;
      const std::uint64_t reach = std::uint64_t{1} << random_() % static_cast<unsigned>(bits + 1);
      return std::min(of.min + static_cast<std::int64_t>(below(reach)), of.max);
    }
    case spread::large: {
      const bool is_near = random_() % 4 == 0;
      const std::uint64_t reach = is_near && codes > 64 ? 64 : codes;
      return of.max - static_cast<std::int64_t>(below(reach));
    }
    case spread::even:
      break;
  }
  return of.min + static_cast<std::int64_t>(below(codes));
}

void play_strobes(verilator_engine& verilog, const selection& asked,
                  const std::function<bool(std::span<const std::int64_t>)>& use, codes which) {
  strobe_sequence strobes(asked, which);
  std::vector<std::int64_t> levels(strobes.ports().size(), 0);
  const auto clock = find_role(strobes.ports(), port::role::clock);
  for (int cycle = 0; cycle < kStrobeCycles; ++cycle) {
    strobes.next(levels);
    for (const bool clk : {false, true}) {
      levels[clock] = clk ? 1 : 0;
      verilog.apply(levels);
      const bool is_reset = cycle > 0 || clk;
      if (is_reset && !use(levels)) return;
    }
  }
}

}  // namespace blysk::cosim
