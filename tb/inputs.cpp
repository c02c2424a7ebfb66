// SPDX-License-Identifier: Apache-2.0
#include "tb/inputs.h"

#include <algorithm>
#include <bit>
#include <random>
#include <utility>

namespace blysk {
namespace {

constexpr std::size_t kBatch = 4096;
constexpr std::size_t kPortsADraw = 4;  // each takes other bits of it as its upper ones

/// Another draw of a sequence for each group of ports: a bijection, so that it visits all numbers too (the finish of
/// MurmurHash3). Group 0 has the sequence itself.
std::uint32_t draw_of(std::uint32_t sequence, std::size_t group) {
  if (group == 0) return sequence;
  std::uint32_t bits = sequence + static_cast<std::uint32_t>(group) * 0x9e3779b9u;
  bits = (bits ^ bits >> 16) * 0x85ebca6bu;
  bits = (bits ^ bits >> 13) * 0xc2b2ae35u;
  return bits ^ bits >> 16;
}

__extension__ typedef unsigned __int128 wide;  // NOLINT(modernize-use-using): __extension__ takes no alias

/// The codes of the enumerated ports.
std::vector<wire_format> enumerated_formats(const selection& asked) {
  std::vector<wire_format> formats;
  for (const port& each : of_role(asked.of().ports(asked), port::role::data))
    formats.push_back(*each.carries);
  formats.resize(std::min(formats.size(), asked.of().enumerated()));
  return formats;
}

std::uint64_t codes_of(const wire_format& format) {
  return static_cast<std::uint64_t>(format.max - format.min) + 1;
}

/// Calls use(codes) for every combination of the formats' legal codes, the last one's fastest.
template <class Use>
void for_each_code(std::span<const wire_format> formats, Use use) {
  std::vector<std::int64_t> codes;
  for (const wire_format& format : formats) codes.push_back(format.min);
  for (;;) {
    use(codes);
    std::size_t digit = codes.size();
    while (digit > 0 && codes[digit - 1] == formats[digit - 1].max) {
      codes[digit - 1] = formats[digit - 1].min;
      --digit;
    }
    if (digit == 0) return;
    ++codes[digit - 1];
  }
}

}  // namespace

batcher::batcher(const selection& asked, use_batch use)
    : data_(of_role(asked.of().ports(asked), port::role::data)),
      use_(std::move(use)),
      rows_(data_, port::role::data) {
  rows_.resize(kBatch);
}

void batcher::add(std::span<const std::int64_t> codes) {
  for (std::size_t i = 0; i < codes.size(); ++i) rows_[i].set(size_, codes[i]);
  sequence_ = sequence_ * 1664525u + 1013904223u;
  for (std::size_t i = codes.size(); i < data_.size(); ++i) {
    const wire_format& format = *data_[i].carries;
    const std::size_t beside = i - codes.size();
    // A sequence's upper bits are its best ones.
    const std::uint32_t bits =
        std::rotl(draw_of(sequence_, beside / kPortsADraw), static_cast<int>(beside % kPortsADraw) * 8);
    rows_[i].set(size_, format.min + static_cast<std::int64_t>(wide{bits} * codes_of(format) >> 32));
  }
  if (++size_ == kBatch) flush();
}

void batcher::flush() {
  if (size_ > 0) {
    rows_.resize(size_);
    use_(rows_);
  }
  size_ = 0;
  rows_.resize(kBatch);
}

std::uint64_t input_count(const selection& asked) {
  std::uint64_t count = 1;
  for (const wire_format& format : enumerated_formats(asked)) count *= codes_of(format);
  return count;
}

void for_all_inputs(const selection& asked, const use_batch& use) {
  batcher writes(asked, use);
  for_each_code(enumerated_formats(asked), [&](const auto& codes) { writes.add(codes); });
  writes.flush();
}

void for_random_inputs(const selection& asked, std::uint64_t count, std::uint64_t seed,
                       const use_batch& use) {
  batcher writes(asked, use);
  const std::vector<wire_format> formats = enumerated_formats(asked);
  std::mt19937_64 random(seed);
  std::vector<std::int64_t> codes(formats.size());
  for (; count > 0; --count) {
    for (std::size_t i = 0; i < formats.size(); ++i) {
      codes[i] = formats[i].min + static_cast<std::int64_t>(wide{random()} * codes_of(formats[i]) >> 64);
    }
    writes.add(codes);
  }
  writes.flush();
}

void for_corner_inputs(const selection& asked, std::int64_t reach, const use_batch& use) {
  batcher writes(asked, use);
  std::vector<wire_format> formats = enumerated_formats(asked);
  const wire_format last = formats.back();
  formats.pop_back();
  for_each_code(formats, [&](const std::vector<std::int64_t>& before) {
    std::vector<std::int64_t> corners = asked.of().corners(asked, before);
    corners.push_back(last.min);
    corners.push_back(last.max);
    std::vector<std::int64_t> codes = before;
    codes.push_back(0);
    for (const std::int64_t corner : corners) {
      for (std::int64_t code = std::max(last.min, corner - reach); code <= std::min(last.max, corner + reach);
           ++code) {
        codes.back() = code;
        writes.add(codes);
      }
    }
  });
  writes.flush();
}

}  // namespace blysk
