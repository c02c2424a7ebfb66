// SPDX-License-Identifier: Apache-2.0
#include "tb/cli/animation.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "tb/run_tool.h"
#include "tb/usage_error.h"

namespace blysk::cli {

namespace {

constexpr std::string_view kPicture = ".png";
constexpr int kFramesPerSecond = 25;

std::string ending_of(const std::string& film) {
  for (const std::string_view each : {".mp4", ".webm", ".gif"}) {
    if (film.ends_with(each)) return std::string(each);
  }
  throw usage_error(
      fmt::format("--film is {}, expected a name that ends with .mp4, .webm or .gif", printable(film)));
}

/// A path that no program takes for an option.
std::string as_argument(const std::string& path) {
  return path.starts_with('/') ? path : "./" + path;
}

/// What ffmpeg takes for a pattern.
std::string as_pattern(const std::string& path) {
  std::string pattern;
  for (const char each : path) pattern.append(each == '%' ? 2 : 1, each);
  return pattern;
}

}  // namespace

animation::animation(int frames, const std::string& picture, const std::string& film)
    : frames_(frames), film_path_(film) {
  if (!picture.ends_with(kPicture) || picture.size() == kPicture.size())
    throw usage_error(
        fmt::format("--output is '{}', expected a name that ends with .png: the frames' numbers go before it",
                    printable(picture)));
  stem_ = picture.substr(0, picture.size() - kPicture.size());
  if (film.empty()) return;
  const std::string ending = ending_of(film);
  if (!is_installed("ffmpeg") && !(ending == ".gif" && is_installed("convert")))
    throw usage_error(fmt::format("--film wants {}, which is not installed; the frames can be had without it",
                                  ending == ".gif" ? "ffmpeg or ImageMagick" : "ffmpeg"));
  film_.emplace(film, ending);
  if (film_->temporary_path().empty()) throw file_error(film, 0, "is no regular file, expected one to write");
}

std::string animation::path(int frame) const {
  return fmt::format("{}-{:04}{}", stem_, frame + 1, kPicture);
}

void animation::make_film() {
  if (!film_) return;
  const std::string made = seen_by_others(film_->temporary_path());
  std::vector<std::string> words;
  if (is_installed("ffmpeg")) {
    words = {"ffmpeg", "-y", "-framerate", std::to_string(kFramesPerSecond), "-i",
             as_argument(as_pattern(stem_)) + "-%04d.png",
             // Of a longer run before there may be more.
             "-frames:v", std::to_string(frames_)};
    // Films have sides of an even number of pixels.
    if (!film_path_.ends_with(".gif"))
      words.insert(words.end(), {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p"});
    words.push_back(made);
  } else {
    words = {"convert", "-delay", std::to_string(100 / kFramesPerSecond), "-loop", "0"};
    for (int frame = 0; frame < frames_; ++frame) words.push_back(as_argument(path(frame)));
    words.push_back(made);
  }
  if (!runs_well(words))
    throw file_error(film_path_, 0, fmt::format("cannot be made: {} failed; the frames are there", words[0]));
  film_->commit();
}

}  // namespace blysk::cli
