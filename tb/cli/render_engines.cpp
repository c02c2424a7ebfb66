// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/render_engines.h"

#include <systemc>

#include "tb/render/effect_units.h"
#include "tb/render/spans.h"

namespace blysk::cli {

engine* job_engines::of_thread(unsigned thread) {
  if (choice_.name == "systemc") return systemc();
  while (made_.size() <= thread) made_.push_back(choice_.make(device_, cosim::waves::off));
  return made_[thread].get();
}

harness::systemc_engine* job_engines::systemc() {
  if (!systemc_) systemc_ = harness::make_systemc(device_);
  return systemc_.get();
}

std::uint64_t job_engines::cycles() const {
  std::uint64_t sum = systemc_ ? systemc_->cycles() : 0;
  for (const auto& each : made_) {
    if (const auto* clocked = dynamic_cast<const clocked_engine*>(each.get())) sum += clocked->cycles();
  }
  return sum;
}

unit_engine::unit_engine(const std::string& name, const selection& device)
    : engine(columns(device.of().ports(device), port::role::result).layout()) {
  if (name == "systemc") {
    auto made = harness::make_systemc(device);
    systemc_ = made.get();
    through_ = std::move(made);
  } else {
    through_ = cosim::make_verilator(device);
  }
}

void unit_engine::compute(const columns& in, columns& out) {
  const std::uint64_t before = through_->cycles();
  through_->run(in, out);
  cycles_ += through_->cycles() - before;
  // To the end of the cycle, where the other device begins.
  if (systemc_ != nullptr) sc_core::sc_start(sc_core::sc_time(harness::kClockPeriodNs / 2, sc_core::SC_NS));
}

asked_spans::asked_spans(const std::string& engine, const std::string& format) {
  if (engine == "host") return;
  const selection device = render::choose_span_device(format);
  if (engine == "bit") {
    model_ = device.of().make_bit(device);
  } else {
    hardware_ = std::make_unique<unit_engine>(engine, device);
  }
  source_ = render::attached_device{device, model_ ? model_.get() : hardware_.get(), engine};
}

asked_units::asked_units(const std::string& engine, bool is_normalised, const selection& shades) {
  if (engine == "bit") return;
  const selection device = render::choose_effect_units(shades.format(), is_normalised);
  render::expect_fitting({device, nullptr, engine}, shades);
  engine_ = std::make_unique<unit_engine>(engine, device);
  source_ = render::attached_device{device, engine_.get(), engine};
}

}  // namespace blysk::cli
