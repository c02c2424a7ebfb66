// SPDX-License-Identifier: Apache-2.0
// Compiled once for each named format, BLYSK_FORMAT.
#include "tb/bench/quadratic_bench.h"

namespace blysk::bench {
namespace {

template <class F>
class quadratic_engine final : public systemc_engine {
 public:
  explicit quadratic_engine(const wired_constants& wired) : host_("bench", wired) {}
  ~quadratic_engine() override { quadratic_engine::stop_trace(); }

  void run(const batch& in, results& out) override { host_.run(in, out); }

  void trace(const std::string& path) override {
    path_ = path + ".vcd";
    file_ = sc_core::sc_create_vcd_trace_file(path.c_str());
    file_->set_time_unit(1, sc_core::SC_PS);
    host_.pins.record(file_);
  }

  bool stop_trace() override {
    if (file_ == nullptr) return true;
    sc_core::sc_close_vcd_trace_file(file_);
    file_ = nullptr;
    return ends_at(path_, sc_core::sc_time_stamp());
  }

  std::uint64_t cycles() const override { return host_.cycles(); }
  std::uint64_t writes() const override { return host_.writes(); }

 private:
  quadratic_host<F> host_;
  sc_core::sc_trace_file* file_ = nullptr;
  std::string path_;
};

}  // namespace

template <>
std::unique_ptr<systemc_engine> make_quadratic<BLYSK_FORMAT, lobe::clamped>(const wired_constants& wired) {
  return std::make_unique<quadratic_engine<quadratic_formats<BLYSK_FORMAT, lobe::clamped>>>(wired);
}

template <>
std::unique_ptr<systemc_engine> make_quadratic<BLYSK_FORMAT, lobe::as_published>(
    const wired_constants& wired) {
  return std::make_unique<quadratic_engine<quadratic_formats<BLYSK_FORMAT, lobe::as_published>>>(wired);
}

}  // namespace blysk::bench
