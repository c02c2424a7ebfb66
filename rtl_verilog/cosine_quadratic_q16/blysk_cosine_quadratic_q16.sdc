# SPDX-License-Identifier: Apache-2.0
# clk_period, in ns, is what the longest path takes in OSU018, 18.80 (docs/tables/cosine_quadratic/cost_q16.json). In other cells it is another.
# Delays of 0 leave inputs and outputs the whole period; set what your board takes of it. No path is false: reset is
# synchronous.
set clk_period 18.8
# strobe_gap: clock cycles from the edge that loads the last register of a write to the edge that samples its
# results. With a shorter clk_period the host waits more of them between two strobes.
set strobe_gap 1
create_clock -name clk -period $clk_period [get_ports clk]
set_input_delay 0 -clock clk [get_ports {rst_n n_i n_we_i cos_i cos_we_i r_i r_we_i g_i g_we_i b_i b_we_i}]
set_output_delay 0 -clock clk [get_ports {r_o g_o b_o valid_o}]
set_multicycle_path $strobe_gap -setup -to [get_ports {r_o g_o b_o}]
set_multicycle_path [expr {$strobe_gap - 1}] -hold -to [get_ports {r_o g_o b_o}]
