// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "tb/output_file.h"

namespace blysk {

/// A file for waves, there as a whole or not at all: VCD, or FST if its name ends with .fst. Engines write VCD; GTKWave's
/// vcd2fst makes FST of it.
class waves_file {
 public:
  /// \throws usage_error if the file cannot be created, its name ends as one of another form of waves or a packed one does,
  ///         or it is FST and vcd2fst is not installed
  explicit waves_file(const std::string& path);

  /// Where an engine writes the VCD, until commit().
  const std::string& recorded_path() const { return recorded_.temporary_path(); }

  /// Brings the waves to their place.
  /// \param is_whole  whether the engine has written all of them
  /// \throws usage_error if not, or if they cannot be brought there
  void commit(bool is_whole);

 private:
  void convert();

  std::string path_;
  output_file recorded_;
  std::optional<output_file> converted_;
};

}  // namespace blysk
