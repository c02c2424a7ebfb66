// SPDX-License-Identifier: Apache-2.0
// The main job: a lit sphere whose highlight the SystemC device computes, pixel by pixel, beside Blinn's.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sysc/tracing/sc_tracing_ids.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <memory>
#include <set>
#include <systemc>

#include "tb/bench/systemc_engine.h"
#include "tb/golden/lobe_formulas.h"
#include "tb/golden/sphere.h"
#include "tb/output_file.h"
#include "tb/program.h"
#include "tb/progress.h"
#include "tb/scene/picture.h"

namespace {

using namespace blysk;
using scene::picture;

struct options {
  device_options device;
  std::filesystem::path output = "out";
  std::vector<int> exponents{1, 10, 50, 200, 1000};
  int side = 512;
};

constexpr int kDifferenceGain = 4;
constexpr std::size_t kTracedWrites = 64;

using rgb = std::array<double, 3>;

// A blue ball under white light: intensities of 0..255, I_a k_a, I_l k_d and I_l k_s of [T] (1.2) by channel.
constexpr rgb kAmbient{10, 16, 36};
constexpr rgb kDiffuse{36, 72, 150};
constexpr std::array<std::uint8_t, 3> kSpecular{200, 190, 170};

/// A pixel that the sphere covers.
struct sample {
  int x, y;
  double diffuse;    // N.L, 0 behind the surface
  double cos_delta;  // N.H, [0, 1]; 0 where the light is behind the surface
};

/// The text as one word of a shell, printable.
std::string as_word(const std::string& text) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::strchr("/._-", c) != nullptr;
  };
  if (std::all_of(text.begin(), text.end(), is_plain)) return text;
  std::string word;
  if (printable(text) == text) {
    for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
    return "'" + word + "'";
  }
  for (const char c : text) {
    word += is_plain(static_cast<unsigned char>(c)) ? std::string(1, c)
                                                    : fmt::format("\\x{:02X}", static_cast<std::uint8_t>(c));
  }
  return "$'" + word + "'";
}

/// The exponent of the waves: in the middle of those asked for.
int traced_exponent(const options& asked) {
  return asked.exponents[asked.exponents.size() / 2];
}

std::vector<sample> sample_sphere(const golden::sphere_scene& ball) {
  const auto half_vec = golden::half_vector(ball.light, ball.view);
  std::vector<sample> samples;
  for (const auto& [x, y, normal] : golden::sphere_pixels(ball)) {
    const bool lit = golden::faces_both(normal, ball.light, ball.view);
    samples.push_back({x, y, golden::clamped_cosine(normal, ball.light),
                       lit ? golden::clamped_cosine(normal, half_vec) : 0.0});
  }
  return samples;
}

/// The picture whose highlight's intensity, 0..255 by channel, is highlight(sample index).
template <class Highlight>
picture shade(int side, const std::vector<sample>& samples, Highlight&& highlight) {
  picture image(side, side);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const rgb specular = highlight(i);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double value = kAmbient[channel] + kDiffuse[channel] * samples[i].diffuse + specular[channel];
      image.pixel(samples[i].x, samples[i].y)[channel] =
          static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
    }
  }
  return image;
}

rgb scaled(double brdf) {
  return {brdf * kSpecular[0], brdf * kSpecular[1], brdf * kSpecular[2]};
}

/// Writes every sample with exponent n into the device and reads the colours back at the valid edge.
results compute_highlights(bench::systemc_engine& device, const std::vector<sample>& samples, int n,
                           double scale) {
  batch writes;
  writes.resize(samples.size());
  std::fill(writes.n.begin(), writes.n.end(), static_cast<std::uint16_t>(n));
  std::fill(writes.red_ks.begin(), writes.red_ks.end(), kSpecular[0]);
  std::fill(writes.green_ks.begin(), writes.green_ks.end(), kSpecular[1]);
  std::fill(writes.blue_ks.begin(), writes.blue_ks.end(), kSpecular[2]);
  std::transform(samples.begin(), samples.end(), writes.cos_delta.begin(), [scale](const sample& s) {
    return static_cast<std::uint32_t>(std::floor(s.cos_delta * scale + 0.5));
  });

  results all, part;
  progress shown(fmt::format("simulating n = {}", n), writes.size());
  for (std::size_t first = 0; first < writes.size();) {
    const std::size_t size = std::min<std::size_t>(16384, writes.size() - first);
    const auto slice = [first, size](const auto& column) {
      const auto begin = column.begin() + static_cast<std::ptrdiff_t>(first);
      return std::decay_t<decltype(column)>(begin, begin + static_cast<std::ptrdiff_t>(size));
    };
    device.run({slice(writes.n), slice(writes.cos_delta), slice(writes.red_ks), slice(writes.green_ks),
                slice(writes.blue_ks)},
               part);
    all.red.insert(all.red.end(), part.red.begin(), part.red.end());
    all.green.insert(all.green.end(), part.green.begin(), part.green.end());
    all.blue.insert(all.blue.end(), part.blue.begin(), part.blue.end());
    first += size;
    shown.advance(size);
  }
  return all;
}

/// [T] (3.1) over the 8-bit channels.
double nmse(const picture& reference, const picture& other) {
  return golden::nmse(std::vector<double>(reference.rgb.begin(), reference.rgb.end()),
                      std::vector<double>(other.rgb.begin(), other.rgb.end()));
}

struct outcome {
  int n;
  double nmse_blinn;      // device against Blinn: the price of the model
  double nmse_quadratic;  // device against its own formula in double: the price of the word length
  int largest;            // largest difference to Blinn in a channel
};

std::string report_text(const options& asked, const std::vector<outcome>& outcomes, std::size_t pixels,
                        const bench::systemc_engine& device, double host_s) {
  const double simulated_ms = static_cast<double>(device.cycles()) * bench::kClockPeriodNs * 1e-6;
  std::string report = fmt::format(
      "# A sphere through the device of UA 60553\n\n"
      "`{} {}` in SystemC, coefficient {}{}: a sphere of {} pixels in a picture of {} x {}, once per "
      "exponent; every\n"
      "pixel's cos(delta) is a write of register 2, its colour is read at the next leading edge of 29.\n\n"
      "| what | value |\n|---|---|\n"
      "| writes of register 2 | {} |\n| clock cycles | {} |\n| simulated time | {:.3f} ms at {:.0f} MHz |\n"
      "| host time | {:.2f} s |\n| writes per second of host time | {:.0f} |\n\n"
      "NMSE as in [T] (3.1) over the 8-bit pictures, Blinn's the reference; [T] calls up to 1e-4 not "
      "visible, up to\n"
      "2.5e-4 slight, up to 1e-3 visible, above it strong. The third column compares the device with its own "
      "formula in\n"
      "double and so shows what the word length alone costs.\n\n"
      "| n | NMSE to Blinn | NMSE to own formula | largest difference to Blinn, of 255 "
      "|\n|---|---|---|---|\n",
      asked.device.device, asked.device.format, asked.device.coefficient,
      asked.device.as_published ? ", as published" : "", pixels, asked.side, asked.side, device.writes(),
      device.cycles(), simulated_ms, 1e3 / bench::kClockPeriodNs, host_s,
      static_cast<double>(device.writes()) / host_s);
  for (const outcome& o : outcomes) {
    report += fmt::format("| {} | {:.3e} | {:.3e} | {} |\n", o.n, o.nmse_blinn, o.nmse_quadratic, o.largest);
  }
  report += fmt::format(
      "\n`sphere.png`: a column per exponent ({}); rows: the device, Blinn, {} times their difference.\n"
      "`sphere_n*.png`: the device's pictures alone. `quadratic.vcd`: the first writes, up to {} pixels of "
      "the row\n"
      "through the highlight, at n = {}.\n",
      fmt::join(asked.exponents, ", "), kDifferenceGain, kTracedWrites, traced_exponent(asked));
  return report;
}

/// kTracedWrites samples of the row through the highlight, on both sides of its middle, over three eighths of the
/// picture.
std::vector<sample> row_through_highlight(const std::vector<sample>& samples, int side) {
  const auto brighter = [](const sample& a, const sample& b) { return a.cos_delta < b.cos_delta; };
  const sample middle = *std::max_element(samples.begin(), samples.end(), brighter);
  constexpr int kHalf = static_cast<int>(kTracedWrites / 2);
  const int step = std::max(1, 3 * side / 8 / static_cast<int>(kTracedWrites));
  std::vector<sample> row;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(row), [&](const sample& s) {
    const int steps = (s.x - middle.x) / step;
    return s.y == middle.y && (s.x - middle.x) % step == 0 && steps >= -kHalf && steps < kHalf;
  });
  return row;
}

void run(const options& asked) {
  const std::set<int> different(asked.exponents.begin(), asked.exponents.end());
  if (different.size() != asked.exponents.size())
    throw usage_error("--exponents has one twice, expected different ones");
  const output_directory folder(asked.output.string());
  const auto place = [&](const std::string& name) { return (asked.output / name).string(); };
  // Opened first, so that none is written if one cannot be.
  output_file waves(place("quadratic.vcd"), ".vcd");
  output_file report(place("report.md"));
  output_file sheet_file(place("sphere.png"));
  std::vector<std::unique_ptr<output_file>> picture_files;
  for (const int n : asked.exponents)
    picture_files.push_back(std::make_unique<output_file>(place(fmt::format("sphere_n{}.png", n))));

  golden::sphere_scene ball;
  ball.side = asked.side;
  const std::vector<sample> samples = sample_sphere(ball);
  const double scale = std::ldexp(1.0, fraction_bits(asked.device));
  const auto line = asked.device.coefficient == "published" ? golden::coefficient_line::published
                                                            : golden::coefficient_line::derived;
  const auto device = bench::make_systemc(asked.device);
  device->trace(waves.temporary_path().substr(0, waves.temporary_path().size() - std::strlen(".vcd")));
  compute_highlights(*device, row_through_highlight(samples, asked.side), traced_exponent(asked), scale);
  if (!device->stop_trace())
    throw file_error(place("quadratic.vcd"), 0, "cannot be written to its end, expected room for it");

  picture sheet(asked.side * static_cast<int>(asked.exponents.size()), 3 * asked.side);
  std::vector<outcome> outcomes;
  double host_s = 0;
  for (const int n : asked.exponents) {
    const auto started = std::chrono::steady_clock::now();
    const results colours = compute_highlights(*device, samples, n, scale);
    host_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    const auto real = [scale](std::int64_t raw) { return static_cast<double>(raw) / scale; };
    const picture from_device = shade(asked.side, samples, [&](std::size_t i) {
      return rgb{real(colours.red[i]), real(colours.green[i]), real(colours.blue[i])};
    });
    const picture blinn = shade(asked.side, samples, [&](std::size_t i) {
      return scaled(golden::blinn<double>(n, samples[i].cos_delta));
    });
    const picture formula = shade(asked.side, samples, [&](std::size_t i) {
      const double brdf = golden::quadratic<double>(line, n, samples[i].cos_delta);
      return scaled(asked.device.as_published ? brdf : std::fmax(brdf, 0.0));
    });
    const picture unscaled = scene::difference(blinn, from_device, 1);
    outcomes.push_back({n, nmse(blinn, from_device), nmse(formula, from_device),
                        *std::max_element(unscaled.rgb.begin(), unscaled.rgb.end())});
    const int x = asked.side * static_cast<int>(outcomes.size() - 1);
    scene::paste(from_device, sheet, x, 0);
    scene::paste(blinn, sheet, x, asked.side);
    scene::paste(scene::difference(blinn, from_device, kDifferenceGain), sheet, x, 2 * asked.side);
    picture_files[outcomes.size() - 1]->write(scene::png_of(from_device));
    picture_files[outcomes.size() - 1]->close();
  }
  sheet_file.write(scene::png_of(sheet));
  sheet_file.close();
  report.write(report_text(asked, outcomes, samples.size(), *device, host_s));
  report.close();
  for (const auto& file : picture_files) file->commit();
  for (output_file* file : {&waves, &sheet_file, &report}) file->commit();

  for (const outcome& o : outcomes) fmt::print("n = {:4}   NMSE to Blinn {:.3e}\n", o.n, o.nmse_blinn);
  for (const char* file : {"sphere.png", "report.md", "quadratic.vcd"}) {
    fmt::print("{}\n", printable(place(file)));
  }
  fmt::print("see the waves with: scripts/wave {}\n", as_word(place("quadratic.vcd")));
}

int run(int argc, char** argv) {
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  // Waves of nothing are nothing to warn of: a run that fails before its first write has its own message.
  sc_core::sc_report_handler::set_actions(sc_core::SC_ID_TRACING_CLOSE_EMPTY_FILE_, sc_core::SC_DO_NOTHING);
  options asked;
  CLI::App program{"A lit sphere whose highlight the SystemC device computes: pictures, waves, report",
                   "sphere"};
  program.add_option("--output", asked.output, "folder for sphere.png, report.md, quadratic.vcd")
      ->take_last()
      ->capture_default_str();
  program.add_option("--format", asked.device.format, "fraction bits of cos(delta)")
      ->check(CLI::IsMember(std::vector<std::string>(std::begin(format_names), std::end(format_names))))
      ->capture_default_str();
  program.add_option("--coefficient", asked.device.coefficient, "published or derived")
      ->check(CLI::IsMember({"published", "derived"}))
      ->capture_default_str();
  program.add_flag("--as-published", asked.device.as_published, "keep the negative lobe");
  program.add_option("--exponents", asked.exponents, "specular exponents, 1..1000")
      ->delimiter(',')
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  program.add_option("--side", asked.side, "pixels")->check(CLI::Range(16, 4096))->capture_default_str();
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return program.exit(success);
  } catch (const CLI::Error& error) {
    throw usage_error(fmt::format("{}, see sphere --help", error.what()));
  }
  run(asked);
  return 0;
}

}  // namespace

int sc_main(int, char**) {
  return 0;
}

int main(int argc, char** argv) {
  return blysk::run_program("sphere", [&] { return run(argc, argv); });
}
