// SPDX-License-Identifier: Apache-2.0
/// The engines that `blysk render` runs, made when a scene has use for them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tb/cli/engines.h"
#include "tb/engine.h"
#include "tb/harness/systemc_engine.h"
#include "tb/render/attached_device.h"

namespace blysk::cli {

/// Engines of a job, each made when the plan has use for it: SystemC elaborates once, and only what is needed.
class job_engines {
 public:
  /// \param choice, device  outlive the object
  job_engines(const engine_choice& choice, const selection& device) : choice_(choice), device_(device) {}

  engine* of_thread(unsigned thread);
  harness::systemc_engine* systemc();

  /// Of all that have a clock.
  std::uint64_t cycles() const;

 private:
  const engine_choice& choice_;
  const selection& device_;
  std::vector<std::unique_ptr<engine>> made_;
  std::unique_ptr<harness::systemc_engine> systemc_;
};

/// A device in hardware beside the one that makes the highlights, with a count of the cycles of its own runs: in SystemC its
/// clock goes on while the other one runs.
class unit_engine final : public engine {
 public:
  /// \param name  of the engine: systemc or verilator
  unit_engine(const std::string& name, const selection& device);

  harness::systemc_engine* systemc() { return systemc_; }
  std::uint64_t cycles() const { return cycles_; }

 private:
  void compute(const columns& in, columns& out) override;

  std::unique_ptr<clocked_engine> through_;
  harness::systemc_engine* systemc_ = nullptr;
  std::uint64_t cycles_ = 0;
};

/// What --spans asks for; nothing where the host interpolates.
class asked_spans {
 public:
  /// \param engine  host, bit, systemc or verilator
  asked_spans(const std::string& engine, const std::string& format);

  const render::attached_device* source() const { return source_ ? &*source_ : nullptr; }
  std::uint64_t cycles() const { return hardware_ ? hardware_->cycles() : 0; }

 private:
  std::unique_ptr<engine> model_;
  std::unique_ptr<unit_engine> hardware_;
  std::optional<render::attached_device> source_;
};

/// What --units asks for; nothing where the host adds up the effects.
class asked_units {
 public:
  /// \param engine         bit, the host, systemc or verilator
  /// \param is_normalised  the specular terms have an energy factor
  /// \param shades         the device that makes the highlights
  asked_units(const std::string& engine, bool is_normalised, const selection& shades);

  const render::attached_device* source() const { return source_ ? &*source_ : nullptr; }
  harness::systemc_engine* systemc() { return engine_->systemc(); }
  std::uint64_t cycles() const { return engine_ ? engine_->cycles() : 0; }

 private:
  std::unique_ptr<unit_engine> engine_;
  std::optional<render::attached_device> source_;
};

}  // namespace blysk::cli
