#include "calculators/belt/figures.hpp"

namespace loadpath::belt {

draw::Figure drive_figure(Length d_1, Length d_2, Length a, Arrangement arrangement) {
  const draw::Point first{0.0, 0.0}, second{in_si(a), 0.0};
  draw::Scheme drive;
  for (const auto& [at, d] : {std::pair{first, in_si(d_1)}, std::pair{second, in_si(d_2)}}) {
    draw::Scheme::Wheel pulley;
    pulley.at = at;
    pulley.radius = d / 2.0;
    drive.wheels.push_back(pulley);
  }
  drive.belts.push_back({first, second, in_si(d_1) / 2.0, in_si(d_2) / 2.0, arrangement == Arrangement::crossed});
  drive.joints.push_back({"1", first, draw::Scheme::Pin::revolute, true});
  drive.joints.push_back({"2", second, draw::Scheme::Pin::revolute, true});
  return {"drive", "The drive to scale: 1 drives, 2 is driven", std::move(drive)};
}

}  // namespace loadpath::belt
