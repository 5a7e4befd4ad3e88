// Sizes of one part that are searched for together, and how they go together: d = "?" of several pieces of a shaft.
#pragma once

#include "lib/text/issue.hpp"

#include <cstddef>
#include <span>
#include <string_view>

namespace loadpath {

/// One of them: the element that it is of, and which of its sizes it is now.
struct Sought {
  const void* owner = nullptr;
  const char* stock = "";              // that it is taken from, where the user names none; empty: that of the field
  std::size_t note = 0;                // of the calculator's own, from `arrange` on
  std::size_t like = 0;                // the first of those of one size with it, from `arrange` on
  std::span<const double> sizes = {};  // ascending, SI
  std::size_t at = 0;
  [[nodiscard]] double size() const { return sizes[at]; }
};

/// What a calculator says of the sizes in one of its lists; the functions see an input in which all else has its value.
struct Sizing {
  const char* list = "";  // "pieces"; empty: it has no such list
  /// Before the search: stocks, notes, and which are of one size, in one of the ways in which sizes can go together;
  /// false where there are no more. All ways have the same stocks, and the same sizes alike.
  bool (*arrange)(const void* input, std::span<Sought> sought, std::size_t way) = nullptr;
  /// Raises each no further than the others and what is given ask; false where no size is large enough.
  bool (*raise)(const void* input, std::span<Sought> sought) = nullptr;
  /// What the search makes least, with the sizes that the input has now: a volume.
  double (*cost)(const void* input) = nullptr;
  /// The element of the list that an element of a result's list is about, "sections", and with that its checks; nullptr
  /// where there is none. These checks change with the sizes of that element and of its neighbours alone.
  const void* (*place)(const void* input, std::string_view list, const void* element) = nullptr;
  /// What is not sound about the size of one of them, beside the others; empty where nothing is.
  Message (*fault)(const void* input, std::span<const Sought> sought, std::size_t which) = nullptr;
};

}  // namespace loadpath
