// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

/// A VCD file of two-valued wires and real numbers: names with their scopes in the device, "rg1.q_o", "values.brdf_real", and
/// what they carry after each time's changes.
struct waves {
  std::map<std::string, std::string> codes;                // by name
  std::map<std::string, int> widths;                       // by name
  std::vector<std::map<std::string, std::string>> values;  // by code, one map for each time stamp

  explicit waves(const std::string& text) {
    std::istringstream lines(text);
    std::string line;
    std::vector<std::string> scopes{""};
    std::map<std::string, std::string> now;
    bool is_header = true;
    while (std::getline(lines, line)) {
      std::istringstream words(line);
      std::string first, second;
      words >> first >> second;
      if (first == "$scope") {
        std::string name;
        words >> name;
        const bool is_device = name == "SystemC" || name == "TOP" || name.starts_with("blysk_");
        scopes.push_back(is_device ? "" : scopes.back() + name + ".");
      } else if (first == "$upscope") {
        scopes.pop_back();
      } else if (first == "$var") {
        std::string width = second, code, name;
        words >> width >> code >> name;
        codes[scopes.back() + name] = code;
        widths[scopes.back() + name] = std::stoi(width);
      } else if (is_header) {
        is_header = first != "$enddefinitions";
      } else if (first.starts_with('#')) {
        if (!now.empty()) values.push_back(now);
      } else if (first.starts_with('b') || first.starts_with('r')) {
        now[second] = first.substr(1);
      } else if (first.starts_with('0') || first.starts_with('1')) {
        now[first.substr(1)] = first.substr(0, 1);
      }
    }
    values.push_back(now);
  }

  /// The bits of a wire, which may be more than 64, without leading zeros.
  std::string bits(std::size_t i, const std::string& name) const {
    const std::string& all = values[i].at(codes.at(name));
    return all.substr(std::min(all.find('1'), all.size()));
  }

  double real(std::size_t i, const std::string& name) const {
    return std::strtod(values[i].at(codes.at(name)).c_str(), nullptr);  // the least numbers too
  }

  /// \param is_signed  two's complement
  long long value(std::size_t i, const std::string& name, bool is_signed = false) const {
    const std::string& bits = values[i].at(codes.at(name));  // leading zeros are left out
    const long long raw = std::stoll(bits, nullptr, 2);
    const int width = widths.at(name);
    return is_signed && raw >> (width - 1) != 0 ? raw - (1LL << width) : raw;
  }
};
