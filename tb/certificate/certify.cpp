// SPDX-License-Identifier: Apache-2.0
// certify scripts FOLDER --device D --format F ... [--bound B] [--fault F]: scripts for Gappa, FOLDER/*.g, that together say
//   |BRDF of the netlist - BRDF of the exact formula| <= B for all legal codes. Without --bound those of the cases, case_*.g,
//   ask for their error instead.
// certify compare --device D --format F ...: the definitions that Gappa is told are what the bit-accurate model computes, at
//   20,000 random inputs and at the ends of the codes. Exit 1 where they differ.
// certify row FILE --device D --format F ... --bound B --gappa VERSION: measures the largest error of the bit-accurate model,
//   and writes both as a certificate.
// certify place --device D --format F ...: prints where the certificate stands below docs/tables.
// certify page TABLES PAGE [--check]: the table of all certificates in a page.
// What is exact, and what Gappa has to be told of it, stands in tb/devices/<identifier>/certificate; specification.h has its form.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <regex>
#include <set>

#include "tb/certificate/curves.h"
#include "tb/certificate/definitions.h"
#include "tb/certificate/specification.h"
#include "tb/cost/certificate_row.h"
#include "tb/cost/cost_row.h"
#include "tb/cost/delays.h"
#include "tb/device_arguments.h"
#include "tb/golden/referee.h"
#include "tb/netlist/gappa_path.h"
#include "tb/program.h"
#include "tb/specular/specular.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;
namespace fs = std::filesystem;

constexpr const char* kResult = "brdf";

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

/// The addresses of a net on some way through the netlist, all of them or a part.
struct address_group {
  std::string net;  ///< empty: none is told apart
  address_range addresses{};
};

class script_writer {
 public:
  script_writer(specification exact, netlist::gappa_netlist netlist, std::string title)
      : exact_(std::move(exact)), netlist_(std::move(netlist)), title_(std::move(title)) {
    for (const netlist::memory_net& memory : netlist_.memories) {
      if (!is_of_exponents(memory) && std::ranges::none_of(exact_.curves, [&](const curve_claim& of) {
            return of.begin == memory.net || of.change == memory.net;
          }))
        throw std::logic_error(fmt::format("the certificate says nothing of the memory of {}", memory.net));
    }
  }

  void write(const fs::path& folder, const std::string& bound) const {
    for (const netlist::memory_net& memory : netlist_.memories) {
      if (is_of_exponents(memory)) write_memory(folder, memory);
    }
    write_words(folder);
    write_claims(folder);
    int number = 0;
    for (const netlist::gappa_path& path : netlist_.paths) {
      for (const address_group& group : groups_of(path)) {
        for (const auto& [condition, value, if_formula] : cases_of(path)) {
          std::vector<std::string> given = facts_of(path, group);
          for (const auto* more : {&exact_.claims, &path.conditions})
            given.insert(given.end(), more->begin(), more->end());
          if (!condition.empty()) given.push_back(condition);
          const std::string error = value == "0" ? kResult : fmt::format("{} - {}", kResult, value);
          // A constant needs no splits.
          static const std::regex constant(std::string(kResult) + R"( = -?\d+b-?\d+;)");
          const bool is_plain = std::regex_match(path.definitions.back(), constant);
          std::string wanted =
              bound.empty() ? error + " in ?" : fmt::format("{} in [-{},{}]", error, bound, bound);
          if (!bound.empty() && !if_formula.empty()) wanted = conjunction({if_formula, wanted});
          write_script(folder / fmt::format("case_{}.g", ++number), path, given, wanted, !is_plain);
        }
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

  std::vector<address_group> groups_of(const netlist::gappa_path& path) const {
    std::vector<address_group> all;
    for (const address_groups& asked : exact_.groups) {
      if (!asked.condition.empty() &&
          std::ranges::find(path.conditions, asked.condition) == path.conditions.end())
        continue;
      const auto memory = std::ranges::find(netlist_.memories, asked.net, &netlist::memory_net::index);
      if (memory == netlist_.memories.end() || !all.empty())
        throw std::logic_error(
            fmt::format("the certificate tells addresses {} apart, expected those of one "
                        "net that addresses a memory",
                        asked.net));
      const std::size_t words = memory->words.size();
      std::size_t first = is_of_exponents(*memory) ? 1 : 0;
      for (const std::string& each : asked.firsts) {
        const std::size_t slash = each.find('/');
        const std::size_t next = slash == std::string::npos
                                     ? std::stoul(each)
                                     : words * std::stoul(each) / std::stoul(each.substr(slash + 1));
        if (next <= first || next >= words)
          throw std::logic_error(fmt::format("addresses {} cannot be told apart at {}", asked.net, each));
        all.push_back({asked.net, {first, next - 1}});
        first = next;
      }
      all.push_back({asked.net, {first, words - 1}});
    }
    if (all.empty()) all.emplace_back();
    return all;
  }

  address_range addresses_of(const netlist::memory_net& memory, const address_group& group) const {
    if (group.net == memory.index) return group.addresses;
    return {is_of_exponents(memory) ? std::size_t{1} : 0, memory.words.size() - 1};
  }

  /// What is given on a way, for the addresses of a group.
  std::vector<std::string> facts_of(const netlist::gappa_path& path, const address_group& group) const {
    std::vector<std::string> given = exact_.facts;
    given.insert(given.end(), path.facts.begin(), path.facts.end());
    if (!group.net.empty())
      given.push_back(fmt::format("{} in [{},{}]", group.net, group.addresses.first, group.addresses.last));
    for (const netlist::memory_net& memory : netlist_.memories) {
      const auto [first, last] = addresses_of(memory, group);
      if (is_of_exponents(memory)) {
        std::string widest = within(memory, first);
        for (std::size_t n = first + 1; n <= last; ++n) {
          if (std::stod(within(memory, n)) > std::stod(widest)) widest = within(memory, n);
        }
        const auto claim = std::ranges::find(exact_.memories, memory.net, &memory_claim::net);
        given.push_back(
            fmt::format("{} - {} in {}", memory.net, claim->name, around_zero(widest, memory.frac)));
      }
      const auto word = [&](std::size_t at) {
        return memory.words.begin() + static_cast<std::ptrdiff_t>(at);
      };
      const auto [low, high] = std::minmax_element(word(first), word(last) + 1);
      given.push_back(
          fmt::format("{} in [{}b{},{}b{}]", memory.net, *low, -memory.frac, *high, -memory.frac));
    }
    for (const std::string& each : exact_.words) given.push_back(each + " >= 0");
    for (const curve_claim& claim : exact_.curves) {
      const netlist::memory_net& begins = memory_of(claim.begin);
      const netlist::memory_net& changes = memory_of(claim.change);
      if (begins.index != changes.index)
        throw std::logic_error(fmt::format("{} and {} have other addresses", begins.net, changes.net));
      const convex_curve& curve = convex_curves().at(claim.function);
      const stored_lines lines{.begins = begins.words,
                               .changes = changes.words,
                               .begin_frac = begins.frac,
                               .change_frac = changes.frac,
                               .from = dyadic(claim.from),
                               .length = dyadic(claim.length) / begins.words.size(),
                               .half = dyadic(claim.half)};
      const auto [first, last] = addresses_of(begins, group);
      const std::string half = claim.half == "0" ? "" : " - " + claim.half;
      const std::string error =
          fmt::format("{} + {} * {}{} - {}", claim.begin, claim.change, claim.place, half, claim.name);
      const errors_of_lines errors = compare(lines, curve, first, last);
      given.push_back(fmt::format("{} in {}", error, errors.absolute.text()));
      if (claim.is_relative)
        given.push_back(fmt::format("({}) / {} in {}", error, claim.name, errors.relative.text()));
      given.push_back(fmt::format("{} in {}", claim.name, range_of_curve(lines, curve, first, last).text()));
    }
    return given;
  }

  /// "5" or "1b-12"
  static golden::referee dyadic(const std::string& text) {
    const std::size_t b = text.find('b');
    return ldexp(golden::referee(std::stoll(text)),
                 b == std::string::npos ? 0 : std::stoi(text.substr(b + 1)));
  }

  void write_script(const fs::path& file, const netlist::gappa_path& path,
                    const std::vector<std::string>& given, const std::string& wanted, bool has_splits) const {
    std::string text = fmt::format("# {}\n", title_);
    std::set<std::string> known = kWords;
    for (const std::string& line : path.definitions) text += line + "\n";
    for (const auto& [name, expression] : exact_.lets) text += fmt::format("{} = {};\n", name, expression);
    for (const auto* lines : {&path.definitions, &given}) {
      for (const std::string& line : *lines) known.merge(names_in(line));
    }
    for (const auto& [name, expression] : exact_.lets) known.insert(name);
    text += fmt::format("{{ {} ->\n  {} }}\n", conjunction(given), wanted);
    for (const std::string& hint : path.hints) text += hint + "\n";
    for (const std::string& hint : exact_.hints) {
      if (std::ranges::includes(known, names_in(hint))) text += hint + ";\n";
    }
    if (has_splits) {
      for (const std::string& split : exact_.splits) text += "$ " + split + ";\n";
    }
    cost::write_text(file.string(), text);
  }

  /// Of the way that defines most.
  void write_claims(const fs::path& folder) const {
    const auto size = [](const netlist::gappa_path& path) { return path.definitions.size(); };
    const netlist::gappa_path& path = *std::ranges::max_element(netlist_.paths, {}, size);
    int number = 0;
    for (const std::string& claim : exact_.claims)
      write_script(folder / fmt::format("claim_{}.g", ++number), path, facts_of(path, {}), claim, false);
  }

  /// Each word beside what it stands for.
  void write_memory(const fs::path& folder, const netlist::memory_net& memory) const {
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
    write_goals(folder, "memory_" + memory.net, exact_.facts, given, wanted);
  }

  /// What holds of the words of one address.
  void write_words(const fs::path& folder) const {
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
      write_goals(folder, fmt::format("words_{}", ++number), {}, {}, wanted);
    }
  }

  /// \param facts  given for all   \param given  as many as wanted, or none
  void write_goals(const fs::path& folder, const std::string& name, const std::vector<std::string>& facts,
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
      cost::write_text((folder / fmt::format("{}_{}.g", name, first + 1)).string(),
                       fmt::format("# {}: {}\n{{ {}\n  {} }}\n", title_, name,
                                   all.empty() ? "" : conjunction(all) + " ->", conjunction(part(wanted))));
    }
  }

  specification exact_;
  netlist::gappa_netlist netlist_;
  std::string title_;
};

netlist::planted_fault fault_of(const std::string& name) {
  if (name == "no_rounding") return netlist::planted_fault::no_rounding;
  if (name == "narrow_words") return netlist::planted_fault::narrow_words;
  return netlist::planted_fault::none;
}

/// The codes of the cosine that are tried at n: all of them, or in wide formats those beside 0, the root and 1, and some
/// at random.
class codes_of {
 public:
  explicit codes_of(const selection& asked) : last_(std::uint64_t{1} << asked.fraction()), asked_(asked) {}

  bool are_all() const { return asked_.fraction() <= 20; }

  /// Calls use(first, size) for runs of codes.
  template <class Use>
  void visit(int n, Use use) {
    constexpr std::uint64_t kBlock = 1 << 14;
    if (are_all()) {
      for (std::uint64_t first = 0; first <= last_; first += kBlock)
        use(first, std::min(kBlock, last_ + 1 - first));
      return;
    }
    const auto& device = dynamic_cast<const specular::device_of_points&>(asked_.of());
    const auto root =
        static_cast<std::uint64_t>(std::llround(device.root(asked_, n) * static_cast<double>(last_)));
    for (const std::uint64_t middle : {std::uint64_t{0}, root, last_}) {
      const std::uint64_t first = middle < kBlock / 2 ? 0 : std::min(middle - kBlock / 2, last_ + 1 - kBlock);
      use(first, kBlock);
    }
    // Within the lobe.
    constexpr int kRuns = 64;
    constexpr std::uint64_t kRun = 256;
    for (int run = 0; run < kRuns; ++run) {
      const std::uint64_t span = last_ + 1 - root;
      if (span > kRun) use(root + random_() % (span - kRun), kRun);
    }
  }

 private:
  std::uint64_t last_;
  const selection& asked_;
  std::mt19937_64 random_{1};
};

/// The largest error of the bit-accurate model against the formula in double.
cost::seen_error measure(const selection& asked) {
  const double ulp = std::ldexp(1.0, -asked.fraction());
  const auto& device = dynamic_cast<const specular::device_of_points&>(asked.of());
  const auto formula =
      device.formula(choose(device.name(), asked.format(), asked.values(), purpose::formula));
  const auto bit = asked.of().make_bit(asked);
  columns in(columns(asked.of().ports(asked), port::role::data).layout());
  columns out(columns(asked.of().ports(asked), port::role::result).layout());
  codes_of codes(asked);
  cost::seen_error worst{.is_exhaustive = codes.are_all()};
  for (int n = 1; n <= 1000; ++n) {
    codes.visit(n, [&](std::uint64_t first, std::uint64_t size) {
      in.resize(size);
      for (std::size_t i = 0; i < size; ++i) {
        in[specular::kN].set(i, n);
        in[specular::kCos].set(i, static_cast<std::int64_t>(first + i));
      }
      bit->run(in, out);
      worst.inputs += size;
      out[specular::kBrdf].visit([&](const auto& brdf) {
        for (std::size_t i = 0; i < size; ++i) {
          const double c = static_cast<double>(first + i) * ulp;
          const double error = std::fabs(static_cast<double>(brdf[i]) * ulp - formula(n, c));
          if (error <= worst.max_abs_err) continue;
          worst.max_abs_err = error;
          worst.n = n;
          worst.cos = c;
        }
      });
    });
  }
  return worst;
}

/// The definitions beside the bit-accurate model.
int compare(const selection& asked, netlist::planted_fault fault) {
  constexpr std::size_t kInputs = 20000;
  constexpr std::uint32_t kExponents = 1000;
  const auto device = asked.of().elaborate(asked, 0);
  const netlist::gappa_netlist definitions = netlist::read_gappa(*device, kResult, fault);
  const std::vector<port> data = of_role(asked.of().ports(asked), port::role::data);
  const std::uint64_t last = std::uint64_t{1} << asked.fraction();
  columns in(columns(asked.of().ports(asked), port::role::data).layout());
  columns out(columns(asked.of().ports(asked), port::role::result).layout());
  in.resize(kInputs);
  std::mt19937_64 random(1);
  for (std::size_t i = 0; i < kInputs; ++i) {
    // Of the lobe, which is narrow, every second one.
    const std::uint64_t n = i < 4 ? 1 + (i / 2) * (kExponents - 1) : 1 + random() % kExponents;
    const std::uint64_t span = i % 2 == 0 ? last : 1 + last / n;
    const std::uint64_t c = i < 4 ? (i % 2) * last : last - random() % (span + 1);
    in[specular::kN].set(i, n);
    in[specular::kCos].set(i, c);
  }
  asked.of().make_bit(asked)->run(in, out);
  std::size_t lit = 0;
  for (std::size_t i = 0; i < kInputs; ++i) {
    const named_numbers given{
        {data[specular::kN].name + "_code", static_cast<long double>(in[specular::kN].get(i))},
        {data[specular::kCos].name + "_code", static_cast<long double>(in[specular::kCos].get(i))}};
    const std::optional<long double> told = compute(definitions, given, kResult);
    const auto raw = static_cast<long double>(out[specular::kBrdf].get(i));
    if (raw != 0) ++lit;
    if (told && std::ldexp(*told, asked.fraction()) == raw) continue;
    fmt::print("n = {}, cos code {}: the definitions give {}, the model code {}\n", in[specular::kN].get(i),
               in[specular::kCos].get(i),
               told ? fmt::format("{}", std::ldexp(*told, asked.fraction())) : "no path", raw);
    return 1;
  }
  fmt::print("{}: {} inputs, {} with a BRDF above 0, {} paths: equal\n", asked.text(), kInputs, lit,
             definitions.paths.size());
  return lit > kInputs / 10 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  asked_device asked;
  std::string folder, file, bound, fault, version, specification_file, tables, page;
  bool is_check = false;
  CLI::App *scripts = nullptr, *row = nullptr, *pages = nullptr, *comparison = nullptr, *place = nullptr;
  return run_program(
      argc, argv, "Bounds the error of a device's datapath with Gappa",
      [&](CLI::App& program) {
        program.require_subcommand(1);
        scripts = program.add_subcommand("scripts", "write scripts for Gappa");
        scripts->add_option("FOLDER", folder, "for the scripts")->required();
        scripts->add_option("--exact", specification_file, "the device's file certificate")->required();
        comparison = program.add_subcommand("compare", "compute what Gappa is told, beside the model");
        for (CLI::App* each : {scripts, comparison}) {
          each->add_option("--fault", fault, "planted in the netlist")
              ->check(CLI::IsMember({"none", "no_rounding", "narrow_words"}));
        }
        add_device_arguments(*comparison, asked, purpose::hardware);
        row = program.add_subcommand("row", "write a certificate beside the largest error that is seen");
        row->add_option("FILE", file, "to write")->required();
        row->add_option("--gappa", version, "its version")->required();
        for (CLI::App* each : {scripts, row}) {
          add_device_arguments(*each, asked, purpose::hardware);
          each->add_option("--bound", bound, "of the error");
        }
        place = program.add_subcommand("place", "print where the certificate stands below docs/tables");
        add_device_arguments(*place, asked, purpose::hardware);
        pages = program.add_subcommand("page", "write the table of all certificates");
        pages->add_option("TABLES", tables, "folder of the measured files")->required();
        pages->add_option("PAGE", page, "with the table")->required();
        pages->add_flag("--check", is_check, "fail if it differs instead");
      },
      [&] {
        if (pages->parsed()) {
          const std::string now = cost::read_text(page);
          const std::string wanted = cost::with_certificates(tables, page, now);
          if (!is_check) {
            cost::write_text(page, wanted);
          } else if (now != wanted) {
            fmt::print("{} is stale: the target update_certificates writes it\n", page);
            return 1;
          }
          return 0;
        }
        const selection chosen = asked.choose();
        if (place->parsed()) {
          fmt::print("{}\n", cost::row_path("certificate", chosen));
          return 0;
        }
        if (comparison->parsed()) return compare(chosen, fault_of(fault));
        if (scripts->parsed()) {
          const auto device = chosen.of().elaborate(chosen, 0);
          const script_writer writer(read_specification(specification_file, chosen.fraction()),
                                     netlist::read_gappa(*device, kResult, fault_of(fault)), chosen.text());
          writer.write(folder, bound);
        } else {
          const cost::certificate made{.device = chosen.of().name(),
                                       .format = chosen.format(),
                                       .options = cost::given_options(chosen),
                                       .digest = cost::digest_of(chosen),
                                       .gappa = version,
                                       .bound = std::stod(bound),
                                       .seen = measure(chosen)};
          cost::write_text(file, cost::stored_text(cost::json_of(made)));
        }
        return 0;
      });
}
