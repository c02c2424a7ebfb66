// SPDX-License-Identifier: Apache-2.0
#include "tb/certificate/scripts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <tuple>

#include "tb/certificate/curves.h"
#include "tb/cost/cost_row.h"
#include "tb/golden/referee.h"

namespace blysk {
namespace {

namespace fs = std::filesystem;

/// The names in an expression of Gappa.
std::set<std::string> names_in(const std::string& text) {
  std::set<std::string> names;
  static const std::regex name(R"([A-Za-z_]\w*)");
  // Numbers such as 1b-8 hold no name.
  const std::string plain = std::regex_replace(text, std::regex(R"(\b\d+(\.\d+)?[be][-+]?\d+)"), "0");
  for (std::sregex_iterator each(plain.begin(), plain.end(), name), end; each != end; ++each)
    names.insert(each->str());
  return names;
}

const std::set<std::string> kWords{"in", "fixed", "int", "dn"};

std::string conjunction(const std::vector<std::string>& parts) {
  return fmt::format("{}", fmt::join(parts, " /\\ "));
}

/// "[-1b-10,1b-10]" around 0. \param within  last places, rounded up to 2^-20 of one
std::string around_zero(const std::string& within, int frac) {
  constexpr int kMore = 20;
  const auto raw = static_cast<std::int64_t>(std::ceil(std::ldexp(std::stod(within), kMore)));
  return fmt::format("[-{0}b{1},{0}b{1}]", raw, -frac - kMore);
}

/// The text with a word in the place of a name.
std::string with_word(const std::string& text, const std::string& name, const std::string& word) {
  return std::regex_replace(text, std::regex("\\b" + name + "\\b"), word);
}

struct address_range {
  std::size_t first, last;
};

/// What is told apart on some way through the netlist: the addresses that each of these nets has. Others have all.
using address_group = std::map<std::string, address_range>;

class script_writer {
 public:
  script_writer(const specification& exact, const netlist::gappa_netlist& netlist, const std::string& title,
                const fs::path& folder)
      : exact_(exact), netlist_(netlist), title_(title), folder_(folder) {
    for (const netlist::memory_net& memory : netlist_.memories) {
      if (!is_of_exponents(memory) && std::ranges::none_of(exact_.curves, [&](const curve_claim& of) {
            return of.begin == memory.net || of.change == memory.net;
          }))
        throw std::logic_error(fmt::format("the certificate says nothing of the memory of {}", memory.net));
    }
  }

  void write(const std::string& bound) {
    for (const netlist::memory_net& memory : netlist_.memories) {
      if (is_of_exponents(memory)) write_memory(memory);
    }
    write_words();
    write_claims();
    int number = 0;
    for (const netlist::gappa_path& path : netlist_.paths) {
      for (const address_group& group : groups_of(path)) {
        std::vector<std::string> given = facts_of(path, group);
        for (const auto* more : {&exact_.claims, &path.conditions})
          given.insert(given.end(), more->begin(), more->end());
        for (const exact_case& each : cases_of(path)) write_case(++number, path, given, each, bound);
      }
    }
  }

 private:
  /// Its words are numbers of an exponent, whose addresses begin at 1.
  bool is_of_exponents(const netlist::memory_net& memory) const {
    return std::ranges::find(exact_.memories, memory.net, &memory_claim::net) != exact_.memories.end();
  }

  const netlist::memory_net& memory_of(const std::string& net) const {
    const auto found = std::ranges::find(netlist_.memories, net, &netlist::memory_net::net);
    if (found == netlist_.memories.end())
      throw std::logic_error(
          fmt::format("the certificate speaks of the memory of {}, which is not there", net));
    return *found;
  }

  /// What the error of a word is at most, in last places.
  const std::string& within(const netlist::memory_net& memory, std::size_t address) const {
    const std::string* found = nullptr;
    for (const memory_claim& each : exact_.memories) {
      if (each.net == memory.net && each.from <= address) found = &each.within;
    }
    if (found == nullptr) throw std::logic_error(fmt::format("no bound of the words of {}", memory.net));
    return *found;
  }

  /// The exact BRDF and where it is that; on a way of its own everywhere.
  std::vector<exact_case> cases_of(const netlist::gappa_path& path) const {
    for (const exact_case& way : exact_.ways) {
      if (std::ranges::find(path.conditions, way.condition) != path.conditions.end())
        return {{"", way.value, way.if_formula}};
    }
    return exact_.cases;
  }

  /// Every group of one net with every group of the others.
  std::vector<address_group> groups_of(const netlist::gappa_path& path) const {
    std::vector<address_group> all{{}};
    for (const address_groups& asked : exact_.groups) {
      if (!asked.condition.empty() &&
          std::ranges::find(path.conditions, asked.condition) == path.conditions.end())
        continue;
      std::vector<address_group> finer;
      for (const address_group& group : all) {
        for (const address_range& addresses : ranges_of(asked)) {
          finer.push_back(group);
          if (!finer.back().try_emplace(asked.net, addresses).second)
            throw std::logic_error(fmt::format("the certificate tells addresses {} apart twice", asked.net));
        }
      }
      all = std::move(finer);
    }
    return all;
  }

  std::vector<address_range> ranges_of(const address_groups& asked) const {
    const auto memory = std::ranges::find(netlist_.memories, asked.net, &netlist::memory_net::index);
    if (memory == netlist_.memories.end()) {
      throw std::logic_error(fmt::format(
          "the certificate tells addresses {} apart, expected a net that addresses a memory", asked.net));
    }
    const std::size_t words = memory->words.size();
    std::vector<address_range> ranges;
    std::size_t first = is_of_exponents(*memory) ? 1 : 0;
    for (const std::string& each : asked.firsts) {
      const std::size_t slash = each.find('/');
      const std::size_t next = slash == std::string::npos
                                   ? std::stoul(each)
                                   : words * std::stoul(each) / std::stoul(each.substr(slash + 1));
      if (next <= first || next >= words)
        throw std::logic_error(fmt::format("addresses {} cannot be told apart at {}", asked.net, each));
      ranges.push_back({first, next - 1});
      first = next;
    }
    ranges.push_back({first, words - 1});
    return ranges;
  }

  address_range addresses_of(const netlist::memory_net& memory, const address_group& group) const {
    const auto found = group.find(memory.index);
    if (found != group.end()) return found->second;
    return {is_of_exponents(memory) ? std::size_t{1} : 0, memory.words.size() - 1};
  }

  static bool defines(const netlist::gappa_path& path, const std::string& net) {
    return std::ranges::any_of(path.definitions,
                               [&](const std::string& line) { return line.starts_with(net + " = "); });
  }

  /// What is given on a way, for the addresses of a group.
  std::vector<std::string> facts_of(const netlist::gappa_path& path, const address_group& group) {
    std::vector<std::string> given = exact_.facts;
    given.insert(given.end(), path.facts.begin(), path.facts.end());
    for (const auto& [net, addresses] : group)
      given.push_back(fmt::format("{} in [{},{}]", net, addresses.first, addresses.last));
    for (const netlist::memory_net& memory : netlist_.memories)
      add_words(memory, addresses_of(memory, group), given);
    for (const std::string& each : exact_.words) given.push_back(each + " >= 0");
    for (const curve_claim& claim : exact_.curves) {
      if (!defines(path, claim.place)) continue;
      const std::vector<std::string>& lines = facts_of_lines(claim, group);
      given.insert(given.end(), lines.begin(), lines.end());
    }
    return given;
  }

  /// Where the words lie, and how far from what they stand for.
  void add_words(const netlist::memory_net& memory, const address_range& addresses,
                 std::vector<std::string>& given) const {
    const auto [first, last] = addresses;
    if (is_of_exponents(memory)) {
      std::string widest = within(memory, first);
      for (std::size_t n = first + 1; n <= last; ++n) {
        if (std::stod(within(memory, n)) > std::stod(widest)) widest = within(memory, n);
      }
      const auto claim = std::ranges::find(exact_.memories, memory.net, &memory_claim::net);
      given.push_back(
          fmt::format("{} - {} in {}", memory.net, claim->name, around_zero(widest, memory.frac)));
    }
    const auto word = [&](std::size_t at) { return memory.words.begin() + static_cast<std::ptrdiff_t>(at); };
    const auto [low, high] = std::minmax_element(word(first), word(last) + 1);
    given.push_back(fmt::format("{} in [{}b{},{}b{}]", memory.net, *low, -memory.frac, *high, -memory.frac));
  }

  /// How far lines are from their curve, and where this lies; found once for each group.
  const std::vector<std::string>& facts_of_lines(const curve_claim& claim, const address_group& group) {
    const netlist::memory_net& begins = memory_of(claim.begin);
    const netlist::memory_net& changes = memory_of(claim.change);
    if (begins.index != changes.index)
      throw std::logic_error(fmt::format("{} and {} have other addresses", begins.net, changes.net));
    const auto [first, last] = addresses_of(begins, group);
    const auto [found, is_new] = lines_.try_emplace({claim.name, first, last});
    if (!is_new) return found->second;
    const convex_curve& curve = convex_curves().at(claim.function);
    const stored_lines lines{.begins = begins.words,
                             .changes = changes.words,
                             .begin_frac = begins.frac,
                             .change_frac = changes.frac,
                             .from = dyadic(claim.from),
                             .length = dyadic(claim.length) / begins.words.size(),
                             .half = dyadic(claim.half)};
    const std::string half = claim.half == "0" ? "" : " - " + claim.half;
    const std::string error =
        fmt::format("{} + {} * {}{} - {}", claim.begin, claim.change, claim.place, half, claim.name);
    const errors_of_lines errors = compare(lines, curve, first, last);
    std::vector<std::string>& facts = found->second;
    facts.push_back(fmt::format("{} in {}", error, errors.absolute.text()));
    if (claim.is_relative)
      facts.push_back(fmt::format("({}) / {} in {}", error, claim.name, errors.relative.text()));
    facts.push_back(fmt::format("{} in {}", claim.name, range_of_curve(lines, curve, first, last).text()));
    return facts;
  }

  /// "5" or "1b-12"
  static golden::referee dyadic(const std::string& text) {
    const std::size_t b = text.find('b');
    return ldexp(golden::referee(std::stoll(text)),
                 b == std::string::npos ? 0 : std::stoi(text.substr(b + 1)));
  }

  void write_case(int number, const netlist::gappa_path& path, std::vector<std::string> given,
                  const exact_case& exact, const std::string& bound) const {
    if (!exact.condition.empty()) given.push_back(exact.condition);
    const std::string error =
        exact.value == "0" ? kCertifiedNet : fmt::format("{} - {}", kCertifiedNet, exact.value);
    std::string wanted = bound.empty() ? error + " in ?" : fmt::format("{} in [-{},{}]", error, bound, bound);
    if (!bound.empty() && !exact.if_formula.empty()) wanted = conjunction({exact.if_formula, wanted});
    // A constant needs no splits.
    static const std::regex constant(std::string(kCertifiedNet) + R"( = -?\d+b-?\d+;)");
    const bool is_plain = std::regex_match(path.definitions.back(), constant);
    write_script(fmt::format("case_{}.g", number), path, given, wanted, !is_plain);
  }

  void write_script(const std::string& name, const netlist::gappa_path& path,
                    const std::vector<std::string>& given, const std::string& wanted, bool has_splits) const {
    std::string text = fmt::format("# {}\n", title_);
    std::set<std::string> known = kWords;
    const auto is_known = [&known](const std::string& of) {
      return std::ranges::includes(known, names_in(of));
    };
    for (const std::string& line : path.definitions) text += line + "\n";
    for (const auto* lines : {&path.definitions, &given}) {
      for (const std::string& line : *lines) known.merge(names_in(line));
    }
    // What speaks of nets of other ways is left out.
    for (const auto& [let, expression] : exact_.lets) {
      if (!is_known(expression)) continue;
      text += fmt::format("{} = {};\n", let, expression);
      known.insert(let);
    }
    text += fmt::format("{{ {} ->\n  {} }}\n", conjunction(given), wanted);
    for (const std::string& hint : path.hints) text += hint + "\n";
    for (const std::string& hint : exact_.hints) {
      if (is_known(hint)) text += hint + ";\n";
    }
    if (has_splits) {
      for (const std::string& split : exact_.splits) text += "$ " + split + ";\n";
    }
    cost::write_text((folder_ / name).string(), text);
  }

  /// Of the way that defines most.
  void write_claims() {
    const auto size = [](const netlist::gappa_path& path) { return path.definitions.size(); };
    const netlist::gappa_path& path = *std::ranges::max_element(netlist_.paths, {}, size);
    int number = 0;
    for (const std::string& claim : exact_.claims)
      write_script(fmt::format("claim_{}.g", ++number), path, facts_of(path, {}), claim, false);
  }

  /// Each word beside what it stands for.
  void write_memory(const netlist::memory_net& memory) const {
    const auto claim = std::ranges::find(exact_.memories, memory.net, &memory_claim::net);
    const auto let = std::ranges::find(exact_.lets, claim->name, &named_texts::value_type::first);
    std::vector<std::string> given, wanted;
    for (std::size_t n = 1; n < memory.words.size(); ++n) {
      std::string exact;
      if (let != exact_.lets.end()) {
        exact = fmt::format("({})", with_word(let->second, memory.index, std::to_string(n)));
      } else {
        const auto number = std::ranges::find(exact_.numbers, claim->name, &named_texts::value_type::first);
        if (number == exact_.numbers.end())
          throw std::logic_error(fmt::format("the certificate does not say what {} is", claim->name));
        exact = fmt::format("exact_{}", n);
        const golden::referee value = numbers_of().at(number->second)(golden::referee(n));
        given.push_back(fmt::format("{} in {}", exact, outward(value, value).text()));
      }
      wanted.push_back(fmt::format("{}b{} - {} in {}", memory.words[n], -memory.frac, exact,
                                   around_zero(within(memory, n), memory.frac)));
    }
    write_goals("memory_" + memory.net, exact_.facts, given, wanted);
  }

  /// What holds of the words of one address.
  void write_words() const {
    int number = 0;
    for (const std::string& each : exact_.words) {
      const std::set<std::string> names = names_in(each);
      std::vector<const netlist::memory_net*> memories;
      for (const std::string& name : names) memories.push_back(&memory_of(name));
      std::vector<std::string> wanted;
      for (std::size_t n = 1; n < memories.front()->words.size(); ++n) {
        std::string text = each;
        for (const netlist::memory_net* memory : memories)
          text = with_word(text, memory->net, fmt::format("{}b{}", memory->words.at(n), -memory->frac));
        wanted.push_back(text + " >= 0");
      }
      write_goals(fmt::format("words_{}", ++number), {}, {}, wanted);
    }
  }

  /// \param facts  given for all   \param given  as many as wanted, or none
  void write_goals(const std::string& name, const std::vector<std::string>& facts,
                   const std::vector<std::string>& given, const std::vector<std::string>& wanted) const {
    // A script takes some hundred goals in little time.
    constexpr std::size_t kAtOnce = 100;
    for (std::size_t first = 0; first < wanted.size(); first += kAtOnce) {
      const auto part = [first](const std::vector<std::string>& of) {
        const auto at = [&of](std::size_t i) {
          return of.begin() + static_cast<std::ptrdiff_t>(std::min(i, of.size()));
        };
        return std::vector<std::string>(at(first), at(first + kAtOnce));
      };
      std::vector<std::string> all = facts;
      const std::vector<std::string> more = part(given);
      all.insert(all.end(), more.begin(), more.end());
      cost::write_text((folder_ / fmt::format("{}_{}.g", name, first + 1)).string(),
                       fmt::format("# {}: {}\n{{ {}\n  {} }}\n", title_, name,
                                   all.empty() ? "" : conjunction(all) + " ->", conjunction(part(wanted))));
    }
  }

  const specification& exact_;
  const netlist::gappa_netlist& netlist_;
  const std::string& title_;
  const fs::path& folder_;
  std::map<std::tuple<std::string, std::size_t, std::size_t>, std::vector<std::string>> lines_;
};

}  // namespace

void write_scripts(const specification& exact, const netlist::gappa_netlist& netlist,
                   const std::string& title, const std::string& bound, const fs::path& folder) {
  script_writer(exact, netlist, title, folder).write(bound);
}

}  // namespace blysk
