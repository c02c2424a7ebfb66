// SPDX-License-Identifier: Apache-2.0
// certify scripts FOLDER --device D --format F ... [--bound B] [--fault F]: scripts for Gappa, FOLDER/*.g, that together say
//   |BRDF of the netlist - BRDF of the exact formula| <= B for all legal codes. Without --bound those of the cases, case_*.g,
//   ask for their error instead.
// certify compare --device D --format F ...: the definitions that Gappa is told are what the bit-accurate model computes, at
//   20,000 random inputs and at the ends of the codes. Exit 1 where they differ.
// certify row FILE --device D --format F ... --bound B --gappa VERSION: measures the largest error of the bit-accurate model,
//   and writes both as a certificate.
// certify page TABLES PAGE [--check]: the table of all certificates in a page.
// What is exact, and what Gappa has to be told of it, stands in tb/devices/<identifier>/certificate:
//   let NAME = EXPRESSION                    of the inputs' nets, and of numbers that facts give
//   fact FORMULA                             given
//   memory NET ~ NAME within W               the words differ from what NAME is by at most W last places; proved for each n,
//                                            the expression of NAME taken at n, or, without one, its digits in 50
//   claim FORMULA                            proved of the formula, then given
//   case NAME >= 0: VALUE                    the exact BRDF there
//   case NAME <= 0: VALUE
//   hint EXPRESSION -> EXPRESSION            a rewriting rule; Gappa proves it
//   split WHAT                               cases that Gappa tries one by one
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <set>
#include <sstream>

#include "tb/certificate/definitions.h"
#include "tb/cost/certificate_row.h"
#include "tb/cost/cost_row.h"
#include "tb/cost/delays.h"
#include "tb/device_arguments.h"
#include "tb/golden/coefficient.h"
#include "tb/golden/referee.h"
#include "tb/netlist/gappa_path.h"
#include "tb/program.h"
#include "tb/specular/specular.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;
namespace fs = std::filesystem;

constexpr const char* kResult = "brdf";

struct memory_claim {
  std::string net, name, within;
};

struct specification {
  std::vector<std::pair<std::string, std::string>> lets;
  std::vector<std::string> facts, claims, hints, splits;
  std::vector<memory_claim> memories;
  std::vector<std::pair<std::string, std::string>> cases;
};

specification read_specification(const std::string& path) {
  specification read;
  std::istringstream lines(cost::read_text(path));
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.empty() || line.front() == '#') continue;
    std::smatch found;
    const std::size_t blank = line.find(' ');
    const std::string word = line.substr(0, blank);
    const std::string rest = blank == std::string::npos ? "" : line.substr(blank + 1);
    if (word == "let" && std::regex_match(rest, found, std::regex(R"((\w+) = (.+))"))) {
      read.lets.emplace_back(found[1], found[2]);
    } else if (word == "memory" &&
               std::regex_match(rest, found, std::regex(R"((\w+) ~ (\w+) within ([0-9.]+))"))) {
      read.memories.push_back({found[1], found[2], found[3]});
    } else if (word == "case" && std::regex_match(rest, found, std::regex(R"((.+): (.+))"))) {
      read.cases.emplace_back(found[1], found[2]);
    } else if (word == "fact") {
      read.facts.push_back(rest);
    } else if (word == "claim") {
      read.claims.push_back(rest);
    } else if (word == "hint") {
      if (rest.find(" / ") != std::string::npos && rest.find(" <> 0") == std::string::npos)
        throw file_error(path, number, "divides by what may be 0, expected the condition { WHAT <> 0 }");
      read.hints.push_back(rest);
    } else if (word == "split") {
      read.splits.push_back(rest);
    } else {
      throw file_error(
          path, number,
          fmt::format("'{}' is unknown, expected let, fact, memory, claim, case, hint or split", line));
    }
  }
  const auto is_pair = [&] {
    if (read.cases.size() != 2) return false;
    const std::string& first = read.cases[0].first;
    const std::string name = first.substr(0, first.find(' '));
    return first == name + " >= 0" && read.cases[1].first == name + " <= 0";
  };
  if (!is_pair())
    throw file_error(path, 0, "has other cases than NAME >= 0 and NAME <= 0, which leave out nothing");
  return read;
}

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

class script_writer {
 public:
  script_writer(specification exact, netlist::gappa_netlist netlist, std::string title)
      : exact_(std::move(exact)), netlist_(std::move(netlist)), title_(std::move(title)) {
    for (const netlist::memory_net& memory : netlist_.memories) {
      const auto claim = std::ranges::find(exact_.memories, memory.net, &memory_claim::net);
      if (claim == exact_.memories.end())
        throw std::logic_error(fmt::format("the certificate says nothing of the memory of {}", memory.net));
      netlist_.facts.push_back(
          fmt::format("{} - {} in {}", memory.net, claim->name, around_zero(claim->within, memory.frac)));
      const auto [low, high] = std::minmax_element(memory.words.begin() + 1, memory.words.end());
      netlist_.facts.push_back(
          fmt::format("{} in [{}b{},{}b{}]", memory.net, *low, -memory.frac, *high, -memory.frac));
    }
  }

  void write(const fs::path& folder, const std::string& bound) const {
    for (const netlist::memory_net& memory : netlist_.memories) write_memory(folder, memory);
    int number = 0;
    for (const std::string& claim : exact_.claims) {
      std::vector<std::string> given = exact_.facts;
      given.insert(given.end(), netlist_.facts.begin(), netlist_.facts.end());
      write_script(folder / fmt::format("claim_{}.g", ++number), netlist_.paths.front(), given, claim, false);
    }
    number = 0;
    for (const netlist::gappa_path& path : netlist_.paths) {
      for (const auto& [condition, value] : exact_.cases) {
        std::vector<std::string> given = exact_.facts;
        for (const auto* more : {&netlist_.facts, &exact_.claims, &path.conditions})
          given.insert(given.end(), more->begin(), more->end());
        given.push_back(condition);
        const std::string error = value == "0" ? kResult : fmt::format("{} - {}", kResult, value);
        // A constant needs no splits.
        static const std::regex constant(std::string(kResult) + R"( = -?\d+b-?\d+;)");
        const bool is_plain = std::regex_match(path.definitions.back(), constant);
        write_script(folder / fmt::format("case_{}.g", ++number), path, given,
                     bound.empty() ? error + " in ?" : fmt::format("{} in [-{},{}]", error, bound, bound),
                     !is_plain);
      }
    }
  }

 private:
  void write_script(const fs::path& file, const netlist::gappa_path& path,
                    const std::vector<std::string>& given, const std::string& wanted, bool has_splits) const {
    std::string text = fmt::format("# {}\n", title_);
    std::set<std::string> known = kWords;
    for (const std::string& line : path.definitions) text += line + "\n";
    for (const auto& [name, expression] : exact_.lets) text += fmt::format("{} = {};\n", name, expression);
    for (const auto* lines : {&path.definitions, &netlist_.facts, &exact_.facts}) {
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

  /// Each word beside what it stands for.
  void write_memory(const fs::path& folder, const netlist::memory_net& memory) const {
    const auto claim = std::ranges::find(exact_.memories, memory.net, &memory_claim::net);
    const auto let = std::ranges::find(exact_.lets, claim->name, &std::pair<std::string, std::string>::first);
    std::vector<std::string> given, wanted;
    for (std::size_t n = 1; n < memory.words.size(); ++n) {
      std::string exact;
      if (let != exact_.lets.end()) {
        exact = fmt::format("({})", std::regex_replace(let->second, std::regex("\\b" + memory.index + "\\b"),
                                                       fmt::format("{}", n)));
      } else {
        exact = fmt::format("exact_{}", n);
        const auto value = golden::exact_coefficient<golden::referee>(golden::referee(n));
        constexpr int kDigits = 40;
        const golden::referee apart = pow(golden::referee(10), -kDigits + 6);
        const auto digits = [](const golden::referee& of) { return of.str(kDigits, std::ios_base::fixed); };
        given.push_back(fmt::format("{} in [{},{}]", exact, digits(value - apart), digits(value + apart)));
      }
      wanted.push_back(fmt::format("{}b{} - {} in {}", memory.words[n], -memory.frac, exact,
                                   around_zero(claim->within, memory.frac)));
    }
    std::string text = fmt::format("# {}: the words of {}\n", title_, memory.net);
    // A script takes some hundred goals in little time.
    constexpr std::size_t kAtOnce = 100;
    for (std::size_t first = 0; first < wanted.size(); first += kAtOnce) {
      const std::size_t last = std::min(first + kAtOnce, wanted.size());
      const auto part = [&](const std::vector<std::string>& of) {
        return conjunction({of.begin() + static_cast<std::ptrdiff_t>(first),
                            of.begin() + static_cast<std::ptrdiff_t>(last)});
      };
      cost::write_text((folder / fmt::format("memory_{}_{}.g", memory.net, first + 1)).string(),
                       given.empty() ? fmt::format("{}{{ {} }}\n", text, part(wanted))
                                     : fmt::format("{}{{ {} ->\n  {} }}\n", text, part(given), part(wanted)));
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
  CLI::App *scripts = nullptr, *row = nullptr, *pages = nullptr, *comparison = nullptr;
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
        if (comparison->parsed()) return compare(chosen, fault_of(fault));
        if (scripts->parsed()) {
          const auto device = chosen.of().elaborate(chosen, 0);
          const script_writer writer(read_specification(specification_file),
                                     netlist::read_gappa(*device, kResult, fault_of(fault)), chosen.text());
          writer.write(folder, bound);
        } else {
          const cost::certificate made{.device = chosen.of().name(),
                                       .format = chosen.format(),
                                       .digest = cost::digest_of(chosen),
                                       .gappa = version,
                                       .bound = std::stod(bound),
                                       .seen = measure(chosen)};
          cost::write_text(file, cost::stored_text(cost::json_of(made)));
        }
        return 0;
      });
}
