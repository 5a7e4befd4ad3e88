#include "lib/rainflow/series/lines.hpp"

#include <string>

namespace loadpath::rainflow {

/// The rest of the block is part of a line: it is moved to the front, and the block filled up after it.
std::optional<std::string_view> Lines::more() {
  if (fault_) return std::nullopt;
  if (!ended_) {
    std::memmove(buffer_.data(), buffer_.data() + at_, end_ - at_);
    end_ -= at_, at_ = 0;
    const std::size_t room = buffer_.size() - end_;
    const auto got = source_->read({buffer_.data() + end_, room});
    if (!got) {
      fault_ = got.fault();
      return std::nullopt;
    }
    end_ += *got, ended_ = *got < room;
    if (std::memchr(buffer_.data(), '\n', end_) != nullptr) return next();
    if (!ended_) {
      fault_ = Fault{number_ + 1, 1, say("line {1} is longer than a mebibyte", std::to_string(number_ + 1)), {}};
      return std::nullopt;
    }
  }
  if (at_ == end_) return std::nullopt;
  return taken(end_, 0);
}

}  // namespace loadpath::rainflow
