// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include "tb/cli/numbers.h"
#include "tb/cli/verbs.h"
#include "tb/cost/measured.h"
#include "tb/cost/sweep.h"
#include "tb/cost/table.h"
#include "tb/formats_of_build.h"
#include "tb/output_file.h"
#include "tb/progress.h"
#include "tb/read_number.h"
#include "tb/usage_error.h"

namespace blysk::cli {
namespace {

using json = nlohmann::ordered_json;

struct options {
  // which rows
  std::string device, format;
  std::map<std::string, std::string> named;   ///< options of devices
  std::map<std::string, std::string> ranges;  ///< of word lengths
  std::string measured;
  // what of them
  std::string metric = "max_abs_err", domain, target = "ice40", tolerance, clock;
  bool json = false, csv = false, markdown = false;
  bool has_tolerance = false;  ///< also where it is given as ''
  std::string html;
  // what to measure now
  bool measures = false;
  std::string output, shard = "1/1", rounding;
  int jobs = 1;
  // merge
  std::vector<std::string> shards;
  std::string merged;
  std::set<std::string> given;  ///< names of options on the command line, such as "--target"
};

bool is_range(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.") == std::string::npos;
}

/// Names of the device's word lengths, also of those that it has with some value of an option alone.
std::set<std::string> word_lengths_of(const device& of) {
  std::set<std::string> names;
  const auto add = [&](const std::map<std::string, std::string>& options) {
    const selection asked = choose(of.name(), std::string(format_names[0]), options);
    for (const auto& [name, width] : of.widths(asked)) names.insert(name);
  };
  add({});
  for (const option& own : of.options()) {
    for (const std::string& value : own.values) {
      try {
        add({{own.name, value}});
      } catch (const std::invalid_argument&) {  // goes with another option's value alone
      }
    }
  }
  return names;
}

bool is_word_length(const std::string& name) {
  return std::ranges::any_of(devices(),
                             [&](const device* of) { return word_lengths_of(*of).contains(name); });
}

bool is_option(const std::string& name) {
  return std::ranges::any_of(devices(), [&](const device* of) {
    const std::vector<option> own = of->options();
    return std::ranges::find(own, name, &option::name) != own.end();
  });
}

/// Takes "--NAME VALUE". A name may be that of an option and of a word length; both can be given then.
void take(options& asked, const std::string& name, const std::string& value) {
  // "--constant 101" is a range by its look, but an option of a device and no word length of any; what is wrong with
  // "--cos 8,9" a range says.
  auto& to = is_word_length(name) && (is_range(value) || !is_option(name)) ? asked.ranges : asked.named;
  if (!to.emplace(name, value).second)
    throw usage_error(fmt::format("--{} is {} and {}, expected one of them", name, to.at(name), value));
}

/// Names of all devices' word lengths and options, each once.
std::map<std::string, std::string> names_of_all() {
  std::map<std::string, std::string> names;
  for (const device* each : devices()) {
    for (const option& own : each->options()) names.try_emplace(own.name, own.help);
    if (!cost::is_judged(choose(each->name(), std::string(format_names[0]))))
      continue;  // none can be measured
    for (const std::string& name : word_lengths_of(*each)) {
      std::string& help = names[name];
      if (help.find("bits, such as") == std::string::npos)
        help +=
            fmt::format("{}bits, such as 12 or 8..12: errors are measured now", help.empty() ? "" : "; or ");
    }
  }
  return names;
}

/// The domains that are asked for: all if none is.
std::vector<cost::domain> domains_of(const options& asked) {
  std::vector<cost::domain> domains;
  if (!asked.domain.empty()) return {cost::find_domain(asked.domain)};
  for (const cost::named_domain& each : cost::kDomains) domains.push_back(each.which);
  return domains;
}

/// The domain of a table that shows one.
cost::domain domain_of(const options& asked) {
  return asked.domain.empty() ? cost::domain::lobe : cost::find_domain(asked.domain);
}

/// \param unit  that may follow the number
double positive_of(const std::string& name, std::string text, std::string_view unit) {
  const std::string given = text;
  if (!unit.empty() && text.ends_with(unit)) text.resize(text.size() - unit.size());
  const std::optional<double> value = read_real(text);
  if (!value || !std::isfinite(*value) || !(*value > 0))
    throw usage_error(fmt::format("--{} is {}, expected a finite number above zero{}", name, given,
                                  unit.empty() ? "" : fmt::format(" such as 50{}", unit)));
  return *value;
}

/// The configurations that --device, --format and the options leave.
std::vector<cost::configuration> measured_rows(const options& asked) {
  std::map<std::string, std::string> wanted = asked.named;
  if (!asked.device.empty()) {
    const selection chosen =
        choose(asked.device, asked.format.empty() ? std::string(format_names[0]) : asked.format, asked.named);
    // A device may write one choice in several ways: --cuts 2,4 as --stages 3, or as its preset. The rows have one.
    const bool is_rewritten = std::ranges::any_of(
        asked.named, [&](const auto& given) { return chosen.value(given.first) != given.second; });
    for (auto& [name, value] : wanted) value = chosen.value(name);
    for (const option& own : chosen.of().options()) {
      const std::string& value = chosen.value(own.name);
      if (value != own.preset || (is_rewritten && own.is_wired)) wanted[own.name] = value;
    }
  } else if (!asked.named.empty()) {
    throw usage_error(
        fmt::format("--{} is of a device, expected --device with it", asked.named.begin()->first));
  } else if (!asked.format.empty()) {
    choose(devices().front()->name(), asked.format);
  }
  std::vector<cost::configuration> rows = cost::read_measured(asked.measured);
  std::erase_if(rows, [&](const cost::configuration& each) {
    if (!asked.device.empty() && each.asked.of().name() != asked.device) return true;
    if (!asked.format.empty() && each.asked.format() != asked.format) return true;
    return std::ranges::any_of(wanted,
                               [&](const auto& of) { return each.asked.value(of.first) != of.second; });
  });
  cost::look_for_stale(rows);
  return rows;
}

void print_table(const options& asked, const std::vector<cost::configuration>& rows) {
  const cost::metric& by = cost::find_metric(asked.metric);
  const cost::domain where = domain_of(asked);
  if (asked.json) {
    fmt::print("{}\n", json_rows(rows, domains_of(asked)).dump(2));
  } else if (asked.csv) {
    // A table without rows has its header.
    const std::string text =
        cost::csv_of(json_rows(rows.empty() ? cost::read_measured(asked.measured) : rows, domains_of(asked)));
    fmt::print("{}", rows.empty() ? text.substr(0, text.find('\n') + 1) : text);
  } else if (asked.markdown) {
    fmt::print("{}", markdown_table(rows, by, where));
  } else if (asked.html.empty() && !rows.empty()) {
    fmt::print(
        "{}\nerror: {}; RAM: blocks of 4096 bits; LUT + DSP: with DSP blocks of an UP5K; MHz: median "
        "[least..most]\n"
        "of the seeds; M/s: million results a second, iCE40 at the slowest seed; NAND2, ns: OSU018; latency: "
        "clock "
        "cycles;\ngolden .. verilator: seconds of one host core for a million results\n",
        plain_table(rows, by, where), by.what);
    const auto stale = std::ranges::count_if(rows, &cost::configuration::is_stale);
    if (stale != 0)
      fmt::print(
          stderr,
          "blysk: {} rows are stale: the exported Verilog has changed since; scripts/synth measures them\n",
          stale);
    const auto absent = std::ranges::count_if(
        rows, [](const cost::configuration& each) { return !is_in_build(each.asked.format()); });
    if (absent != 0) {
      fmt::print(
          stderr,
          "blysk: {} rows are of formats that this build does not have, so whether they are stale is not "
          "known; scripts/build makes one with all\n",
          absent);
    }
  }
  if (rows.empty())
    fmt::print(stderr,
               "blysk: no measured configuration is of this device, format and options; scripts/synth "
               "measures them\n");
  if (!asked.html.empty()) {
    const auto drawn = std::ranges::count_if(rows, [&](const cost::configuration& each) {
      return std::ranges::any_of(domains_of(asked), [&](cost::domain in) { return each.has_errors_in(in); });
    });
    if (drawn == 0)
      throw usage_error(
          "--html: none of these configurations has an error against cos^n, expected one to draw");
    for (const std::string& path : cost::measured_paths(asked.measured))
      expect_different_files({"--measured", "--html"}, {path, asked.html});
    cost::write_text(asked.html, cost::html_page(json_rows(rows, domains_of(asked)), asked.metric));
    if (asked.html != "-")
      fmt::print("{}: {} configuration{}\n", printable(asked.html), drawn, drawn == 1 ? "" : "s");
  }
}

/// What is said of a choice, and the exit status.
int answer(const options& asked, const std::vector<cost::configuration>& rows) {
  const double tolerance = positive_of("tolerance", asked.tolerance, "");
  const double mhz = asked.clock.empty() ? 0 : positive_of("clock", asked.clock, "MHz");
  const cost::metric& by = cost::find_metric(asked.metric);
  const cost::technology& in = cost::find_technology(asked.target);
  const cost::domain where = domain_of(asked);
  const cost::choice found = choose_cheapest(rows, tolerance, by, where, in, mhz);
  const auto row_of = [&](const cost::configuration* of) {
    return of == nullptr ? json(nullptr) : json_rows({*of}, std::array{where}).front();
  };
  if (asked.json) {
    json neighbours = json::array();
    const auto add = [&](const char* side, const cost::configuration* of) {
      if (of == nullptr) return;
      json row = row_of(of);
      row["side"] = side;
      neighbours.push_back(std::move(row));
    };
    add(found.cheapest == nullptr ? "nearest" : "cheaper", found.cheaper);
    add("better", found.better);
    json unpriced = json::array();
    for (const cost::configuration* each : found.unpriced) unpriced.push_back(each->label());
    fmt::print("{}\n", json{{"cheapest", row_of(found.cheapest)},
                            {"neighbours", neighbours},
                            {"within_tolerance_without_cost", unpriced}}
                           .dump(2));
    return found.cheapest == nullptr ? 1 : 0;
  }
  const auto line = [&](const char* name, const cost::configuration* of) {
    if (of == nullptr) return;
    const double reached = in.mhz(*of);
    const double rate = of->results_per_us(reached);
    fmt::print("{:<10} {}: {} {}, {} {} in {}{}{}{}\n           {}\n", name, of->label(), by.key,
               cost::number_text(by.of(of->errors_in(where))), *in.cost(*of), in.unit, in.what,
               reached > 0 ? fmt::format(", {:.4g} MHz", reached) : "",
               rate > 0 ? fmt::format(", {:.4g} results a us", rate) : "", of->is_stale ? ", stale" : "",
               of->command());
  };
  const auto tell_unpriced = [&] {
    if (found.unpriced.empty()) return;
    fmt::print("no cost    {} within the tolerance, such as {}: scripts/synth measures it\n",
               found.unpriced.size() == 1 ? "one more is" : fmt::format("{} more are", found.unpriced.size()),
               found.unpriced.front()->label());
  };
  if (!found.has_candidate) {
    fmt::print(
        "cheapest   none: no configuration of these has an error in {} and a cost in {} that were measured\n",
        std::ranges::find(cost::kDomains, where, &cost::named_domain::which)->name, in.what);
    tell_unpriced();
    return 1;
  }
  if (found.cheapest == nullptr) {
    fmt::print("cheapest   none: no configuration whose cost was measured has {} <= {}{}\n", by.key,
               asked.tolerance, mhz > 0 ? fmt::format(" at {} MHz", mhz) : "");
    line("nearest", found.cheaper);
    tell_unpriced();
    return 1;
  }
  line("cheapest", found.cheapest);
  fmt::print("neighbours\n");
  line("cheaper", found.cheaper);
  line("better", found.better);
  tell_unpriced();
  return 0;
}

cost::sweep sweep_of(const options& asked) {
  const std::string device = asked.device.empty() ? devices().front()->name() : asked.device;
  cost::sweep of{.device = device, .options = {}, .widths = {}, .format = asked.format};
  if (asked.given.contains("--rounding")) of.roundings = cost::parse_roundings(asked.rounding);
  for (const auto& [name, value] : asked.ranges) of.widths[name] = cost::parse_range(name, value);
  const std::vector<option> own = find_device(device).first->options();
  for (const auto& [name, value] : asked.named) {
    const auto found = std::ranges::find(own, name, &option::name);
    // A comma may belong to an option of any text.
    const bool is_list = found != own.end() && !found->values.empty();
    of.options[name] = is_list ? cost::split_list(value) : std::vector{value};
  }
  of.check();
  return of;
}

/// "cos  8  coefficient  8  square 16  rounding truncate  ": what differs between the rows, and the word lengths.
std::string words_of(const cost::sweep& of, const cost::sweep_point& point) {
  std::string words;
  for (const auto& [name, width] : point.bits) words += fmt::format("{} {:>2}  ", name, width);
  for (const auto& [name, values] : of.options) {
    std::size_t longest = 0;
    for (const std::string& value : values) longest = std::max(longest, value.size());
    if (values.size() > 1) words += fmt::format("{} {:<{}}  ", name, point.options.at(name), longest);
  }
  if (of.roundings != std::vector{specular::rounding::nearest})
    words += fmt::format("rounding {:<8}  ", specular::name_of(point.how));
  return words;
}

/// Of a shard that has no row.
std::string csv_header(const cost::sweep& of, const std::vector<cost::domain>& domains) {
  const std::vector<cost::sweep_row> one{{points_of(of).first.front(), {}}};
  const std::string text = cost::csv_of(json_rows(of, one, domains));
  return text.substr(0, text.find('\n') + 1);
}

void print_sweep(const options& asked, const cost::sweep& of, const std::vector<cost::sweep_row>& rows) {
  const json printed = json_rows(of, rows, domains_of(asked));
  if (asked.json) {
    fmt::print("{}\n", printed.dump(2));
  } else if (asked.csv) {
    fmt::print("{}", rows.empty() ? csv_header(of, domains_of(asked)) : cost::csv_of(printed));
  } else {
    const cost::metric& by = cost::find_metric(asked.metric);
    const cost::domain where = domain_of(asked);
    fmt::print("{} in {} of {}\n", by.key,
               std::ranges::find(cost::kDomains, where, &cost::named_domain::which)->name, of.device);
    bool is_model_alone = false;
    for (const auto& [point, errors] : rows) {
      const std::optional<std::string> format = point.format();
      is_model_alone = is_model_alone || !format;
      fmt::print("{}{}{}\n", words_of(of, point),
                 cost::number_text(by.of(errors[static_cast<std::size_t>(where)])),
                 format ? "  " + *format : "");
    }
    if (is_model_alone)
      fmt::print(
          "A row without a format is the model's: no hardware of it is exported, so that it has no cost.\n");
  }
}

void measure(const options& asked) {
  if (asked.output == "-")
    throw usage_error("--output is -, expected a directory: a sweep has a file for each row");
  const cost::sweep of = sweep_of(asked);
  domains_of(asked);
  cost::find_metric(asked.metric);
  const auto [points, refused] = points_of(of);
  if (points.empty())
    throw usage_error("no combination of these word lengths fits the device's laws, expected one that does");
  if (refused > 0)
    fmt::print(stderr, "blysk: {} combinations are left out, whose nets would not fit the laws or 64 bits\n",
               refused);
  constexpr std::size_t kSteps = 1000;
  std::vector<cost::sweep_row> rows;
  {
    progress shown("measuring errors", kSteps);
    rows = run_sweep(of, {asked.output, cost::parse_shard(asked.shard), asked.jobs},
                     [&](double share) { shown.reach(static_cast<std::size_t>(share * kSteps)); });
  }
  print_sweep(asked, of, rows);
}

/// Of rows that are printed with all their errors.
void refuse_metric(const options& asked) {
  if (asked.given.contains("--metric"))
    throw usage_error("--metric chooses one error, and --json and --csv have all, expected one of them");
}

/// \throws usage_error for an option that would change nothing
void refuse_unused(const options& asked, bool is_measured) {
  const auto refuse = [&](std::initializer_list<const char*> names, const char* why) {
    for (const char* name : names) {
      if (asked.given.contains(name)) throw usage_error(fmt::format("{}{}", name, why));
    }
  };
  if (!is_measured)
    refuse({"--output", "--shard", "--jobs"},
           " is of a sweep, expected ranges of word lengths, --rounding or --measure with it");
  if (!asked.has_tolerance)
    refuse({"--clock", "--target"}, " is a condition on what is cheapest, expected --tolerance with it");
  if (asked.has_tolerance)
    refuse({"--csv", "--markdown", "--html"}, " is no form of what is cheapest, expected a text or --json");
  if (!asked.has_tolerance && (asked.json || asked.csv)) refuse_metric(asked);
  if (is_measured)
    refuse({"--markdown", "--html", "--tolerance", "--measured"},
           ": rows that are measured now have no cost, expected --json, --csv or a table");
}

/// An alias of a device becomes the device with its options.
options without_alias(options asked) {
  if (asked.device.empty()) return asked;
  const auto [of, fixed] = find_device(asked.device);
  for (const auto& [name, value] : fixed) {
    if (const auto [own, is_new] = asked.named.emplace(name, value); !is_new && own->second != value)
      throw usage_error(fmt::format("device {} has {} {}, expected no --{} {}", asked.device, name, value,
                                    name, own->second));
  }
  asked.device = of->name();
  return asked;
}

int run(const options& given) {
  const options asked = without_alias(given);
  cost::find_metric(asked.metric);
  domain_of(asked);
  cost::find_technology(asked.target);
  const bool is_measured = asked.measures || !asked.ranges.empty() || asked.given.contains("--rounding");
  refuse_unused(asked, is_measured);
  if (is_measured) {
    measure(asked);
    return 0;
  }
  const std::vector<cost::configuration> rows = measured_rows(asked);
  if (asked.has_tolerance) return answer(asked, rows);
  print_table(asked, rows);
  return 0;
}

using asked_options = std::shared_ptr<options>;

/// "KEY: what; KEY: what" of a list.
template <class List, class Key, class What>
std::string described(const List& list, Key key, What what) {
  std::string text;
  for (const auto& each : list)
    text +=
        fmt::format("{}{}: {}", text.empty() ? "" : "; ", std::invoke(key, each), std::invoke(what, each));
  return text;
}

/// What the devices that have an option make of it.
struct ownership {
  bool has_flag = false;   ///< some device has it without a value
  bool has_value = false;  ///< some device has it, or a word length of that name, with one
};

ownership owners_of(const std::string& name) {
  ownership found{false, is_word_length(name)};
  for (const device* each : devices()) {
    for (const option& own : each->options()) {
      if (own.name == name) (own.is_flag() ? found.has_flag : found.has_value) = true;
    }
  }
  return found;
}

void add_options_of_devices(CLI::App& verb, const asked_options& asked) {
  for (const auto& [name, help] : names_of_all()) {
    const std::string key = name;
    const ownership owners = owners_of(key);
    if (!owners.has_value) {
      verb.add_flag_callback(
          "--" + key, [asked, key] { asked->named[key] = "on"; }, help);
      continue;
    }
    CLI::Option* const added = verb.add_option_function<std::vector<std::string>>(
        "--" + key,
        [asked, key, owners](const std::vector<std::string>& values) {
          for (const std::string& value : values)
            take(*asked, key, value.empty() && owners.has_flag ? "on" : value);
        },
        help);
    added->take_all();
    if (owners.has_flag) added->expected(0, 1);
    added->allow_extra_args(false);
  }
}

/// What is asked of the rows.
void add_questions(CLI::App& verb, const asked_options& asked) {
  using namespace cost;
  verb.add_option("--measured", asked->measured,
                  "folder of measured rows, instead of those that the program was built with");
  verb.add_option("--metric", asked->metric, described(metrics(), &metric::key, &metric::what))
      ->capture_default_str();
  verb.add_option("--domain", asked->domain,
                  described(kDomains, &named_domain::name, &named_domain::what) +
                      " (default: lobe, with --json, --csv and --html all)");
  verb.add_option("--tolerance", asked->tolerance, "print what is cheapest with an error of at most this")
      ->each([asked](const std::string&) { asked->has_tolerance = true; });
  verb.add_option("--target", asked->target,
                  described(technologies(), &technology::name,
                            [](const technology& of) { return fmt::format("{} in {}", of.unit, of.what); }))
      ->capture_default_str();
  verb.add_option("--clock", asked->clock,
                  "least clock of the hardware, such as 50MHz; on the iCE40 that of the slowest seed");
}

CLI::App* add_forms(CLI::App& verb, const asked_options& asked) {
  auto* form = verb.add_option_group("form");
  form->add_flag("--json", asked->json, "print JSON");
  form->add_flag("--csv", asked->csv, "print CSV");
  form->add_flag("--markdown", asked->markdown, "print a table in Markdown");
  form->add_option("--html", asked->html,
                   "write one page with a picture that answers to the mouse; - for standard output");
  form->require_option(0, 1);
  return form;
}

void add_measuring(CLI::App& verb, const asked_options& asked) {
  using specular::named_rounding;
  verb.add_flag("--measure", asked->measures, "measure the errors now");
  verb.add_option("--rounding", asked->rounding,
                  described(specular::kRoundings, &named_rounding::name, &named_rounding::what) +
                      "; several with commas, or all: errors are measured now");
  verb.add_option("--output", asked->output,
                  "folder that keeps the rows of a sweep, which then goes on after a stop");
  verb.add_option("--shard", asked->shard, "which part of a sweep, such as 2/8")->capture_default_str();
  verb.add_option("--jobs", asked->jobs, "threads at work")
      ->transform(whole_number(1, 1024))
      ->capture_default_str();
}

CLI::App* add_merge(CLI::App& verb, const asked_options& asked) {
  auto* merge = verb.add_subcommand(
      "merge",
      "Bring the folders of all shards together; --json, --csv, --metric and --domain of explore go with it");
  merge->fallthrough();  // --json and others stand behind it too
  merge->add_option("FOLDERS", asked->shards, "of the shards")->required();
  merge->add_option("--output", asked->merged, "folder for the whole, empty or new")->required();
  return merge;
}

void run_merge(const options& asked) {
  for (const std::string& name : asked.given) {
    if (name != "--json" && name != "--csv" && name != "--metric" && name != "--domain" && name != "FOLDERS")
      throw usage_error(
          fmt::format("{} says nothing to merge, expected --json, --csv, --metric or --domain", name));
  }
  cost::find_metric(asked.metric);
  domain_of(asked);
  if (asked.json || asked.csv) refuse_metric(asked);
  if (asked.merged == "-")
    throw usage_error("--output is -, expected a directory: a sweep has a file for each row");
  const auto [of, rows] = cost::merge_shards(asked.shards, asked.merged);
  print_sweep(asked, of, rows);
}

}  // namespace

void add_explore(CLI::App& program, int& status) {
  auto* verb =
      program.add_subcommand("explore", "Show what accuracy costs: measured rows, or errors measured now");
  auto asked = std::make_shared<options>();
  verb->add_option("--device", asked->device, "rows of this device only");
  verb->add_option("--format", asked->format, "rows of this format only");
  add_options_of_devices(*verb, asked);
  add_questions(*verb, asked);
  const CLI::App* form = add_forms(*verb, asked);
  add_measuring(*verb, asked);
  const CLI::App* merge = add_merge(*verb, asked);
  verb->footer(
      "Examples:\n"
      "  blysk explore\n"
      "  blysk explore --tolerance 0.1 --metric max_abs_err --domain epicentre --target asic --clock 50MHz\n"
      "  blysk explore --html front.html\n"
      "  blysk explore --cos 8..9 --coefficient 7..8 --output sweep --jobs 2\n"
      "  blysk explore --cos 8 --rounding nearest,truncate --metric bias\n"
      "  blysk explore --cos 8..9 --shard 1/2 --output part1\n"
      "  blysk explore --cos 8..9 --shard 2/2 --output part2\n"
      "  blysk explore merge part1 part2 --output whole\n"
      "Exit status 1: nothing that was measured is within --tolerance.");
  verb->callback([asked, verb, form, merge, &status] {
    for (const CLI::App* group : {static_cast<const CLI::App*>(verb), form}) {
      for (const CLI::Option* each : group->get_options()) {
        if (each->count() > 0) asked->given.insert(each->get_name());
      }
    }
    if (merge->parsed()) {
      run_merge(*asked);
    } else {
      status = run(*asked);
    }
  });
}

}  // namespace blysk::cli
