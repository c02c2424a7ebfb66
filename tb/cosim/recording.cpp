// SPDX-License-Identifier: Apache-2.0
#include "tb/cosim/recording.h"

#include <verilated_vcd_c.h>

#include <fstream>
#include <utility>

#include "tb/harness/systemc_engine.h"

namespace blysk::cosim {

namespace {

constexpr auto kHalfPeriodPs = static_cast<std::uint64_t>(harness::kClockPeriodNs * 1e3 / 2);

}  // namespace

/// What Verilator writes, the comment before it.
class recording::file : public VerilatedVcdFile {
 public:
  explicit file(std::string head) : head_(std::move(head)) {}

  bool open(const std::string& name) override {
    text_.open(name, std::ios::binary);
    text_ << head_;
    return true;  // a file that cannot be written is told of at its end
  }
  void close() override { text_.close(); }
  ssize_t write(const char* text, ssize_t size) override {
    text_.write(text, size);
    return size;
  }

  bool is_whole() const { return text_.good(); }

 private:
  std::string head_;
  std::ofstream text_;
};

recording::recording(std::string path, const std::string& comment)
    : path_(std::move(path)), file_(std::make_unique<file>("$comment\n" + comment + "\n$end\n")) {
  Verilated::traceEverOn(true);
  waves_ = std::make_unique<VerilatedVcdC>(file_.get());
}

recording::~recording() = default;

void recording::open() {
  waves_->set_time_unit("1ps");
  waves_->set_time_resolution("1ps");
  waves_->open(path_.c_str());
}

void recording::sample() {
  waves_->dump(time_ps_);
  time_ps_ += kHalfPeriodPs;
}

bool recording::close() {
  waves_->close();
  return file_->is_whole();
}

}  // namespace blysk::cosim
