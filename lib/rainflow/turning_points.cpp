#include "lib/rainflow/turning_points.hpp"

#include "lib/rainflow/bits.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>

namespace loadpath::rainflow {

namespace {

constexpr std::size_t bits = 64, words_at_once = 8;

}  // namespace

std::optional<Fault> refusal(double sample, std::uint64_t at) {
  if (std::abs(sample) <= largest_value) return std::nullopt;
  const std::string place = std::to_string(at);
  if (std::isfinite(sample))
    return Fault{at, 1, say("sample {1} of the series (counted from 0) is beyond 8e307", place), {}};
  return Fault{at, 1, say("sample {1} of the series (counted from 0) is not a finite number", place),
               say("correct the series there, or count its parts separately: a gap is not a cycle")};
}

std::size_t TurningPoints::step(std::span<const double> samples, Out& out) {
  for (std::size_t i = 0; i < samples.size(); ++i, ++samples_) {
    const double x = samples[i];
    if (!(std::abs(x) <= largest_value)) return i;
    if (samples_ == 0) {
      last_ = x;
      out.put(x, 0);
    }
    if (x == last_) continue;
    const Course course = x > last_ ? Course::rising : Course::falling;
    if (course_ != Course::none && course != course_) out.put(last_, since_);
    course_ = course, last_ = x, since_ = samples_;
  }
  return samples.size();
}

/// 64 moves from x[0], the latest sample, to x[64].
void TurningPoints::turn(const double* x, const Moves& moves, Out& out) {
  const auto rising_before = static_cast<std::uint64_t>(course_ == Course::rising);
  // What is level goes on as it came: from the bit behind a rising one a carry runs through all that are level.
  const std::uint64_t risen = (moves.rising << 1U | rising_before) & moves.level;
  const std::uint64_t rising = moves.rising | (moves.level & ~(moves.level + risen));
  const std::uint64_t turns = rising ^ (rising << 1U | rising_before);
  const std::uint64_t first = samples_ - 1;
  // Where the plateau began that ends before move k: behind the last move before it that is not level.
  const auto begin = [&](std::size_t k) {
    const std::uint64_t before = ~moves.level & ((std::uint64_t{1} << k) - 1);
    return before == 0 ? since_ : first + static_cast<std::uint64_t>(std::bit_width(before));
  };
  double* const values = out.values + out.count;
  if (out.at == nullptr) {
    out.count += put_places(turns, [&](std::size_t i, std::size_t k) { values[i] = x[k]; });
  } else {
    std::uint64_t* const at = out.at + out.count;
    out.count += put_places(turns, [&](std::size_t i, std::size_t k) { values[i] = x[k], at[i] = begin(k); });
  }
  course_ = rising >> (bits - 1) != 0 ? Course::rising : Course::falling;
  if (~moves.level != 0) since_ = first + static_cast<std::uint64_t>(std::bit_width(~moves.level));
  last_ = x[bits], samples_ += bits;
}

Outcome<std::size_t> TurningPoints::feed(std::span<const double> samples, double* values, std::uint64_t* at) {
  Out out{values, at};
  std::size_t done = 0;
  const auto slowly = [&](std::size_t count) {
    const std::size_t good = step(samples.subspan(done, count), out);
    done += good;
    return good == count;
  };
  while (done < samples.size() && course_ == Course::none) {
    if (!slowly(1)) return *refusal(samples[done], samples_);
  }
  if (done == 0 && !samples.empty() && !slowly(1)) return *refusal(samples[done], samples_);
  std::array<Moves, words_at_once> moves;
  while (samples.size() - done >= bits) {
    const std::size_t words = std::min((samples.size() - done) / bits, words_at_once);
    const double* const x = samples.data() + done - 1;
    compare_neighbours(x, words, moves.data(), instructions_);
    for (std::size_t w = 0; w < words; ++w) {
      if (moves[w].sound) {
        turn(x + bits * w, moves[w], out);
        done += bits;
      } else if (!slowly(bits)) {
        return *refusal(samples[done], samples_);
      }
    }
  }
  if (!slowly(samples.size() - done)) return *refusal(samples[done], samples_);
  return out.count;
}

std::size_t TurningPoints::finish(double* value, std::uint64_t* at) const {
  if (course_ == Course::none) return 0;
  *value = last_;
  if (at != nullptr) *at = since_;
  return 1;
}

}  // namespace loadpath::rainflow
