// Moving and solving take no memory: sweeps of dimensions run through them millions of times.
#include "tests/lib/mechanism/models.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> allocations{0};

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
// The standard library takes memory this way too, and gives it back by the plain delete.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

TEST_SUITE("mechanism") {
  TEST_CASE("a turn of the crank allocates nothing, nor does a move that fails") {
    using namespace loadpath::mechanism;
    Model rocker_driven = models::four_bar();
    rocker_driven.drivers[0].i = 2;
    for (const Model& model : {models::slider_crank(), models::six_bar(), models::slotted_lever(), rocker_driven}) {
      WholeSystem system(model);
      Position at = system.blank();
      const std::size_t before = allocations;
      int failed = system.assemble() == Status::closed ? 0 : 1;
      const double start = system.coordinate(0);
      for (int k = 0; k < 72; ++k) {
        const Drive drive{start + 0.1 * k, 10.0, 0.0};
        failed += system.solve({&drive, 1}, at) == Status::closed ? 0 : 1;
      }
      const std::size_t after = allocations;
      CHECK(after == before);
      CHECK((failed > 0) == (model.drivers[0].i == 2));
    }
  }
}
