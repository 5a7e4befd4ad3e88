#include "calculators/mechanism/pictures/scheme.hpp"

#include "lib/mechanism/constraints/system.hpp"
#include "tests/lib/mechanism/wheel_models.hpp"

#include <doctest/doctest.h>

using namespace loadpath;
using namespace loadpath::planar;
namespace models = loadpath::mechanism::models;

TEST_SUITE("mechanism schemes") {
  TEST_CASE("a gear that meshes twice is drawn once") {
    const mechanism::Model model = models::planetary();  // its planet lies off the axes
    mechanism::WholeSystem system(model);
    REQUIRE(system.assemble() == mechanism::Status::closed);
    mechanism::Position at = system.blank();
    const mechanism::Drive drive{system.coordinate(0), 10.0, 0.0};
    REQUIRE(system.solve({&drive, 1}, at, false) == mechanism::Status::closed);
    Extents extents;
    extents.strokes.resize(model.joints.size());
    extents.loads_push.resize(model.loads.size());
    extents.loads_turn.resize(model.loads.size());
    const figure::Motion drawn = scheme_at(model, at, extents, {}, Shown::at_rest);
    CHECK(drawn.still.wheels.size() == 3);
  }
}
