// SPDX-License-Identifier: Apache-2.0
/// Engines on the classes that Verilator makes. What tells one class from another is its glue, which verilated_glue
/// writes from the device's ports.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "tb/cosim/recording.h"
#include "tb/cosim/verilator_engine.h"

namespace blysk::cosim {

/// A port of a Verilated class: Verilator stores the Width bits of either sign in an unsigned integer.
/// \tparam Index  in device::ports()
template <std::size_t Index, int Width, bool IsSigned>
struct wire {
  static constexpr std::size_t index = Index;

  template <class Member>
  static std::int64_t read(const Member& member) {
    if constexpr (IsSigned) {
      return static_cast<std::int64_t>(static_cast<std::uint64_t>(member) << (64 - Width)) >> (64 - Width);
    } else {
      return static_cast<std::int64_t>(member);
    }
  }

  template <class Member>
  static void write(Member& member, std::int64_t value) {
    constexpr std::uint64_t kMask = ~std::uint64_t{0} >> (64 - Width);
    member = static_cast<Member>(static_cast<std::uint64_t>(value) & kMask);
  }
};

/// The same with the column of its numbers.
template <std::size_t Index, int Width, bool IsSigned, std::size_t Column, class Element>
struct field : wire<Index, Width, IsSigned> {
  static constexpr std::size_t column = Column;
  using element = Element;
};

/// Engine on a Verilated class.
/// \tparam Glue  see verilated_glue.cpp
template <class Glue, class Base = verilator_engine>
class verilated : public Base {
 public:
  verilated() : Base(std::vector<storage>(Glue::kResultStorage.begin(), Glue::kResultStorage.end())) {}

  void apply(std::span<std::int64_t> levels) override {
    glue_.inputs([&]<class Wire>(Wire, auto& member) { Wire::write(member, levels[Wire::index]); });
    glue_.top.eval();
    glue_.outputs([&]<class Wire>(Wire, const auto& member) { levels[Wire::index] = Wire::read(member); });
  }

  std::uint64_t cycles() const override { return cycles_; }
  std::uint64_t writes() const override { return writes_; }

  void trace(const std::string& path) override {
    if constexpr (kIsRecorded) {
      recording_ = this->make_recording(path);
      glue_.record(recording_->waves());
      recording_->open();
    } else {
      throw std::logic_error("no waves of this class can be recorded");
    }
  }

  bool stop_trace() override {
    if constexpr (kIsRecorded) {
      if (!recording_) return true;
      if (recording_->is_empty()) {
        glue_.top.eval();
        show();
      }
      const bool is_whole = recording_->close();
      recording_.reset();
      return is_whole;
    } else {
      return true;
    }
  }

 protected:
  Glue glue_;

 private:
  static constexpr bool kIsRecorded = requires(Glue & glue, VerilatedVcdC& waves) { glue.record(waves); };

  void compute(const columns& in, columns& out) override {
    if constexpr (Glue::kProtocol == protocol::none) {
      throw std::logic_error("the device's ports are not those of a protocol");
    } else {
      point_at(in, out);
      if (cycles_ == 0) reset();
      glue_.reset() = 1;
      if constexpr (Glue::kProtocol == protocol::strobes) {
        write_by_strobes(in.size());
      } else {
        shake_hands(in.size(), out);
      }
    }
  }

  void write_by_strobes(std::size_t rows) {
    for (std::size_t i = 0; i < rows; ++i) {
      lead();
      glue_.trailing([&](auto channel, auto& data, auto&) { put(channel, data, i); });
      fall();
      if (i > 0) capture(i - 1);
      finish_cycle();
      trail();
      glue_.level([&](auto channel, auto& data, auto& strobe) {
        put(channel, data, i);
        strobe = 1;
      });
      fall();
      finish_cycle();
      settle();
    }
    lead();
    fall();
    if (rows > 0) capture(rows - 1);
    finish_cycle();
    trail();
    fall();
    finish_cycle();
    settle();
    writes_ += rows + 1;
  }

  // A row is offered as soon as the device is ready, and taken at the next rising edge.
  void shake_hands(std::size_t rows, columns& out) {
    std::size_t taken = 0;
    std::size_t delivered = 0;
    int idle = 0;              // cycles in which the device had nothing to take
    std::uint64_t waited = 0;  // cycles since it took a row
    while (idle <= Glue::kSettlingCycles) {
      finish_cycle();
      clock(false);
      if (++waited > kPatienceCycles)
        throw std::runtime_error("the device takes no row any more and does not come to its end");
      if (glue_.valid() != 0) {
        if (delivered == out.size()) {
          out.resize(2 * delivered + 1);
          point_at(out);
        }
        capture(delivered++);
      }
      if (glue_.start() != 0) {
        ++taken;
        waited = 0;
      }
      const bool is_offered = glue_.ready() != 0 && taken < rows;
      if (is_offered) glue_.data([&](auto field, auto& data) { put(field, data, taken); });
      glue_.start() = is_offered ? 1 : 0;
      glue_.top.eval();
      show();
      idle = glue_.ready() != 0 && taken == rows ? idle + 1 : 0;
    }
    out.resize(delivered);
    writes_ += taken;
  }

  void point_at(const columns& in, columns& out) {
    glue_.data([&]<class Field>(Field, const auto&) {
      sources_[Field::column] = in[Field::column].template data<typename Field::element>();
    });
    point_at(out);
  }

  void point_at(columns& out) {
    glue_.results([&]<class Field>(Field, const auto&) {
      targets_[Field::column] = out[Field::column].template data<typename Field::element>();
    });
  }

  void clock(bool level) {
    glue_.clock() = level;
    glue_.top.eval();
  }

  void fall() {
    clock(false);
    show();
  }

  void finish_cycle() {
    clock(true);
    show();
    ++cycles_;
  }

  void show() {
    if constexpr (kIsRecorded) {
      if (!recording_) return;
      levels_.resize(Glue::kPorts);
      const auto read = [&]<class Wire>(Wire, const auto& member) {
        levels_[Wire::index] = Wire::read(member);
      };
      glue_.inputs(read);
      glue_.outputs(read);
      recording_->sample(levels_);
    }
  }

  void reset() {
    glue_.inputs([]<class Wire>(Wire, auto& member) { Wire::write(member, 0); });
    glue_.top.eval();
    for (std::uint64_t i = 0; i < kResetCycles; ++i) {
      finish_cycle();
      clock(false);
      // The last half period goes on where a row is written by strobes.
      if (i + 1 < kResetCycles || Glue::kProtocol == protocol::handshake) show();
    }
  }

  // The first half of a write: the strobe that writes by its trailing edge goes up, which confirms what the write before
  // has made.
  void lead() {
    glue_.trailing([](auto, auto&, auto& strobe) { strobe = 1; });
    glue_.level([](auto, auto&, auto& strobe) { strobe = 0; });
  }

  // The second half: it goes down, the other strobes go up, so that all registers change at one edge of clk.
  void trail() {
    glue_.trailing([](auto, auto&, auto& strobe) { strobe = 0; });
  }

  // The cycles more that the results need.
  void settle() {
    for (int cycle = 0; cycle < Glue::kSettlingCycles; ++cycle) {
      glue_.level([](auto, auto&, auto& strobe) { strobe = 0; });
      fall();
      finish_cycle();
    }
  }

  template <class Field, class Member>
  void put(Field, Member& member, std::size_t row) {
    Field::write(member, static_cast<std::int64_t>(
                             static_cast<const typename Field::element*>(sources_[Field::column])[row]));
  }

  void capture(std::size_t row) {
    glue_.results([&]<class Field>(Field, const auto& member) {
      using element = typename Field::element;
      static_cast<element*>(targets_[Field::column])[row] = static_cast<element>(Field::read(member));
    });
  }

  std::array<const void*, Glue::kDataColumns> sources_{};
  std::array<void*, Glue::kResultStorage.size()> targets_{};
  std::conditional_t<kIsRecorded, std::unique_ptr<recording>, std::monostate> recording_;
  std::vector<std::int64_t> levels_;  // of a recorded class
  std::uint64_t cycles_ = 0;
  std::uint64_t writes_ = 0;
};

}  // namespace blysk::cosim
