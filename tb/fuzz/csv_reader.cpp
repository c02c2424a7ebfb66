// SPDX-License-Identifier: Apache-2.0
// The CSV reader: the first byte chooses the wanted columns, the rest is the file. Whatever is in it, every row has the
// wanted fields or is refused.
#include "tb/csv_reader.h"

#include <algorithm>
#include <array>

#include "tb/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace blysk;
  if (size == 0) return 0;
  constexpr std::array<const char*, 3> headers{"n", "n,cos", "n,cos,r,g,b"};
  const std::string header = headers.at(data[0] % headers.size());
  const auto wanted = static_cast<std::size_t>(1 + std::ranges::count(header, ','));
  const fuzz::memory_file file(fuzz::text_of(data + 1, size - 1));
  try {
    csv_reader rows(file.path(), header);
    std::size_t count = 0;
    while (count % 2 == 0 ? rows.next() : rows.next_at_hand()) {
      ++count;
      fuzz::expect(rows.fields().size() == wanted, "a row has other fields than the wanted ones");
      fuzz::expect(rows.text().find('\n') == std::string_view::npos, "a row goes over its line");
      for (std::size_t column = 0; column < wanted; ++column)
        fuzz::expect_message(rows.error(column, "something").what());
    }
    fuzz::expect(!rows.next() && rows.bytes_read() == size - 1, "the file is not read to its end");
  } catch (const usage_error& error) {
    fuzz::expect_message(error.what());
  }
  return 0;
}
