// Lists inside inputs and results: bounded, inline, without allocation. Unbounded data are a Series.
#pragma once

#include <boost/container/static_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace loadpath {

/// At most N elements, held in place. Adding more is refused by the readers with a message, never by the calculator.
template <class Element, std::size_t N>
using List = boost::container::static_vector<Element, N>;

/// A short name (of an element, a link, a joint), held in place.
class Name {
 public:
  static constexpr std::size_t capacity = 31;

  constexpr Name() = default;
  /// At most `capacity` bytes; what is longer is cut (readers refuse it before).
  constexpr Name(std::string_view text)  // NOLINT(google-explicit-constructor)
      : size_(static_cast<unsigned char>(std::min(text.size(), capacity))) {
    std::copy_n(text.begin(), size_, bytes_.begin());
  }
  constexpr Name(const char* text) : Name(std::string_view(text)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] constexpr std::string_view view() const { return {bytes_.data(), size_}; }
  [[nodiscard]] constexpr bool empty() const { return size_ == 0; }
  constexpr bool operator==(const Name& other) const { return view() == other.view(); }

 private:
  std::array<char, capacity> bytes_{};
  unsigned char size_ = 0;
};

}  // namespace loadpath
