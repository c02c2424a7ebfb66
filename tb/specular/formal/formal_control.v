// SPDX-License-Identifier: Apache-2.0
// What yosys proves of the control of an exported pipelined device: see pipelined.sh.
`default_nettype none

module formal_control (
    input wire clk,
    input wire rst_n,
    input wire start_i,
    input wire stall_i
);

  wire ready_o, valid_o, go, take;
  device device (.clk(clk), .rst_n(rst_n), .start_i(start_i), .stall_i(stall_i), .ready_o(ready_o), .valid_o(valid_o),
                 .go(go), .take(take));

  reg started = 0, waits = 0;
  always @(posedge clk) begin
    started <= 1;
    waits <= rst_n && valid_o && stall_i;
  end
  always @* begin
    assume (started || !rst_n);
    assert (ready_o == !(stall_i && valid_o));
    assert (go == ready_o && take == (start_i && go));
    if (started && waits) assert (valid_o);
  end

endmodule

`default_nettype wire
