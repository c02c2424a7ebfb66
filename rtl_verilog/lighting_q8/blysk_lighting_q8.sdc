# SPDX-License-Identifier: Apache-2.0
# clk_period, in ns, is what the longest path takes in OSU018, 6.32 (docs/tables/lighting/cost_q8.json). In other cells it is another.
# Delays of 0 leave inputs and outputs the whole period; set what your board takes of it. No path is false: reset is
# synchronous.
set clk_period 6.4
create_clock -name clk -period $clk_period [get_ports clk]
set_input_delay 0 -clock clk [get_ports {rst_n nl_i first_i ar_i ag_i ab_i dr_i dg_i db_i sr_i sg_i sb_i start_i stall_i}]
set_output_delay 0 -clock clk [get_ports {ready_o r_sum_o g_sum_o b_sum_o r_o g_o b_o valid_o}]
