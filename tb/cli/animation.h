// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "tb/output_file.h"

namespace blysk::cli {

/// Pictures of a turning object, numbered, and a film of them.
class animation {
 public:
  /// \param frames   in a whole turn
  /// \param picture  "turn.png" stands for turn-0001.png and so on
  /// \param film     .mp4 or .webm, which ffmpeg makes, or .gif, which ImageMagick makes if ffmpeg is not installed;
  ///                 empty: none
  /// \throws usage_error if the picture is no PNG file, or nothing that is installed makes the film
  animation(int frames, const std::string& picture, const std::string& film);

  int frames() const { return frames_; }

  /// \param frame  from 0
  std::string path(int frame) const;

  /// Makes the film of the frames, which are there.
  /// \throws usage_error if it cannot be made
  void make_film();

 private:
  int frames_;
  std::string stem_;
  std::string film_path_;
  std::optional<output_file> film_;
};

}  // namespace blysk::cli
