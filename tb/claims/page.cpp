// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/page.h"

#include <algorithm>
#include <array>

#include "tb/claims/judge.h"
#include "tb/claims/words.h"

namespace blysk::claims {
namespace {

constexpr std::string_view kIntroduction = R"(# What the seeds claim, and what is measured

[P] is the patent UA 60553, [A] the article, [T] the thesis that this project models.

## The rule for verdicts

A seed states figures; each is held against the figure under *measured*, as it is printed there. The *miss* is the
distance of the two in units of the last digit that the seed prints: 10.3 for a stated 3.2 misses by 71 units of 0.1.
A stated figure is **met** if the miss is half a unit or less, over the whole range that the seed names. For a limit
(at most, at least) what is on the good side has no miss; R2, the quality of a fit, is such a limit. A law (an equality,
R <= 1) has no printed digits, so any miss counts. Of m stated figures k are met:

| verdict | k |
| --- | --- |
| *holds* | k = m |
| *holds in part: k of m* | 0 < k < m; those met are named |
| *does not hold* | k = 0 |
| *depends on the reading* | k = m under the readings named, and not under others that the seed leaves open too |
| *cannot be judged* | the seed states no figure, or judging it takes what is named |

The column *largest miss* prints the largest of the row, with the measured and the stated figure; for a law these two
alone. One function gives all verdicts (`tb/claims/judge.h`); nothing is tuned to a claim.

## What holds the figures

*Held by* names a test that derives every figure of the row a second time, by another method (closed form, dense search,
series, literal formula), prints it like the page and expects the same digits. It also changes each digit and expects
the comparison to fail. *Regenerated only* stands for figures without a second derivation: `docs.verification`, which
measures everything again and fails on any difference, is all that holds them. The figures alone are in
[tables/measured.json](tables/measured.json), which those tests read, and the words in `tb/claims/claims.json`;
`claims.page` expects this page to be made of both, so that a digit changed here alone fails too.

    build/bin/claims --row T4
    build/bin/claims --output docs
    ctest --test-dir build -R 'docs.verification|claims'

Speeds depend on the machine; those quoted are of one run of `bench_golden`, kept in [tables/speed.csv](tables/speed.csv).
Errors by lobe and exponent: [tables/errors.md](tables/errors.md); errata one by one: [tables/errata.md](tables/errata.md).

Without a row: definitions, such as [T] (1.2) to (1.4) with s + d = 1, (2.20) to (2.22) and (2.27); what [T] says of
colour spaces (1.4), workplaces and electrical safety (chapter 4); how many pages and figures [T] has.
)";

constexpr std::string_view kProgram = "claims.rows: ";

}  // namespace

std::string held_by(const claim& c) {
  if (placeholders(c.measured).empty()) return "no figure";
  if (c.held_by.empty()) return "regenerated only";
  std::string result = std::string(kProgram) + c.held_by;
  std::string rest;
  for (const auto& key : c.regenerated_only) append(rest, ", ", key);
  if (!rest.empty()) result += "; regenerated only: " + rest;
  return result;
}

namespace {

std::string verdict_text(const judgement& j) {
  return std::string(j.verdict) + (j.detail.empty() ? "" : ": " + j.detail);
}

const std::map<std::string, std::string>& figures_of(const claim& c, const figure_list& list) {
  static const std::map<std::string, std::string> kNone;
  const auto found = list.find(c.id);
  return found == list.end() ? kNone : found->second;
}

}  // namespace

std::string row_text(const claim& c, const std::map<std::string, std::string>& printed) {
  const judgement j = judge(c, printed);
  return c.id + ", " + c.place + "\n  says:     " + c.says + "\n  measured: " + fill(c.measured, printed) +
         "\n  miss:     " + j.miss + "\n  verdict:  " + verdict_text(j) + "\n  held by:  " + held_by(c) +
         "\n";
}

std::string verification_page(const std::vector<section>& sections, const figure_list& list) {
  constexpr std::array kVerdicts{kHolds, kPartly, kFails, kDepends, kOpen};
  std::vector<std::vector<std::string>> summary{{"", "rows"}};
  for (const auto verdict : kVerdicts) summary.front().emplace_back(verdict);
  std::string tables;
  for (const auto& [title, rows] : sections) {
    std::array<int, kVerdicts.size()> counts{};
    std::vector<std::vector<std::string>> cells{
        {"row", "where", "the seed says", "measured", "largest miss", "verdict", "held by"}};
    for (const claim& c : rows) {
      const auto& printed = figures_of(c, list);
      const judgement j = judge(c, printed);
      ++counts[static_cast<std::size_t>(std::ranges::find(kVerdicts, j.verdict) - kVerdicts.begin())];
      cells.push_back(
          {c.id, c.place, c.says, fill(c.measured, printed), j.miss, verdict_text(j), held_by(c)});
    }
    tables += "\n## " + title + "\n\n" + markdown(cells);
    summary.push_back({title, std::to_string(rows.size())});
    for (const int count : counts) summary.back().push_back(std::to_string(count));
  }
  return std::string(kGenerated) + std::string(kIntroduction) + "\n" + markdown(summary) + tables;
}

}  // namespace blysk::claims
