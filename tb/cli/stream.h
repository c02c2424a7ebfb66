// SPDX-License-Identifier: Apache-2.0
/// Rows from a CSV file through a computation into another, in constant memory.
#pragma once

#include <cstdint>
#include <functional>

#include "tb/cli/rows.h"
#include "tb/output_file.h"

namespace blysk::cli {

/// Writes the header and a row for each of the stimulus, in a thread of its own beside reading and `compute`, which run
/// in the calling one. Rows that were read are computed and handed on before more input is waited for.
/// \return  how many rows there were
/// \throws usage_error if the stimulus is wrong or the results cannot be written; they are then not complete
std::uint64_t stream(stimulus_reader& stimulus, const std::function<void(row_block&)>& compute,
                     output_file& results, row_kind kind = row_kind::writes);

}  // namespace blysk::cli
