# SPDX-License-Identifier: Apache-2.0
# clk_period, in ns, is an example: set your clock's. Delays of 0 leave inputs and outputs the whole period; set
# what your board takes of it. No path is false: reset is synchronous.
set clk_period 10.0
create_clock -name clk -period $clk_period [get_ports clk]
set_input_delay 0 -clock clk [get_ports {rst_n n_i n_we_i cos_i cos_we_i r_i r_we_i g_i g_we_i b_i b_we_i}]
set_output_delay 0 -clock clk [get_ports {r_o g_o b_o valid_o}]
