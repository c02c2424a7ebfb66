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

#include "tb/device_arguments.h"
#include "tb/golden/lobe_formulas.h"
#include "tb/golden/sphere.h"
#include "tb/harness/systemc_engine.h"
#include "tb/output_file.h"
#include "tb/progress.h"
#include "tb/run_program.h"
#include "tb/scene/picture.h"
#include "tb/specular/specular.h"

namespace {

using namespace blysk;
using scene::picture;

struct options {
  asked_device device;
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

/// The highlight of every sample with exponent n, 0..255 by channel: each is a write.
std::vector<rgb> compute_highlights(engine& device, const std::vector<port>& ports,
                                    const std::vector<sample>& samples, int n) {
  constexpr std::size_t kChunk = 16384;
  const std::vector<port> of = of_role(ports, port::role::result);
  const double scale = std::ldexp(1.0, of_role(ports, port::role::data)[specular::kCos].carries->frac);
  columns writes(ports, port::role::data);
  columns results;
  std::vector<rgb> colours;
  progress shown(fmt::format("simulating n = {}", n), samples.size());
  for (std::size_t first = 0; first < samples.size(); first += writes.size()) {
    writes.resize(std::min(kChunk, samples.size() - first));
    for (std::size_t i = 0; i < writes.size(); ++i) {
      writes[specular::kN].set(i, n);
      writes[specular::kCos].set(i, std::llround(samples[first + i].cos_delta * scale));
      for (std::size_t channel = 0; channel < 3; ++channel)
        writes[specular::kRed + channel].set(i, kSpecular[channel]);
    }
    device.run(writes, results);
    for (std::size_t i = 0; i < writes.size(); ++i) {
      rgb& colour = colours.emplace_back();
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const column& from = results[specular::kOutRed + channel];
        const int frac = from.kind() == storage::f64 ? 0 : of[specular::kOutRed + channel].carries->frac;
        colour[channel] = std::ldexp(from.real(i), -frac);
      }
    }
    shown.advance(writes.size());
  }
  return colours;
}

/// [T] (3.1) over the 8-bit channels.
double nmse(const picture& reference, const picture& other) {
  return golden::nmse(std::vector<double>(reference.rgb.begin(), reference.rgb.end()),
                      std::vector<double>(other.rgb.begin(), other.rgb.end()));
}

struct outcome {
  int n;
  double nmse_blinn;    // device against Blinn: the price of the model
  double nmse_formula;  // device against its own formula in double: the price of the word length
  int largest;          // largest difference to Blinn in a channel
};

std::string report_text(const options& asked, const selection& chosen, const std::vector<outcome>& outcomes,
                        std::size_t pixels, const clocked_engine& device, double host_s) {
  const double simulated_ms = static_cast<double>(device.cycles()) * harness::kClockPeriodNs * 1e-6;
  std::string report = fmt::format(
      "# A sphere through a device of the patent\n\n"
      "In SystemC: {} ({}). A sphere of {} pixels in a picture of {} x {}, once per "
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
      chosen.text(), chosen.of().source(), pixels, asked.side, asked.side, device.writes(), device.cycles(),
      simulated_ms, 1e3 / harness::kClockPeriodNs, host_s, static_cast<double>(device.writes()) / host_s);
  for (const outcome& o : outcomes) {
    report += fmt::format("| {} | {:.3e} | {:.3e} | {} |\n", o.n, o.nmse_blinn, o.nmse_formula, o.largest);
  }
  report += fmt::format(
      "\n`sphere.png`: a column per exponent ({}); rows: the device, Blinn, {} times their difference.\n"
      "`sphere_n*.png`: the device's pictures alone. `{}.vcd`: the first writes, up to {} pixels of "
      "the row\n"
      "through the highlight, at n = {}.\n",
      fmt::join(asked.exponents, ", "), kDifferenceGain, chosen.of().identifier(), kTracedWrites,
      traced_exponent(asked));
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
  const selection chosen = asked.device.choose();
  const selection formula = asked.device.choose(purpose::formula);
  const std::vector<port> ports = chosen.of().ports(chosen);
  const std::string wave_name = chosen.of().identifier() + ".vcd";
  // Opened first, so that none is written if one cannot be.
  output_file waves(place(wave_name), ".vcd");
  output_file report(place("report.md"));
  output_file sheet_file(place("sphere.png"));
  std::vector<std::unique_ptr<output_file>> picture_files;
  for (const int n : asked.exponents)
    picture_files.push_back(std::make_unique<output_file>(place(fmt::format("sphere_n{}.png", n))));

  golden::sphere_scene ball;
  ball.side = asked.side;
  const std::vector<sample> samples = sample_sphere(ball);
  const auto device = harness::make_systemc(chosen);
  const auto own_formula = formula.of().make_golden(formula);
  device->trace(waves.temporary_path().substr(0, waves.temporary_path().size() - std::strlen(".vcd")));
  compute_highlights(*device, ports, row_through_highlight(samples, asked.side), traced_exponent(asked));
  if (!device->stop_trace())
    throw file_error(place(wave_name), 0, "cannot be written to its end, expected room for it");

  picture sheet(asked.side * static_cast<int>(asked.exponents.size()), 3 * asked.side);
  std::vector<outcome> outcomes;
  double host_s = 0;
  for (const int n : asked.exponents) {
    const auto started = std::chrono::steady_clock::now();
    const std::vector<rgb> colours = compute_highlights(*device, ports, samples, n);
    host_s += std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    const std::vector<rgb> real_colours = compute_highlights(*own_formula, ports, samples, n);
    const picture from_device = shade(asked.side, samples, [&](std::size_t i) { return colours[i]; });
    const picture from_formula = shade(asked.side, samples, [&](std::size_t i) { return real_colours[i]; });
    const picture blinn = shade(asked.side, samples, [&](std::size_t i) {
      return scaled(golden::blinn<double>(n, samples[i].cos_delta));
    });
    const picture unscaled = scene::difference(blinn, from_device, 1);
    outcomes.push_back({n, nmse(blinn, from_device), nmse(from_formula, from_device),
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
  report.write(report_text(asked, chosen, outcomes, samples.size(), *device, host_s));
  report.close();
  for (const auto& file : picture_files) file->commit();
  for (output_file* file : {&waves, &sheet_file, &report}) file->commit();

  for (const outcome& o : outcomes) fmt::print("n = {:4}   NMSE to Blinn {:.3e}\n", o.n, o.nmse_blinn);
  for (const std::string& file : {std::string("sphere.png"), std::string("report.md"), wave_name}) {
    fmt::print("{}\n", printable(place(file)));
  }
  fmt::print("see the waves with: scripts/wave {}\n", as_word(place(wave_name)));
}

int run(int argc, char** argv) {
  sc_core::sc_report_handler::set_actions(sc_core::SC_INFO, sc_core::SC_DO_NOTHING);
  // Waves of nothing are nothing to warn of: a run that fails before its first write has its own message.
  sc_core::sc_report_handler::set_actions(sc_core::SC_ID_TRACING_CLOSE_EMPTY_FILE_, sc_core::SC_DO_NOTHING);
  options asked;
  CLI::App program{"A lit sphere whose highlight the SystemC device computes: pictures, waves, report",
                   "sphere"};
  program.add_option("--output", asked.output, "folder for sphere.png, report.md and the waves")
      ->take_last()
      ->capture_default_str();
  add_device_arguments(program, asked.device, purpose::hardware);
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
