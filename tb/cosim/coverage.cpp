// SPDX-License-Identifier: Apache-2.0
// coverage DEVICE FORMAT FILE.dat [--rows ROWS.csv]: line and toggle coverage of the exported device under what the regression
// sends: all inputs where they are few, random ones and corners beyond, further rows, and strobes in every order.
// Built once for each device and format, with the class that counts.
#include <verilated.h>
#include <verilated_cov.h>

#include "tb/cosim/rows_file.h"
#include "tb/cosim/strobes.h"
#include "tb/cosim/verilated_table.h"
#include "tb/inputs.h"
#include "tb/program.h"

int main(int argc, char** argv) {
  using namespace blysk;
  device_arguments arguments;
  std::string path, rows;
  return run_program(
      argc, argv, "Counts the lines and changes of the exported Verilog under the regression",
      [&](CLI::App& program) {
        arguments.add_to(program);
        program.add_option("FILE", path, "counts, as Verilator writes them")->required();
        program.add_option("--rows", rows, "further rows of the regression, raw codes in CSV")
            ->check(CLI::ExistingFile);
      },
      [&] {
        constexpr std::uint64_t kFew = 5'000'000;
        const selection asked = arguments.chosen();
        const auto verilog = cosim::covered_table().front().make();
        columns out;
        const auto run = [&](const columns& in) { verilog->run(in, out); };
        if (input_count(asked) <= kFew) {
          for_all_inputs(asked, run);
        } else {
          for_random_inputs(asked, 2'000'000, 1, run);
          for_corner_inputs(asked, 64, run);
        }
        if (!rows.empty()) run(cosim::read_rows(asked, rows));
        cosim::play_strobes(*verilog, asked, [](std::span<const std::int64_t>) { return true; });
        Verilated::threadContextp()->coveragep()->write(path.c_str());
        return 0;
      });
}
