// Lists inside inputs and results: bounded, inline, without allocation. Members that are never swept may be a
// std::vector.
#pragma once

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <string_view>

namespace loadpath {

/// At most N elements, stored in place. The readers refuse more with a message; the calculator never does.
template <class Element, std::size_t N>
using List = boost::container::static_vector<Element, N>;

/// The capacity of a list without a bound: a std::vector.
inline constexpr std::size_t no_bound = std::numeric_limits<std::size_t>::max();
template <class Items>
inline constexpr std::size_t capacity_of = no_bound;
template <class Element, std::size_t N>
inline constexpr std::size_t capacity_of<List<Element, N>> = N;

/// A short text, stored in place.
template <std::size_t most>
class ShortText {
 public:
  static constexpr std::size_t capacity = most;
  static_assert(capacity <= 255, "its size is one byte");

  constexpr ShortText() = default;
  /// At most `capacity` bytes; longer texts are cut (readers refuse them before).
  constexpr ShortText(std::string_view text)  // NOLINT(google-explicit-constructor)
      : size_(static_cast<unsigned char>(std::min(text.size(), capacity))) {
    std::copy_n(text.begin(), size_, bytes_.begin());
  }
  constexpr ShortText(const char* text) : ShortText(std::string_view(text)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] constexpr std::string_view view() const { return {bytes_.data(), size_}; }
  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }
  constexpr bool operator==(const ShortText& other) const { return view() == other.view(); }

 private:
  std::array<char, capacity> bytes_{};
  unsigned char size_ = 0;
};

/// The name of an element, a link, a joint.
using Name = ShortText<31>;
/// A quantity as a function of one variable: "30 deg + 9 deg*sin(t/(1 s))".
using Formula = ShortText<160>;

}  // namespace loadpath
