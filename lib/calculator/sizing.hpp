// Sizes of one part that are searched for together, and how they go together: d = "?" of several pieces of a shaft.
#pragma once

#include "lib/text/issue.hpp"

#include <cstddef>
#include <span>
#include <string_view>

namespace loadpath {

/// One of them: the element that it is of, and which of its sizes it is now.
struct OpenSize {
  const void* owner = nullptr;
  const char* stock = "";              // default stock, if the user names none; empty: that of the field
  std::size_t note = 0;                // index among the calculator's own notes, from `arrange` on
  std::size_t like = 0;                // the first of those of one size with it, from `arrange` on
  std::span<const double> sizes = {};  // ascending, SI
  std::size_t at = 0;
  [[nodiscard]] double size() const { return sizes[at]; }
};

/// A calculator's functions for sizing one of its lists; they get an input in which every other value is set.
struct Sizing {
  const char* list = "";  // "pieces"; empty: it has no such list
  /// Before the search: sets stocks, notes, and groups of equal size, in one of the possible arrangements; false if
  /// there are no more. All arrangements have the same stocks, and the same groups.
  bool (*arrange)(const void* input, std::span<OpenSize> sought, std::size_t way) = nullptr;
  /// Raises each no further than the others and the given inputs require; false if no size is large enough.
  bool (*raise)(const void* input, std::span<OpenSize> sought) = nullptr;
  /// The objective that the search minimises, at the current sizes of the input: a volume. Without a list: that of
  /// sizes of the part itself that are searched for together, an area; null: each in turn is the smallest.
  double (*cost)(const void* input) = nullptr;
  /// The element of the list that an element of a result's list refers to, "sections", and with it its checks;
  /// nullptr if there is none. These checks depend only on the sizes of that element and of its neighbours.
  const void* (*place)(const void* input, std::string_view list, const void* element) = nullptr;
  /// The fault of one size given the others; empty if there is none.
  Message (*fault)(const void* input, std::span<const OpenSize> sought, std::size_t which) = nullptr;
};

}  // namespace loadpath
