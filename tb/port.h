// SPDX-License-Identifier: Apache-2.0
/// The ports of a device as data: what a test bench drives and reads, a CSV file has columns for, a waveform shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rtl_sysc/pin.h"
#include "tb/format.h"

namespace blysk {

/// A port, or a net inside the device that is reported as a result.
struct port {
  enum class role {
    clock,
    reset,   ///< active low, synchronous
    data,    ///< an input that carries a number: a column of the stimulus
    strobe,  ///< writes a data port's register
    start,  ///< a rising edge of the clock that sees it and `ready` at one takes all data ports: a row of the stimulus
    control,  ///< any other input of one bit
    ready,    ///< the device takes a row when it is started
    result,   ///< a column of the results
    valid  ///< of a device with strobes: its leading edge says that the results belong to the write before; of one
           ///< with `start`: a rising edge of the clock that sees it at one delivers a row of the results
  };

  std::string name;    ///< as SystemC and Verilog have it
  std::string number;  ///< in the figure; empty if it has none
  std::string wave;    ///< in a waveform
  std::string note;    ///< what it is
  role is = role::data;
  bool is_inner = false;                    ///< a net, with no port of its own
  std::optional<wire_format> carries = {};  ///< of data and results
  std::string column = {};                  ///< of data and results: its name in CSV files
  std::string writes = {};                  ///< of a strobe: the data port
  write_edge edge = write_edge::level;      ///< of a strobe
  int settling_cycles =
      0;  ///< of valid: clock cycles more that a write needs before its leading edge; of a device with
          ///< `start`: clock cycles after which it has delivered all rows if it stays ready

  int width() const { return carries ? carries->width() : 1; }
  bool is_input() const { return is != role::result && is != role::ready && is != role::valid; }

  /// "18: cos(delta), 0..1, UQ1.8, codes 0..256"
  std::string text() const;
};

/// The ports of one role, in the device's order.
std::vector<port> of_role(const std::vector<port>& ports, port::role role);

/// "n,cos,r,g,b": the columns of the ports of one role.
std::string column_names(const std::vector<port>& ports, port::role role);

/// How a host talks to a device.
enum class protocol {
  strobes,    ///< a strobe for each data port, one of which writes by its trailing edge: [P] fig. 3
  handshake,  ///< start, ready and valid
  none
};
protocol protocol_of(const std::vector<port>& ports);

/// Position of the first port with the role.
/// \throws std::logic_error if there is none
std::size_t find_role(const std::vector<port>& ports, port::role role);

/// Reader of a device type's pins().
class port_list {
 public:
  template <class Member>
  void clock(Member, const pin& what) {
    add(what, port::role::clock);
  }
  template <class Member>
  void reset(Member, const pin& what) {
    add(what, port::role::reset);
  }
  template <class Member, class Format>
  void data(Member, const pin& what, Format format, const char* column) {
    add_number(what, port::role::data, format_of(format), column);
  }
  template <class Member>
  void strobe(Member, const pin& what, const char* writes, write_edge edge) {
    add(what, port::role::strobe);
    ports.back().writes = writes;
    ports.back().edge = edge;
  }
  template <class Member>
  void start(Member, const pin& what) {
    add(what, port::role::start);
  }
  template <class Member>
  void control(Member, const pin& what) {
    add(what, port::role::control);
  }
  template <class Member>
  void ready(Member, const pin& what) {
    add(what, port::role::ready);
  }
  template <class Member, class Format>
  void result(Member, const pin& what, Format format, const char* column) {
    add_number(what, port::role::result, format_of(format), column);
  }
  template <class Member, class Format>
  void inner_result(Member, const pin& what, Format format, const char* column) {
    add_number(what, port::role::result, format_of(format), column);
    ports.back().is_inner = true;
  }
  template <class Member>
  void valid(Member, const pin& what) {
    add(what, port::role::valid);
  }

  /// The results follow a write by some more cycles; after valid().
  void settles_after(int cycles) { ports.back().settling_cycles = cycles; }

  std::vector<port> ports;

 private:
  void add(const pin& what, port::role role) {
    ports.push_back({what.name, what.number, what.wave, what.note, role});
  }
  void add_number(const pin& what, port::role role, const wire_format& format, const char* column) {
    add(what, role);
    ports.back().carries = format;
    ports.back().column = column;
  }
};

/// The ports of a device type, without an instance of it.
template <class Device>
std::vector<port> ports_of() {
  port_list list;
  Device::pins(list);
  return std::move(list.ports);
}

}  // namespace blysk
