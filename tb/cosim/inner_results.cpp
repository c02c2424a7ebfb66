// SPDX-License-Identifier: Apache-2.0
#include "tb/cosim/inner_results.h"

#include <algorithm>
#include <stdexcept>

namespace blysk::cosim {

inner_results::inner_results(const selection& asked)
    : asked_(asked),
      data_(of_role(asked.of().ports(asked), port::role::data)),
      model_(asked.of().make_bit(asked)) {
  find_columns();
  find_inner_results();
}

void inner_results::find_columns() {
  const std::vector<port> results = of_role(asked_.of().ports(asked_), port::role::result);
  std::vector<std::size_t> inner;
  for (std::size_t i = 0; i < results.size(); ++i) (results[i].is_inner ? inner : outer_).push_back(i);
  if (inner.size() != 1 || outer_.empty())
    throw std::invalid_argument(asked_.text() + " cannot be tried, expected a device with one inner result");
  inner_ = inner.front();
}

/// An input for each inner result that occurs, and what the results are there.
void inner_results::find_inner_results() {
  for_all_inputs(asked_, [&](const columns& in) {
    const vectors all = with_results(at_largest(in));
    for (std::size_t row = 0; row < in.size(); ++row) {
      const std::int64_t inner = all.expected[inner_].get(row);
      if (inputs_.contains(inner)) continue;
      std::vector<std::int64_t> codes;
      for (const column& each : in) codes.push_back(each.get(row));
      inputs_[inner] = codes;
      if (!seen_.insert(outer_results(all.expected, row)).second)
        throw std::runtime_error(
            "two inner results give the same results, expected the largest codes to tell them apart");
    }
  });
}

vectors inner_results::with_results(const columns& in) {
  vectors result{in, {}};
  model_->run(in, result.expected);
  return result;
}

columns inner_results::at_largest(columns in) const {
  for (std::size_t i = asked_.of().enumerated(); i < data_.size(); ++i) {
    for (std::size_t row = 0; row < in.size(); ++row) in[i].set(row, data_[i].carries->max);
  }
  return in;
}

std::vector<std::int64_t> inner_results::outer_results(const columns& out, std::size_t row) const {
  std::vector<std::int64_t> codes;
  for (const std::size_t each : outer_) codes.push_back(out[each].get(row));
  return codes;
}

void inner_results::for_others(const use_batch& use) const {
  constexpr std::size_t kBatch = 4096;
  const std::size_t enumerated = asked_.of().enumerated();
  std::int64_t most = 1;
  for (std::size_t i = enumerated; i < data_.size(); ++i)
    most = std::max(most, data_[i].carries->max - data_[i].carries->min + 1);
  columns in(data_, port::role::data);
  in.resize(kBatch);
  std::size_t row = 0;
  const auto flush = [&] {
    in.resize(row);
    if (row > 0) use(in);
    in.resize(kBatch);
    row = 0;
  };
  for (const auto& [inner, codes] : inputs_) {
    for (std::int64_t step = 0; step < most; ++step) {
      for (std::size_t i = 0; i < data_.size(); ++i) {
        const wire_format& format = *data_[i].carries;
        in[i].set(row, i < enumerated ? codes[i] : format.min + step % (format.max - format.min + 1));
      }
      if (++row == kBatch) flush();
    }
  }
  flush();
}

}  // namespace blysk::cosim
