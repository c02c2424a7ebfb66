// SPDX-License-Identifier: Apache-2.0
/// The channel that the bench puts in the place of a device's nets: a signal until something stands behind it.
#pragma once

#include <cstdint>
#include <systemc>
#include <type_traits>

namespace blysk::netlist {

/// A wire whatever it carries.
class any_wire {
 public:
  /// Who takes what a block writes, in the place of the wire: it shows the value when it wants.
  class taker {
   public:
    virtual ~taker() = default;
    virtual void take(std::int64_t value) = 0;
  };

  virtual ~any_wire() = default;
  any_wire(const any_wire&) = delete;
  any_wire& operator=(const any_wire&) = delete;

  /// What the wire carries now, sign-extended if it is signed.
  virtual std::int64_t value() const = 0;

  /// From the next delta cycle on the wire carries this.
  virtual void show(std::int64_t value) = 0;

  /// What blocks write goes to the taker from now on; it outlives the simulation.
  void hand_to(taker& behind) { behind_ = &behind; }

 protected:
  any_wire() = default;

  taker* behind_ = nullptr;
};

/// A signal whose writes can be taken. Without a taker it is one like any other.
template <class T>
class wire final : public sc_core::sc_signal<T>, public any_wire {
 public:
  wire() : base(sc_core::sc_gen_unique_name("wire")) {}
  explicit wire(const char* name) : base(name) {}

  void write(const T& written) override {
    if (behind_ == nullptr) {
      base::write(written);
    } else {
      behind_->take(number(written));
    }
  }

  std::int64_t value() const override { return number(this->read()); }
  void show(std::int64_t shown) override {
    if constexpr (std::is_same_v<T, bool>) {
      base::write(shown != 0);
    } else {
      base::write(T(shown));
    }
  }

 private:
  using base = sc_core::sc_signal<T>;

  static std::int64_t number(const T& of) {
    if constexpr (std::is_same_v<T, bool>) {
      return of ? 1 : 0;
    } else {
      return of.to_int64();
    }
  }
};

/// The formats of a device whose nets are wires.
template <class Formats>
struct on_wires : Formats {
  template <class T>
  using channel = wire<T>;
};

}  // namespace blysk::netlist
