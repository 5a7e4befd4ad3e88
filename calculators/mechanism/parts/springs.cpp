// Forces of springs and dampers.
#include "calculators/mechanism/results/aspect.hpp"
#include "calculators/mechanism/results/rows.hpp"
#include "lib/mechanism/model/spring.hpp"

#include <array>

namespace loadpath::planar {

namespace {

using mechanism::Position;

struct Elastic {
  std::string name;
  mechanism::Spring spring;
  static bool pulls(const Elastic& e) { return e.spring.kind == mechanism::Spring::Kind::linear; }
  static bool turns(const Elastic& e) { return !pulls(e); }
};

constexpr std::array spring_rows{
    row<Elastic>(
        "springs.NAME.F", "force, tension positive", N, {.tabled = Tabled::always, .is_load = true},
        [](const Elastic& e, const Position& p) { return spring_now(e.spring, p).effort; }, &Elastic::pulls,
        "springs that pull"),
    row<Elastic>(
        "springs.NAME.s", "extension beyond the free length", mm, {.tabled = Tabled::always},
        [](const Elastic& e, const Position& p) { return spring_now(e.spring, p).stretch; }, &Elastic::pulls,
        "springs that pull"),
    row<Elastic>(
        "springs.NAME.M", "moment on the second link, counter-clockwise positive", N_m,
        {.tabled = Tabled::always, .is_load = true},
        [](const Elastic& e, const Position& p) { return spring_now(e.spring, p).effort; }, &Elastic::turns,
        "springs that turn")};

void list_springs(std::vector<ResultPattern>& patterns) { list_patterns(spring_rows, patterns); }

void add_springs(const Mechanism::Input&, const mechanism::Model& model, std::vector<Output>& out) {
  for (const mechanism::Spring& spring : model.springs) add_outputs(Elastic{spring.name, spring}, spring_rows, out);
}

}  // namespace

constinit const Aspect aspects::springs{.list = &list_springs, .add_outputs = &add_springs};

}  // namespace loadpath::planar
