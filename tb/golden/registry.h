// SPDX-License-Identifier: Apache-2.0
/// The golden functions by name: what `blysk model NAME` and `blysk list` are served from.
#pragma once

#include <span>
#include <string_view>

namespace blysk::golden {

struct model {
  std::string_view name;     ///< as in the command line, for example "quadratic-derived"
  std::string_view header;   ///< CSV columns of one point, for example "n,cos"
  std::string_view formula;  ///< one line
  std::string_view source;   ///< document and formula number

  /// \param inputs  one value per column of `header`, in its order
  /// \throws std::domain_error  the argument's name, its value and what was expected, in one line;
  ///                            also for NaN and for a wrong number of inputs
  double (*value)(std::span<const double> inputs);
};

/// Every model, in the order in which they are listed.
std::span<const model> models();

/// The model of that name, nullptr if there is none.
const model* find_model(std::string_view name);

}  // namespace blysk::golden
