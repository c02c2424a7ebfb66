// SPDX-License-Identifier: Apache-2.0
#include "tb/export/serial.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <stdexcept>
#include <vector>

namespace blysk::verilog {

namespace {

constexpr int kBitsOfDigit = 4;

int digits_of(const port& of) {
  return (of.width() + kBitsOfDigit - 1) / kBitsOfDigit;
}

int digits_of(const std::vector<port>& ports) {
  int digits = 0;
  for (const port& each : ports) digits += digits_of(each);
  return digits;
}

/// Bits of a number from 0 to the greatest.
int bits_for(int greatest) {
  return static_cast<int>(std::bit_width(static_cast<unsigned>(greatest)));
}

/// The data ports out of the register `given`, which holds a line's digits; those of the last port are lowest. What the digits
/// carry beyond the ports goes to a wire of its own.
std::string data_connections(const std::vector<port>& data, std::string& unused) {
  std::string text;
  int low = kBitsOfDigit * digits_of(data);
  for (const port& each : data) {
    const int field = kBitsOfDigit * digits_of(each);
    low -= field;
    text += fmt::format("      .{}(given[{}:{}]),\n", each.name, low + each.width() - 1, low);
    if (each.width() < field) unused += fmt::format(", given[{}:{}]", low + field - 1, low + each.width());
  }
  return text;
}

}  // namespace

std::string serial_text(const netlist::elaborated& device, const std::string& name,
                        const std::string& title) {
  std::vector<port> ports;
  for (const auto& each : device.ports()) {
    if (!each->what.is_inner) ports.push_back(each->what);
  }
  if (protocol_of(ports) != protocol::strobes) {
    throw std::invalid_argument(
        "a serial wrapper is for a device with strobes, whose answer is one row, expected one of those");
  }
  const std::vector<port> data = of_role(ports, port::role::data);
  const std::vector<port> results = of_role(ports, port::role::result);
  const port& valid = ports[find_role(ports, port::role::valid)];
  const int given = digits_of(data);
  const int answered = digits_of(results);
  const int last = answered + static_cast<int>(results.size()) - 1;  // place of the end of the line
  const int given_bits = bits_for(given + 1);
  const int place_bits = bits_for(last);

  std::string unused = fmt::format("1'b0, {}", valid.name);
  std::string connections =
      fmt::format("      .{}(clk),\n      .{}(rst_n),\n", ports[find_role(ports, port::role::clock)].name,
                  ports[find_role(ports, port::role::reset)].name);
  connections += data_connections(data, unused);
  for (const port& each : of_role(ports, port::role::strobe))
    connections += fmt::format("      .{}(state == PUT),\n", each.name);
  for (const port& each : of_role(ports, port::role::control))
    connections += fmt::format("      .{}(1'b0),\n", each.name);
  std::string wires;
  std::vector<std::string> answer, blanks;
  int place = 0;
  for (const port& each : results) {
    wires += fmt::format("  wire [{}:0] {};  // {}\n", each.width() - 1, each.name, each.text());
    connections += fmt::format("      .{0}({0}),\n", each.name);
    const int padding = kBitsOfDigit * digits_of(each) - each.width();
    answer.push_back(padding == 0 ? each.name : fmt::format("{}'d0, {}", padding, each.name));
    place += digits_of(each);
    if (place < last) blanks.push_back(fmt::format("place == {}'d{}", place_bits, place));
    ++place;
  }
  connections += fmt::format("      .{0}({0})\n", valid.name);
  return fmt::format(
      R"(// SPDX-License-Identifier: Apache-2.0
// {0} behind a serial line: {1}.
// 8 data bits, no parity, one stop bit, DIVISOR periods of clk a bit, at least 4. A line as `blysk vectors` writes it comes
// back with the outputs appended. Send the next line when the answer has come. A line that begins with # comes back as it
// is; one that is no vector of this device comes back with a ? behind it.
module {0}_serial #(
    parameter [15:0] DIVISOR = 16'd104  // 115200 baud at 12 MHz
) (
    input wire clk,
    input wire rx_i,
    output wire tx_o
);
  localparam [7:0] BLANK = 8'h20, NEWLINE = 8'h0a;

  // The flip-flops of an iCE40 begin at 0: that is the reset.
  reg [3:0] age = 4'd0;
  wire rst_n = &age;
  always @(posedge clk) if (!rst_n) age <= age + 4'd1;

  // Receiver: is_received is at one for a period when received is a new character.
  reg [1:0] rx = 2'd0;
  reg is_receiving, is_received;
  reg [15:0] rx_wait;
  reg [3:0] rx_bits;
  reg [7:0] received;
  always @(posedge clk) begin
    rx <= {{rx[0], rx_i}};
    is_received <= 1'b0;
    if (!rst_n) is_receiving <= 1'b0;
    else if (!is_receiving) begin
      is_receiving <= !rx[1];
      rx_wait <= DIVISOR >> 1;
      rx_bits <= 4'd0;
    end else if (rx_wait != 16'd0) rx_wait <= rx_wait - 16'd1;
    else begin
      rx_wait <= DIVISOR - 16'd1;
      rx_bits <= rx_bits + 4'd1;
      if (rx_bits == 4'd0) is_receiving <= !rx[1];  // else it was no start bit
      else if (rx_bits != 4'd9) received <= {{rx[1], received[7:1]}};
      else begin
        is_receiving <= 1'b0;
        is_received <= rx[1];  // else it was no stop bit
      end
    end
  end

  // Transmitter: takes sent when is_sent is at one.
  reg [8:0] tx;  // ones behind the character are the stop bit
  reg [3:0] tx_bits;
  reg [15:0] tx_wait;
  reg is_low = 1'b0;  // the line idles at one, and a flip-flop begins at 0
  reg is_sent;
  reg [7:0] sent;
  wire is_free = tx_bits == 4'd0 && tx_wait == 16'd0;
  assign tx_o = !is_low;
  always @(posedge clk) begin
    if (!rst_n) begin
      tx_bits <= 4'd0;
      tx_wait <= 16'd0;
      is_low <= 1'b0;
    end else if (is_free && is_sent) begin
      tx <= {{1'b1, sent}};
      tx_bits <= 4'd9;
      tx_wait <= DIVISOR - 16'd1;
      is_low <= 1'b1;
    end else if (tx_wait != 16'd0) tx_wait <= tx_wait - 16'd1;
    else if (tx_bits != 4'd0) begin
      tx <= {{1'b1, tx[8:1]}};
      tx_bits <= tx_bits - 4'd1;
      tx_wait <= DIVISOR - 16'd1;
      is_low <= !tx[0];
    end
  end

  // The line: digits shift into given, every character is held until it can leave as its echo.
  reg [{2}:0] given;
  reg [{3}:0] digits;
  reg is_comment, is_wrong, is_held;
  reg [7:0] held;
  wire is_figure = received >= 8'h30 && received <= 8'h39;
  wire is_letter = (received | 8'h20) >= 8'h61 && (received | 8'h20) <= 8'h66;
  wire [3:0] figure = is_letter ? received[3:0] + 4'd9 : received[3:0];
  wire is_vector = digits == {4}'d{5} && !is_wrong;

  // The device takes the line, its outputs settle while the blank behind the line leaves.
  localparam [2:0] READ = 3'd0, PUT = 3'd1, DIVIDE = 3'd2, TAKE = 3'd3, ANSWER = 3'd4, REFUSE = 3'd5, END = 3'd6;
  reg [2:0] state;
  reg [{6}:0] answer;
  reg [{7}:0] place;
  wire is_blank = {8};
  wire [3:0] digit = answer[{6}:{9}];
  wire [7:0] shown = digit < 4'd10 ? {{4'h3, digit}} : {{4'h6, digit - 4'd9}};

{10}  wire {11};
  wire unused_bits = &{{{12}}};
  {0} device (
{13}  );

  always @* begin
    is_sent = 1'b1;
    sent = BLANK;
    case (state)
      READ: begin
        is_sent = is_held;
        sent = held;
      end
      DIVIDE: sent = is_held ? held : BLANK;
      ANSWER: sent = is_blank ? BLANK : shown;
      REFUSE: sent = 8'h3f;
      END: sent = NEWLINE;
      default: is_sent = 1'b0;
    endcase
  end

  always @(posedge clk) begin
    if (!rst_n) begin
      state <= READ;
      digits <= {4}'d0;
      is_comment <= 1'b0;
      is_wrong <= 1'b0;
      is_held <= 1'b0;
    end else begin
      case (state)
        READ: begin
          if (is_free) is_held <= 1'b0;
          if (is_received && received == NEWLINE) begin
            if (!is_comment && (digits != {4}'d0 || is_wrong)) state <= is_vector ? PUT : DIVIDE;
            else begin
              held <= NEWLINE;
              is_held <= 1'b1;
              is_comment <= 1'b0;
            end
          end else if (is_received && received != 8'h0d) begin
            held <= received;
            is_held <= 1'b1;
            if (received == 8'h23 && digits == {4}'d0 && !is_wrong) is_comment <= 1'b1;
            else if (!is_comment && (is_figure || is_letter)) begin
              given <= {{given[{14}:0], figure}};
              if (digits != {4}'d{15}) digits <= digits + {4}'d1;
            end else if (!is_comment && received != BLANK) is_wrong <= 1'b1;
          end
        end
        PUT: state <= DIVIDE;
        DIVIDE:
        if (is_held) begin  // the last character of the line
          if (is_free) is_held <= 1'b0;
        end else if (is_free) state <= is_vector ? TAKE : REFUSE;
        TAKE:
        if (is_free) begin
          answer <= {{{16}}};
          place <= {17}'d0;
          state <= ANSWER;
        end
        ANSWER:
        if (is_free) begin
          if (!is_blank) answer <= {{answer[{18}:0], 4'd0}};
          place <= place + {17}'d1;
          if (place == {17}'d{19}) state <= END;
        end
        REFUSE: if (is_free) state <= END;
        END:
        if (is_free) begin
          state <= READ;
          digits <= {4}'d0;
          is_wrong <= 1'b0;
        end
        default: state <= READ;
      endcase
    end
  end
endmodule
)",
      name, title, kBitsOfDigit * given - 1, given_bits - 1, given_bits, given, kBitsOfDigit * answered - 1,
      place_bits - 1, blanks.empty() ? "1'b0" : fmt::format("{}", fmt::join(blanks, " || ")),
      kBitsOfDigit * (answered - 1), wires, valid.name, unused, connections, kBitsOfDigit * (given - 1) - 1,
      given + 1, fmt::join(answer, ", "), place_bits, kBitsOfDigit * (answered - 1) - 1, last - 1);
}

std::string serial_pins(const std::string& name) {
  return fmt::format(
      "# SPDX-License-Identifier: Apache-2.0\n"
      "# {}_serial on Lattice's iCE40 HX8K breakout board (ct256): its oscillator of 12 MHz and the serial "
      "port of its "
      "USB chip.\n"
      "set_io clk J3\n"
      "set_io rx_i B10\n"
      "set_io tx_o B12\n",
      name);
}

}  // namespace blysk::verilog
