// SPDX-License-Identifier: Apache-2.0
/// Stimuli and results as columns: one for each port that carries a number, one row for each write.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <variant>
#include <vector>

#include "tb/port.h"

namespace blysk {

/// How the elements of a column lie in memory.
enum class storage : std::uint8_t { u8, u16, u32, i32, i64, f64 };

/// The narrowest that holds all raw values of a format.
constexpr storage storage_of(int width, bool is_signed) {
  if (is_signed) return width <= 32 ? storage::i32 : storage::i64;
  return width <= 8 ? storage::u8 : width <= 16 ? storage::u16 : width <= 32 ? storage::u32 : storage::i64;
}
inline storage storage_of(const wire_format& format) {
  return storage_of(format.width(), format.is_signed);
}

/// The same as a type.
template <class Q>
using stored = std::conditional_t<
    Q::is_signed, std::conditional_t<(Q::width <= 32), std::int32_t, std::int64_t>,
    std::conditional_t<
        (Q::width <= 8), std::uint8_t,
        std::conditional_t<(Q::width <= 16), std::uint16_t,
                           std::conditional_t<(Q::width <= 32), std::uint32_t, std::int64_t>>>>;

/// Numbers of one port: raw integers, or reals for what a formula gives.
class column {
 public:
  explicit column(storage kind);

  storage kind() const { return static_cast<storage>(elements_.index()); }
  std::size_t size() const {
    return std::visit([](const auto& of) { return of.size(); }, elements_);
  }
  void resize(std::size_t rows) {
    std::visit([rows](auto& of) { of.resize(rows); }, elements_);
  }

  /// The elements as they lie in memory.
  /// \throws std::bad_variant_access if T is not the column's storage
  template <class T>
  T* data() {
    return std::get<std::vector<T>>(elements_).data();
  }
  template <class T>
  const T* data() const {
    return std::get<std::vector<T>>(elements_).data();
  }
  template <class T>
  std::vector<T>& as() {
    return std::get<std::vector<T>>(elements_);
  }
  template <class T>
  const std::vector<T>& as() const {
    return std::get<std::vector<T>>(elements_);
  }

  /// Calls use(vector of the column's element type).
  template <class Use>
  decltype(auto) visit(Use&& use) {
    return std::visit(use, elements_);
  }
  template <class Use>
  decltype(auto) visit(Use&& use) const {
    return std::visit(use, elements_);
  }

  /// One element, whatever the storage. Integers that it cannot hold are cut to its bits.
  std::int64_t get(std::size_t row) const {
    return std::visit([row](const auto& of) { return static_cast<std::int64_t>(of[row]); }, elements_);
  }
  double real(std::size_t row) const {
    return std::visit([row](const auto& of) { return static_cast<double>(of[row]); }, elements_);
  }
  template <class T>
  void set(std::size_t row, T value) {
    std::visit(
        [&](auto& of) {
          of[row] = static_cast<typename std::remove_reference_t<decltype(of)>::value_type>(value);
        },
        elements_);
  }

  friend bool operator==(const column&, const column&) = default;

 private:
  // In the order of `storage`.
  std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<std::uint32_t>,
               std::vector<std::int32_t>, std::vector<std::int64_t>, std::vector<double>>
      elements_;
};

/// Columns of equal length.
class columns {
 public:
  columns() = default;
  explicit columns(const std::vector<storage>& layout);

  /// One column for each port of the role, in the ports' order, of the storage that its format asks for.
  columns(const std::vector<port>& ports, port::role role);

  std::vector<storage> layout() const;
  bool has_layout(const std::vector<storage>& kinds) const;
  std::size_t width() const { return columns_.size(); }

  std::size_t size() const { return columns_.empty() ? 0 : columns_.front().size(); }
  void resize(std::size_t rows) {
    for (column& each : columns_) each.resize(rows);
  }

  column& operator[](std::size_t index) { return columns_[index]; }
  const column& operator[](std::size_t index) const { return columns_[index]; }

  auto begin() { return columns_.begin(); }
  auto end() { return columns_.end(); }
  auto begin() const { return columns_.begin(); }
  auto end() const { return columns_.end(); }

  friend bool operator==(const columns&, const columns&) = default;

 private:
  std::vector<column> columns_;
};

}  // namespace blysk
