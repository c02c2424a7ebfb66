// SPDX-License-Identifier: Apache-2.0
#include "tb/cosim/rows_file.h"

#include <fmt/format.h>

#include <vector>

#include "tb/csv_reader.h"
#include "tb/read_number.h"

namespace blysk::cosim {

columns read_rows(const selection& asked, const std::string& path) {
  const std::vector<port> ports = asked.of().ports(asked);
  const std::vector<port> data = of_role(ports, port::role::data);
  csv_reader file(path, column_names(ports, port::role::data));
  columns rows(ports, port::role::data);
  std::size_t size = 0;
  while (file.next()) {
    const std::vector<std::string_view>& fields = file.fields();
    if (size == rows.size()) rows.resize(2 * size + 1);
    for (std::size_t i = 0; i < data.size(); ++i) {
      const wire_format& legal = *data[i].carries;
      const std::optional<std::int64_t> code = read_integer(fields[i]);
      if (!code || *code < legal.min || *code > legal.max)
        throw file.error(i, fmt::format("an integer {}..{}, a code", legal.min, legal.max));
      rows[i].set(size, *code);
    }
    ++size;
  }
  if (size == 0) throw usage_error(path + ": has no rows, expected at least one");
  rows.resize(size);
  return rows;
}

}  // namespace blysk::cosim
