// SPDX-License-Identifier: Apache-2.0
/// The measured files: those of docs/tables that are part of the program since it was built, or those of a folder.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tb/cost/cost_row.h"
#include "tb/cost/energy_row.h"
#include "tb/cost/errors.h"

namespace blysk::cost {

struct measured_file {
  std::string_view path, text;
};

/// Made while building, see embed.cmake.
std::span<const measured_file> embedded_files();
std::span<const measured_file> embedded_pages();

/// How long a computer takes for a million results.
struct host_time {
  double seconds = 0;
  double ratio = 0;  ///< to as many cos^n by std::pow, measured beside it
};

/// A device in a format with options, and what was measured of it.
struct configuration {
  selection asked;
  cost_row cost = {};       ///< parts that were not measured are not there
  cost_row reference = {};  ///< of the device written by hand in Verilog
  std::optional<error_table> errors = {};
  std::optional<energy_row> energy = {};
  std::map<std::string, host_time> host = {};  ///< by engine
  nlohmann::ordered_json roundings = {};       ///< rows of `blysk explore --rounding all --json`
  std::string digest = {};                     ///< of the Verilog that is exported today; empty if none is
  bool is_stale = false;                       ///< a part of the cost belongs to another Verilog

  /// Clock cycles from one result to the next; 0 where a row takes as long as it asks for, or rows add
  /// up, or this build does not have the format.
  int cycles_per_result() const;

  /// Clock cycles from a point to its results; none where that depends on the row or this build does not have
  /// the format.
  std::optional<int> latency_cycles() const;

  /// Million results a second at a clock in MHz; 0 if there is no clock or no such number of cycles.
  double results_per_us(double mhz) const;

  /// MHz that each seed reaches, or that the longest path allows; 0 if not measured.
  double ice40_mhz() const;
  double asic_mhz() const;

  /// pJ of a pixel of a lit sphere in OSU018; 0 if not measured.
  double energy_pj() const;

  bool has_errors_in(domain where) const;

  /// Of a configuration that has them.
  const cost::errors& errors_in(domain where) const;

  /// What a shell repeats the row by.
  std::string command() const;

  /// "<device> q8, rom clocked"
  std::string label() const;
};

/// The files of measured rows below a folder, sorted; none for the embedded ones.
/// \throws usage_error if it cannot be read
std::vector<std::string> measured_paths(const std::string& folder);

/// The configurations of all rows, in the order of devices and formats.
/// \param folder  with the files, such as docs/tables; empty for the embedded ones
/// \throws usage_error for a damaged file, or a folder that holds none
std::vector<configuration> read_measured(const std::string& folder);

/// The embedded row of a device in a format with options; empty if it was not measured.
std::optional<cost_row> measured_cost(const selection& asked);

/// The text of an embedded file; empty if there is none.
/// \param path  below docs/tables
std::optional<std::string> embedded_text(const std::string& path);

/// Finds which rows are stale, those of formats that this build does not have left out. It exports each device in a process of
/// its own.
void look_for_stale(std::vector<configuration>& all);

}  // namespace blysk::cost
