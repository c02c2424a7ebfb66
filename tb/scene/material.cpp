// SPDX-License-Identifier: Apache-2.0
#include "tb/scene/material.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "tb/usage_error.h"

namespace blysk::scene {
namespace {

constexpr int kMostExponent = 1000;

rgb legal_share(const char* name, const std::optional<rgb>& raw, const rgb& preset,
                std::vector<std::string>& notes) {
  if (!raw) return preset;
  rgb legal;
  std::ranges::transform(*raw, legal.begin(), [](double each) { return std::clamp(each, 0.0, 1.0); });
  if (legal != *raw)
    notes.push_back(fmt::format("{} {} cut to {}", name, fmt::join(*raw, " "), fmt::join(legal, " ")));
  return legal;
}

int legal_exponent(const std::optional<double>& raw, std::vector<std::string>& notes) {
  if (!raw) {
    notes.emplace_back("Ns absent, 1 taken");
    return 1;
  }
  const double rounded = std::round(std::clamp(*raw, 1.0, double{kMostExponent}));
  if (*raw < 1 || *raw > kMostExponent) {
    notes.push_back(fmt::format("Ns {} cut to {}", *raw, rounded));
  } else if (rounded != *raw) {
    notes.push_back(fmt::format("Ns {} rounded to {}", *raw, rounded));
  }
  return static_cast<int>(rounded);
}

/// 0, 1 or 2.
int legal_model(const raw_material& raw, bool has_highlight, std::vector<std::string>& notes) {
  if (!raw.illum) {
    if (has_highlight) notes.emplace_back("illum absent, 2 taken since Ks > 0");
    return has_highlight ? 2 : 1;
  }
  if (*raw.illum == 0 || *raw.illum == 1 || *raw.illum == 2) return static_cast<int>(*raw.illum);
  notes.push_back(fmt::format("illum {} taken as 2", *raw.illum));
  return 2;
}

}  // namespace

material make_legal(const raw_material& raw, std::vector<std::string>& messages) {
  std::vector<std::string> notes = raw.notes;
  material legal;
  legal.name = raw.name;
  const rgb none{0, 0, 0};
  const rgb emitted = legal_share("Ke", raw.ke, none, notes);
  const rgb kd = legal_share("Kd", raw.kd, none, notes);
  const rgb ka = legal_share("Ka", raw.ka, none, notes);
  const rgb ks = legal_share("Ks", raw.ks, none, notes);
  const int model = legal_model(raw, ks != none, notes);
  legal.emitted = emitted;
  if (model == 0) {
    legal.emitted = kd;
    if (emitted != none) notes.emplace_back("Ke dropped since illum is 0");
  } else {
    legal.kd = kd;
    legal.ka = ka;
  }
  if (model == 2 && ks != none) {
    legal.ks = ks;
    legal.n = legal_exponent(raw.n, notes);
  } else if (raw.n) {
    // Of a highlight that a scene file may give.
    std::vector<std::string> unsaid;
    legal.n = legal_exponent(raw.n, unsaid);
  }
  if (!raw.kd && !raw.ka && !raw.ks && !raw.ke) notes.emplace_back("no colour given, black");
  if (!notes.empty())
    messages.push_back(fmt::format("material '{}': {}", printable(raw.name), fmt::join(notes, "; ")));
  return legal;
}

material plain_material() {
  material plain;
  plain.name = "plain";
  plain.ka = {0.2, 0.3, 0.7};
  plain.kd = {0.14, 0.28, 0.59};
  plain.ks = {0.78, 0.745, 0.667};
  plain.n = 50;
  return plain;
}

}  // namespace blysk::scene
