# SPDX-License-Identifier: Apache-2.0
# 10 ns stands for the board's clock. No path is false: rst_n is synchronous, and what enters or leaves does so
# within one period.
create_clock -name clk -period 10 [get_ports clk]
set_input_delay -clock clk 0 [remove_from_collection [all_inputs] [get_ports clk]]
set_output_delay -clock clk 0 [all_outputs]
