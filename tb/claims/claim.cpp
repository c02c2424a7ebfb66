// SPDX-License-Identifier: Apache-2.0
#include "tb/claims/claim.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "tb/claims/judge.h"

namespace blysk::claims {
namespace {

using nlohmann::json;

/// A text, or lines of it in an array.
std::string text_of(const json& value) {
  if (!value.is_array()) return value.get<std::string>();
  std::string result;
  for (const auto& line : value) {
    if (!result.empty()) result += ' ';
    result += line.get<std::string>();
  }
  return result;
}

void expect_keys(const json& object, const std::set<std::string>& known, const std::string& whose) {
  for (const auto& item : object.items()) {
    if (!known.contains(item.key()))
      throw std::runtime_error(whose + ": '" + item.key() +
                               "' is unknown, expected one of the keys in claim.cpp");
  }
}

demand demand_of(const json& object, const std::string& whose) {
  expect_keys(object, {"figure", "reading", "name", "is", "at_most", "at_least", "law", "of", "largest_miss"},
              whose);
  demand result;
  result.figure = object.at("figure");
  result.reading = object.value("reading", "");
  result.name = object.value("name", "");
  result.law = object.value("law", false);
  result.of = object.value("of", 0);
  result.largest_miss = object.value("largest_miss", "");
  int relations = 0;
  for (const auto& [key, how] :
       {std::pair{"is", relation::is}, {"at_most", relation::at_most}, {"at_least", relation::at_least}}) {
    if (!object.contains(key)) continue;
    result.how = how;
    result.value = object.at(key);
    number_of(result.value);
    ++relations;
  }
  if (relations != (result.of == 0 ? 1 : 0))
    throw std::runtime_error(whose + ": " + result.figure + " needs one of is, at_most, at_least, of");
  if ((result.of != 0) == result.largest_miss.empty())
    throw std::runtime_error(whose + ": " + result.figure + " needs both of and largest_miss, or none");
  return result;
}

claim claim_from(const json& object) {
  claim result;
  result.id = object.at("id");
  const std::string whose = "row " + result.id;
  expect_keys(object, {"id", "where", "says", "measured", "stated", "open", "held_by", "regenerated_only"},
              whose);
  result.place = object.at("where");
  result.says = text_of(object.at("says"));
  result.measured = text_of(object.at("measured"));
  result.open = object.value("open", "");
  result.held_by = object.value("held_by", "");
  result.regenerated_only = object.value("regenerated_only", std::vector<std::string>{});
  std::set<std::string> keys;
  for (const auto& p : placeholders(result.measured)) keys.insert(p.key);
  const auto expect_printed = [&](const std::string& key) {
    if (!keys.contains(key)) throw std::runtime_error(whose + ": {" + key + "} is not in its text");
  };
  for (const auto& each : object.value("stated", json::array())) {
    result.stated.push_back(demand_of(each, whose));
    expect_printed(result.stated.back().figure);
    const demand& d = result.stated.back();
    if (d.of != 0) expect_printed(d.largest_miss);
    if (!d.law && result.says.find(d.of == 0 ? d.value : std::to_string(d.of)) == std::string::npos)
      throw std::runtime_error(whose + ": what the seed says does not state the value of " + d.figure);
  }
  for (const auto& key : result.regenerated_only) expect_printed(key);
  if (result.stated.empty() == result.open.empty())
    throw std::runtime_error(whose + ": needs either stated figures or 'open', why there are none");
  if (keys.empty() && !result.held_by.empty())
    throw std::runtime_error(whose + ": has no figure that a test could hold");
  return result;
}

}  // namespace

std::vector<section> load_claims(const std::filesystem::path& file) {
  try {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot be read");
    std::vector<section> result;
    std::set<std::string> ids;
    for (const auto& object : json::parse(in)) {
      result.push_back({object.at("section"), {}});
      for (const auto& row : object.at("rows")) {
        result.back().rows.push_back(claim_from(row));
        if (!ids.insert(result.back().rows.back().id).second)
          throw std::runtime_error("row " + result.back().rows.back().id + " comes twice");
      }
    }
    return result;
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

const std::vector<section>& all_claims() {
  static const auto result = load_claims(BLYSK_CLAIMS_JSON);
  return result;
}

const claim& claim_of(std::string_view id) {
  for (const auto& s : all_claims()) {
    const auto found = std::ranges::find(s.rows, id, &claim::id);
    if (found != s.rows.end()) return *found;
  }
  throw std::out_of_range("no row " + std::string(id));
}

namespace {

/// Calls text(piece) and key(placeholder) along a template.
template <class Text, class Key>
void walk(std::string_view text, const Text& on_text, const Key& on_key) {
  while (!text.empty()) {
    const std::size_t brace = text.find_first_of("{}");
    on_text(text.substr(0, brace));
    if (brace == std::string_view::npos) return;
    text.remove_prefix(brace);
    if (text.size() > 1 && text[1] == text[0]) {
      on_text(text.substr(0, 1));
      text.remove_prefix(2);
      continue;
    }
    const std::size_t end = text.find('}');
    if (text[0] == '}' || end == std::string_view::npos)
      throw std::runtime_error("a brace without its partner: " + std::string(text));
    const std::string_view inside = text.substr(1, end - 1);
    const std::size_t colon = inside.find(':');
    on_key(placeholder{std::string(inside.substr(0, colon)),
                       colon == std::string_view::npos ? "" : std::string(inside.substr(colon + 1))});
    text.remove_prefix(end + 1);
  }
}

}  // namespace

std::vector<placeholder> placeholders(std::string_view text) {
  std::vector<placeholder> result;
  walk(
      text, [](std::string_view) {},
      [&](placeholder p) {
        if (std::ranges::find(result, p.key, &placeholder::key) != result.end())
          throw std::runtime_error("{" + p.key + "} comes twice");
        result.push_back(std::move(p));
      });
  return result;
}

std::string fill(std::string_view text, const std::map<std::string, std::string>& printed) {
  std::string result;
  walk(
      text, [&](std::string_view piece) { result += piece; },
      [&](const placeholder& p) { result += printed.at(p.key); });
  return result;
}

}  // namespace blysk::claims
