// SPDX-License-Identifier: Apache-2.0
#include "tb/render/spans.h"

#include <chrono>
#include <stdexcept>
#include <string_view>

namespace blysk::render {
namespace {

constexpr std::string_view kSpanColumns = "length,r0,g0,b0,r1,g1,b1";
constexpr std::string_view kResults = "red,green,blue";
enum : std::size_t { kLength, kFirst, kLast = kFirst + 3 };

}  // namespace

selection choose_span_device(const std::string& format) {
  for (const device* each : devices()) {
    selection chosen = choose(each->name(), format);
    const std::vector<port> ports = each->ports(chosen);
    if (each->draws_lines() && column_names(ports, port::role::data) == kSpanColumns &&
        column_names(ports, port::role::result) == kResults)
      return chosen;
  }
  throw std::logic_error("no device draws lines between two colours");
}

span_drawer::span_drawer(const attached_device& from, picture& to)
    : through_(*from.through), to_(to), inputs_(from.device.of().ports(from.device), port::role::data) {}

void span_drawer::add(int row, int left, int right, const colour& first, const colour& last) {
  lines_.push_back({row, left, right, first, last});
  if (lines_.size() >= kBatch) run();
}

void span_drawer::run() {
  if (lines_.empty()) return;
  inputs_.resize(lines_.size());
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const line& each = lines_[i];
    inputs_[kLength].set(i, each.right - each.left);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      inputs_[kFirst + channel].set(i, each.first[channel]);
      inputs_[kLast + channel].set(i, each.last[channel]);
    }
    pixels += static_cast<std::size_t>(each.right - each.left) + 1;
  }
  const auto started = std::chrono::steady_clock::now();
  through_.run(inputs_, outputs_);
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  if (outputs_.size() != pixels)
    throw std::logic_error("the device gave another number of pixels than its lines have");
  std::size_t next = 0;
  for (const line& each : lines_) {
    for (int x = each.left; x <= each.right; ++x, ++next) {
      for (std::size_t channel = 0; channel < 3; ++channel)
        to_.pixel(x, each.row)[channel] = static_cast<std::uint8_t>(outputs_[channel].get(next));
    }
  }
  drawn_ += lines_.size();
  lines_.clear();
}

}  // namespace blysk::render
