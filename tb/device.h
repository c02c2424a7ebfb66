// SPDX-License-Identifier: Apache-2.0
/// The devices, and a device as its user asks for it. What a device owns stands in tb/devices/<identifier>/; everything
/// else reads this interface.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tb/engine.h"
#include "tb/port.h"

namespace blysk {

class device;
class selection;
namespace netlist {
class elaborated;
}

inline constexpr std::string_view format_names[] = {
#define BLYSK_NAMED_FORMAT(name) #name,
#include "tb/formats.def"
#undef BLYSK_NAMED_FORMAT
};

/// A choice that a device leaves to its user: "--NAME VALUE" on a command line, "--NAME" if it is a flag.
struct option {
  std::string name;
  std::string help;                              ///< one line, without the values
  std::vector<std::string> values = {};          ///< empty: any text that the device accepts
  std::string preset = {};                       ///< the value where none is given
  std::vector<std::string> formula_values = {};  ///< further values, which engine golden alone can serve
  bool is_wired = false;  ///< chooses wires that a formula does not have: engine golden refuses it

  /// A flag is "off" or "on".
  bool is_flag() const { return values == std::vector<std::string>{"off", "on"}; }
};

/// Word lengths by name: {"cos", 12}.
using word_lengths = std::map<std::string, int>;

/// What a selection is for.
enum class purpose { hardware, formula };

/// A device with its format and options, all of them checked.
class selection {
 public:
  const device& of() const { return *device_; }
  const std::string& format() const { return format_; }
  purpose is_for() const { return purpose_; }

  /// Fraction bits that the format names.
  int fraction() const;

  /// The value of an option that the device has.
  const std::string& value(const std::string& option) const { return values_.at(option); }
  bool flag(const std::string& option) const { return value(option) == "on"; }
  const std::map<std::string, std::string>& values() const { return values_; }

  /// True if no option differs from its preset.
  bool is_preset() const;

  /// "blysk_quadratic_q12": name of the Verilog top module.
  std::string top_name() const;

  /// "quadratic_q12": name of the folder below rtl_verilog/.
  std::string folder_name() const;

  /// "device <name>, format q12, coefficient derived, ...": what the device is, in one line.
  std::string text() const;

 private:
  friend selection choose(const std::string&, const std::string&, const std::map<std::string, std::string>&,
                          purpose);
  selection() = default;

  const device* device_ = nullptr;
  std::string format_;
  purpose purpose_ = purpose::hardware;
  std::map<std::string, std::string> values_;
};

/// A name that stands for a device with some of its options chosen: "NAME-2".
struct device_alias {
  std::string name;
  std::map<std::string, std::string> options;
};

/// A device: how it is called, what can be chosen, and how to compute it in each way that is its own.
class device {
 public:
  virtual ~device() = default;

  virtual std::string name() const = 0;      ///< with dashes between words
  virtual std::string title() const = 0;     ///< what it is, in half a line
  virtual std::string source() const = 0;    ///< document
  virtual std::string figure() const = 0;    ///< of the document, "fig. 1"
  virtual std::string good_for() const = 0;  ///< what a user takes it for, in a line
  virtual std::vector<option> options() const = 0;
  virtual std::vector<device_alias> aliases() const { return {}; }

  /// The name with underscores, for folders, modules and namespaces.
  std::string identifier() const;

  /// \throws std::invalid_argument for option values that do not go together, or that the device does not accept
  virtual void check(const selection& asked) const = 0;

  /// The options' values, checked ones, in one text for each meaning: what is the preset in other words as the preset.
  virtual std::map<std::string, std::string> canonical(const selection& asked) const {
    return asked.values();
  }

  /// The options in words, "coefficient derived, BRDF clamped to [0, 1]".
  virtual std::string words(const selection& asked) const = 0;

  /// The ports; those of data and of results are in the order of columns.
  std::vector<port> ports(const selection& asked) const;

  /// True if each row of the stimulus is a scan line, whose pixels are the rows of the results.
  virtual bool draws_lines() const { return false; }

  /// Rows of the results that a row of the stimulus makes.
  virtual std::int64_t pixels(const columns& /*in*/, std::size_t /*row*/) const { return 1; }

  /// The SystemC modules between signals of their own. SystemC elaborates once: a process makes one.
  /// \param clock_period_ns  of the clock at the device's clk; 0: a plain signal, which the caller writes
  std::unique_ptr<netlist::elaborated> elaborate(const selection& asked, double clock_period_ns) const;

  /// The bit-accurate model: the blocks' laws composed on integers.
  virtual std::unique_ptr<engine> make_bit(const selection& asked) const = 0;

  /// Another device whose results these are bit for bit, so that its errors are those of this one.
  virtual std::optional<selection> computes_as(const selection&) const { return std::nullopt; }

  /// Clock cycles from one row of the stimulus to the next at full speed.
  virtual int cycles_per_row(const selection& asked) const;

  /// Clock cycles from the one that sees a write's strobe to the one whose strobe confirms its results; of a pipeline, clock
  /// edges from the one that takes a row to the one that finds its results; nothing for what draws lines or takes as long
  /// as its row asks for.
  std::optional<int> latency_cycles(const selection& asked) const;

  /// Bits of the read-only memories that the device needs.
  virtual std::int64_t rom_bits(const selection&) const { return 0; }

  /// The word lengths that the laws leave open, in bits by name, as the format has them.
  virtual word_lengths widths(const selection& asked) const = 0;

  /// The same model at any word lengths; its results are of storage i64.
  /// \throws std::invalid_argument for word lengths at which a net needs more than 64 bits
  virtual std::unique_ptr<engine> make_bit(const selection& asked, const word_lengths& bits) const = 0;

  /// The device's own formula in double, at the codes of its inputs.
  virtual std::unique_ptr<engine> make_golden(const selection& asked) const = 0;

  /// How many of the data ports, from the first, tests enumerate; the others run through their codes alongside.
  virtual std::size_t enumerated() const = 0;

  /// Codes of the last enumerated port where something happens, the ends of its range apart.
  /// \param before  codes of the enumerated ports before it
  virtual std::vector<std::int64_t> corners(const selection& asked,
                                            std::span<const std::int64_t> before) const = 0;
};

/// All of them, in the order of tb/devices/devices.def.
const std::vector<const device*>& devices();

/// The device of that name, and the options that the name stands for.
/// \throws std::invalid_argument if there is none
std::pair<const device*, std::map<std::string, std::string>> find_device(const std::string& name);

/// \param device_name  or an alias
/// \param options      by name, without dashes; a flag is "on" or "off"
/// \throws std::invalid_argument for a device, format, option or value that does not exist, or not for the purpose
selection choose(const std::string& device_name, const std::string& format,
                 const std::map<std::string, std::string>& options = {}, purpose is_for = purpose::hardware);

}  // namespace blysk
