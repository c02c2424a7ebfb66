// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/stream.h"

#include <array>
#include <atomic>
#include <future>
#include <semaphore>

namespace blysk::cli {

std::uint64_t stream(stimulus_reader& stimulus, const std::function<void(row_block&)>& compute,
                     output_file& results, row_kind kind) {
  constexpr std::size_t kBlocks = 4;  // so that neither side waits for a thread to wake up
  std::array<row_block, kBlocks> ring;
  std::counting_semaphore<kBlocks> empty(kBlocks);
  std::counting_semaphore<kBlocks> full(0);
  std::atomic<bool> failed = false;

  auto writing = std::async(std::launch::async, [&] {
    try {
      fmt::memory_buffer text;
      fmt::format_to(std::back_inserter(text), "{}\n", results_header(stimulus.ports(), kind));
      for (std::size_t k = 0;; ++k) {
        full.acquire();
        const row_block& block = ring[k % kBlocks];
        append_rows(text, stimulus.ports(), block, kind);
        results.write({text.data(), text.size()});
        text.clear();
        if (block.writes.size() < kRowsPerBlock)
          results.flush();  // somebody may wait for these before he goes on
        if (block.writes.size() == 0) return;
        empty.release();
      }
    } catch (...) {
      failed = true;
      empty.release();
      throw;
    }
  });

  // A block of its own, copied: the other thread's processor has not touched it, and engines that store one result at
  // a time would wait for each line of memory to come back.
  row_block computed;
  std::uint64_t rows = 0;
  for (std::size_t k = 0;; ++k) {
    empty.acquire();
    if (failed) break;
    row_block& block = ring[k % kBlocks];
    try {
      stimulus.read(computed.writes);
      computed.first_line = rows;
      if (computed.writes.size() != 0) compute(computed);
      block = computed;
    } catch (...) {
      block.writes.resize(0);  // the end, for the writing thread
      full.release();
      throw;
    }
    full.release();
    if (computed.writes.size() == 0) break;
    rows += computed.writes.size();
  }
  writing.get();
  return rows;
}

}  // namespace blysk::cli
