// SPDX-License-Identifier: Apache-2.0
#include "tb/cosim/recording.h"

#include <fmt/format.h>
#include <verilated_vcd_c.h>

#include <fstream>
#include <utility>

#include "tb/cosim/verilator_engine.h"
#include "tb/harness/arguments.h"
#include "tb/harness/systemc_engine.h"

namespace blysk::cosim {

namespace {

constexpr auto kHalfPeriodPs = static_cast<std::uint64_t>(harness::kClockPeriodNs * 1e3 / 2);

/// Code of a value in the file. Verilator counts its codes up, in as few signs as do: none of a design is that long.
std::string code_of(std::size_t value) {
  return fmt::format("value{}", value);
}

std::string declarations_of(const std::vector<std::string>& values) {
  std::string text = fmt::format("$scope module TOP $end\n$scope module {} $end\n", kValueScope);
  for (std::size_t i = 0; i < values.size(); ++i)
    text += fmt::format("$var real 64 {} {} $end\n", code_of(i), values[i]);
  return text + "$upscope $end\n$upscope $end\n";
}

}  // namespace

/// What Verilator writes, a comment before it and further declarations at the end of its header.
class recording::file : public VerilatedVcdFile {
 public:
  file(std::string comment, std::string declarations)
      : head_(std::move(comment)), declarations_(std::move(declarations)) {}

  bool open(const std::string& name) override {
    text_.open(name, std::ios::binary);
    return true;  // a file that cannot be written is told of at its end
  }
  void close() override { text_.close(); }
  ssize_t write(const char* text, ssize_t size) override {
    if (is_header_) {
      head_.append(text, static_cast<std::size_t>(size));
      const std::size_t end = head_.find("$enddefinitions");
      if (end == std::string::npos) return size;
      text_ << head_.insert(end, declarations_);
      is_header_ = false;
    } else {
      text_.write(text, size);
    }
    return size;
  }
  void append(const std::string& text) { text_ << text; }

  bool is_whole() const { return text_.good(); }

 private:
  std::string head_, declarations_;
  std::ofstream text_;
  bool is_header_ = true;
};

recording::recording(std::string path, const std::string& comment, std::size_t clock, wave_values values)
    : path_(std::move(path)),
      file_(std::make_unique<file>("$comment\n" + comment + "\n$end\n", declarations_of(values.names()))),
      clock_(clock),
      values_(std::move(values)) {
  Verilated::traceEverOn(true);
  waves_ = std::make_unique<VerilatedVcdC>(file_.get());
}

recording::~recording() = default;

void recording::open() {
  waves_->set_time_unit("1ps");
  waves_->set_time_resolution("1ps");
  waves_->open(path_.c_str());
}

void recording::sample(std::span<const std::int64_t> levels) {
  waves_->dump(time_ps_);
  waves_->flush();
  write_values(levels);
  time_ps_ += kHalfPeriodPs;
}

void recording::write_values(std::span<const std::int64_t> levels) {
  if (!before_.empty() && levels[clock_] > before_[clock_]) values_.rise(before_);
  before_.assign(levels.begin(), levels.end());
  const std::span<const double> now = values_.at(levels);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!written_.empty() && written_[i] == now[i]) continue;
    const int digits = i + 1 < now.size() ? 16 : 6;  // as the waves of SystemC have them
    file_->append(fmt::format("r{:.{}g} {}\n", now[i], digits, code_of(i)));
  }
  written_.assign(now.begin(), now.end());
}

bool recording::close() {
  waves_->close();
  return file_->is_whole();
}

std::unique_ptr<recording> verilator_engine::make_recording(const std::string& path) const {
  const selection& asked = asked_.value();
  const std::vector<port> ports = asked.of().ports(asked);
  return std::make_unique<recording>(path, harness::kWaveComment + harness::arguments_of(asked),
                                     find_role(ports, port::role::clock),
                                     wave_values(ports, asked.of().make_golden(asked)));
}

}  // namespace blysk::cosim
