# SPDX-License-Identifier: Apache-2.0
# clk_period, in ns, is what the longest path takes in OSU018, 3.65 (docs/tables/gouraud/cost_q8.json). In other cells it is another.
# Delays of 0 leave inputs and outputs the whole period; set what your board takes of it. No path is false: reset is
# synchronous.
set clk_period 3.7
create_clock -name clk -period $clk_period [get_ports clk]
set_input_delay 0 -clock clk [get_ports {rst_n length_i r0_i g0_i b0_i r1_i g1_i b1_i start_i}]
set_output_delay 0 -clock clk [get_ports {ready_o r_o g_o b_o valid_o}]
