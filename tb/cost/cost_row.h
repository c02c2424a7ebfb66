// SPDX-License-Identifier: Apache-2.0
/// What the hardware of a device costs, as tools measured it: a file for each device, format and choice of options,
/// docs/tables/<identifier>/cost_<format>.json.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "tb/device.h"
#include "tb/usage_error.h"

namespace blysk::cost {

/// Where figures come from.
struct origin {
  std::string digest;                        ///< of the Verilog that was measured
  std::map<std::string, std::string> tools;  ///< what each says of its version
  std::string script;                        ///< what the tools were told
};

/// Cells of an iCE40 that Yosys takes for the device alone.
struct ice40_cells {
  origin from;
  std::int64_t lut = 0, carry = 0, ff = 0, dsp = 0;
  std::int64_t ram_bits = 0;  ///< of whole block RAMs, 4096 each
};

/// Clocks that nextpnr reaches, one for each seed; the device stands between shift registers.
struct placement {
  origin from;
  std::string part;
  std::vector<int> seeds;
  std::vector<double> fmax_mhz;

  double least() const;
  double median() const;  ///< the lower of the two in the middle
  double most() const;
};

/// Cells of the OSU018 library.
struct standard_cells {
  origin from;
  std::int64_t cells = 0;
  double area_nand2 = 0;  ///< in areas of a NAND2X1
  double path_ns = 0;     ///< the longest path, from a clock edge to an output or the set-up of a register
};

/// A part that was not measured, or whose tool failed, is not there.
struct cost_row {
  std::string device, format;
  std::map<std::string, std::string> options;  ///< those that differ from their presets
  std::optional<ice40_cells> ice40;            ///< multipliers of LUTs
  std::optional<ice40_cells> ice40_dsp;        ///< multipliers of DSP blocks where Yosys takes them
  std::optional<placement> hx8k;               ///< of the device with multipliers of LUTs
  std::optional<standard_cells> osu018;

  /// \throws std::invalid_argument if the device or format does not exist here
  selection chosen() const { return choose(device, format, options); }
};

/// The options that differ from their presets.
std::map<std::string, std::string> given_options(const selection& asked);

/// " --rom clocked" as on a command line; a flag without its value.
std::string option_words(const std::map<std::string, std::string>& options);

/// "<identifier>/cost_q8.json": the path below docs/tables, `kind` being "cost".
std::string row_path(const std::string& kind, const selection& asked);

nlohmann::ordered_json json_of(const cost_row& row);

/// \param path  for messages
/// \throws usage_error for text that is no row, "FILE:LINE: what is wrong, what was expected"
cost_row parse_cost_row(const std::string& path, const std::string& text);

/// The JSON text of a file.
/// \throws usage_error with the line where it goes wrong
nlohmann::ordered_json parse_json(const std::string& path, const std::string& text,
                                  const std::string& expected =
                                      "JSON as scripts/synth and the target "
                                      "update_errors write it");

/// \return  for throwing: "FILE: is damaged: what, expected ..."
usage_error damaged(const std::string& path, const std::string& what, const std::string& expected);

/// What `read` makes of a stored file, whose keys and values may be wrong.
/// \throws usage_error in place of json::exception, a key that is missing or of another type, and std::domain_error
template <class Read>
auto read_stored(const std::string& path, const std::string& expected, const Read& read) {
  try {
    return read();
  } catch (const nlohmann::json::exception&) {
    throw damaged(path, "a key is missing or of another type", expected);
  } catch (const std::domain_error& error) {
    throw damaged(path, error.what(), expected);
  }
}

/// A member of a stored object.
/// \throws json::exception if there is none or it is no number, std::domain_error if it is no count, or not above zero
std::int64_t count_of(const nlohmann::ordered_json& of, const char* key);
double positive_of(const nlohmann::ordered_json& of, const char* key);

/// The text of a file.
/// \throws usage_error if it cannot be read
std::string read_text(const std::string& path);

/// Writes a file atomically.
/// \throws usage_error if it cannot be written
void write_text(const std::string& path, const std::string& text);

/// The row's text as it is stored, two blanks an indent.
std::string stored_text(const nlohmann::ordered_json& json);

}  // namespace blysk::cost
