// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/delay_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <stdexcept>
#include <utility>

#include "tb/usage_error.h"

namespace blysk::harness {

using netlist::any_wire;

namespace {

constexpr picoseconds kNever = std::numeric_limits<picoseconds>::max();

std::uint64_t mask_of(int width) {
  return width == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << width) - 1;
}

std::string no_wires(const std::string& block) {
  return fmt::format(
      "the nets at block {} take no delays, expected wires of the bench; engine timed has no such device",
      block);
}

}  // namespace

picoseconds now_ps() {
  return sc_core::sc_time_stamp().value();  // SystemC's resolution is 1 ps
}

/// What stands behind one wire.
class delay_lines::line final : public any_wire::taker {
 public:
  line(delay_lines& owner, any_wire& output, const std::vector<input>& inputs,
       const std::vector<std::vector<int>>& ps)
      : owner_(owner),
        output_(output),
        mask_(mask_of(static_cast<int>(ps.size()))),
        sign_(std::uint64_t{1} << (ps.size() - 1)),
        inputs_(inputs),
        seen_(inputs.size()),
        until_(ps.size(), 0),
        active_(ps.size(), 0),
        is_register_(std::ranges::all_of(inputs, [](const input& each) { return each.wire == nullptr; })),
        shown_(static_cast<std::uint64_t>(output.value()) & mask_) {
    for (std::size_t from = 0; from < ps.front().size(); ++from) {
      std::vector<int>& row = reach_.emplace_back();
      for (const std::vector<int>& bit : ps) row.push_back(bit[from]);
    }
    output.hand_to(*this);
  }

  void take(std::int64_t value) override {
    const picoseconds now = now_ps();
    reached_.assign(until_.size(), block_delays::kNoPath);
    std::size_t first = 0;
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      for (std::uint64_t changed = changed_of(i); changed != 0; changed &= changed - 1) {
        const std::vector<int>& row = reach_[first + static_cast<std::size_t>(std::countr_zero(changed))];
        for (std::size_t bit = 0; bit < row.size(); ++bit) reached_[bit] = std::max(reached_[bit], row[bit]);
      }
      first += static_cast<std::size_t>(inputs_[i].width);
    }
    is_first_ = false;
    target_ = static_cast<std::uint64_t>(value) & mask_;
    pending_ = target_ ^ shown_;
    next_ = kNever;
    for (std::size_t bit = 0; bit < until_.size(); ++bit) {
      if (reached_[bit] >= 0)
        until_[bit] = std::max(until_[bit], now + static_cast<picoseconds>(reached_[bit]));
      if ((pending_ >> bit & 1) == 0) continue;
      next_ = std::min(next_, std::max(until_[bit], now));
      if (is_register_) active_[bit] = until_[bit];
    }
    owner_.arm(next_);
  }

  /// Shows the bits whose time has come.
  void show(picoseconds now) {
    if (next_ > now) return;
    std::uint64_t due = 0;
    next_ = kNever;
    for (std::uint64_t left = pending_; left != 0; left &= left - 1) {
      const int bit = std::countr_zero(left);
      const picoseconds at = until_[static_cast<std::size_t>(bit)];
      if (at <= now) {
        due |= std::uint64_t{1} << bit;
      } else {
        next_ = std::min(next_, at);
      }
    }
    pending_ &= ~due;
    shown_ ^= due;
    history_.changed_bits = due;
    history_.changed_at = now;
    // Of a signed wire the highest bit is the sign; the wire cuts what it does not carry.
    output_.show(static_cast<std::int64_t>((shown_ & sign_) != 0 ? shown_ | ~mask_ : shown_));
  }

  /// Until when each bit may change, from that of the inputs.
  /// \param driver  the line that stands behind a wire, or null
  template <class Driver>
  void find_activity(const Driver& driver) {
    if (!is_register_) {
      std::size_t first = 0;
      for (const input& each : inputs_) {
        const line* const from = driver(each.wire);
        for (std::size_t bit = 0; from != nullptr && bit < from->active_.size(); ++bit) {
          const picoseconds start = from->active_[bit];
          if (start == 0) continue;
          const std::vector<int>& row = reach_[first + bit];
          for (std::size_t to = 0; to < row.size(); ++to) {
            if (row[to] >= 0) active_[to] = std::max(active_[to], start + static_cast<picoseconds>(row[to]));
          }
        }
        first += static_cast<std::size_t>(each.width);
      }
    }
    history_.busy_until = std::ranges::max(active_);
  }

  const any_wire& output() const { return output_; }
  const wire_history& history() const { return history_; }
  picoseconds next() const { return next_; }

 private:
  /// The bits of an input that are others than at the last write.
  std::uint64_t changed_of(std::size_t i) {
    const auto [wire, width] = inputs_[i];
    if (wire == nullptr) return mask_of(width);
    const std::uint64_t value = static_cast<std::uint64_t>(wire->value()) & mask_of(width);
    const std::uint64_t before = std::exchange(seen_[i], value);
    return is_first_ ? mask_of(width) : value ^ before;
  }

  delay_lines& owner_;
  any_wire& output_;
  std::uint64_t mask_, sign_;
  std::vector<input> inputs_;
  std::vector<std::uint64_t> seen_;  // at the inputs when the block wrote last
  bool is_first_ = true;
  std::vector<std::vector<int>> reach_;  // [bit of the inputs][bit of the output], ps
  std::vector<int> reached_;             // the same for all that has changed now
  std::vector<picoseconds> until_;       // what each bit waits for
  std::vector<picoseconds> active_;      // until when each may change between values
  bool is_register_;
  std::uint64_t shown_;
  std::uint64_t target_ = 0;
  std::uint64_t pending_ = 0;  // bits that are to change
  picoseconds next_ = kNever;
  wire_history history_;
};

delay_lines::delay_lines(const sc_core::sc_module_name& name) : sc_core::sc_module(name) {
  if (sc_core::sc_get_time_resolution() != sc_core::sc_time(1, sc_core::SC_PS))
    throw std::logic_error("delays are counted in ps, and so is SystemC's time");
  SC_METHOD(show_due);
  sensitive << due_;
  dont_initialize();
}

delay_lines::~delay_lines() = default;

void delay_lines::delay(const netlist::elaborated& device, const device_delays& delays) {
  device_ = &device;
  delays_ = &delays;
}

void delay_lines::delay(any_wire& output, const std::vector<input>& inputs,
                        const std::vector<std::vector<int>>& ps) {
  lines_.push_back(std::make_unique<line>(*this, output, inputs, ps));
  drivers_[&output] = lines_.back().get();
}

void delay_lines::end_of_elaboration() {
  if (device_ == nullptr) return;
  for (const sc_core::sc_module* module : in_order_of_data(*device_, netlist::registers_are::sources)) {
    std::map<std::string, any_wire*> wires;
    const netlist::block& part = *device_->parts().find(*module);
    const std::string path = device_->path_of(*module);
    bool has_inputs = false;
    for (const sc_core::sc_port_base* port : netlist::ports_of_module(*module)) {
      auto* const channel =
          const_cast<sc_core::sc_port_base*>(port)->get_interface();  // what is bound is no part of it
      wires[port->basename()] = dynamic_cast<any_wire*>(channel);
      has_inputs |= part.described(port->basename()).where == netlist::declaration::role::input;
    }
    if (!has_inputs) continue;  // a constant
    const auto found = std::ranges::find(delays_->blocks, path, &block_delays::block);
    if (found == delays_->blocks.end())
      throw file_error(delays_->file, 0, fmt::format("has no block {}, expected its delays", path));
    const auto wire_of = [&](const timed_pin& pin) {
      const auto wire = wires.find(pin.name);
      if (wire == wires.end() || part.described(pin.name).bits.width != pin.width)
        throw file_error(delays_->file, 0,
                         fmt::format("has {}.{} of {} bits, expected a pin of device {}", path, pin.name,
                                     pin.width, delays_->device));
      return wire->second;
    };
    std::vector<input> inputs;
    for (const timed_pin& pin : found->inputs) {
      // What a register writes follows its clock, and of that there are delays alone.
      const any_wire* const wire = part.registers().empty() ? wire_of(pin) : nullptr;
      if (wire == nullptr && part.registers().empty()) throw std::invalid_argument(no_wires(path));
      inputs.push_back({wire, pin.width});
    }
    for (std::size_t i = 0; i < found->outputs.size(); ++i) {
      any_wire* const wire = wire_of(found->outputs[i]);
      if (wire == nullptr) throw std::invalid_argument(no_wires(path));
      delay(*wire, inputs, found->ps[i]);
    }
  }
}

const wire_history& delay_lines::history(const any_wire& of) const {
  const auto found = std::ranges::find(lines_, &of, [](const auto& each) { return &each->output(); });
  if (found == lines_.end()) throw std::invalid_argument("a wire has no delays");
  return (*found)->history();
}

void delay_lines::find_activity() {
  const auto driver = [this](const any_wire* wire) -> const line* {
    const auto found = drivers_.find(wire);
    return found == drivers_.end() ? nullptr : found->second;
  };
  for (const auto& each : lines_) each->find_activity(driver);
}

picoseconds delay_lines::next() const {
  picoseconds earliest = kNever;
  for (const auto& each : lines_) earliest = std::min(earliest, each->next());
  return earliest;
}

void delay_lines::show_due() {
  armed_ = kNever;
  const picoseconds now = now_ps();
  for (const auto& each : lines_) each->show(now);
  arm(next());
}

void delay_lines::arm(picoseconds at) {
  if (at >= armed_) return;
  armed_ = at;
  due_.cancel();
  const picoseconds now = now_ps();
  if (at <= now) {
    due_.notify(sc_core::SC_ZERO_TIME);
  } else {
    due_.notify(sc_core::sc_time(static_cast<double>(at - now), sc_core::SC_PS));
  }
}

}  // namespace blysk::harness
