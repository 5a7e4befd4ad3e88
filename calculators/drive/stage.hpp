// Stage data of a train by its kind.
#pragma once

#include "calculators/drive/train_types.hpp"

namespace loadpath::drive {

/// Ratio and efficiency of a planetary set by Willis, its third member held.
struct Set {
  double i, eta;
};
Set planetary_set(const TrainTypes::Stage& s);

struct Usual {
  double low, high;
};
/// The usual efficiencies of a kind. The ranges are a warning, no limit: [B40] gives that of chains, [Efficiencies] the
/// others.
inline Usual usual_of(TrainTypes::StageKind kind) {
  using StageKind = TrainTypes::StageKind;
  switch (kind) {
    case StageKind::gear:
    case StageKind::internal:
      return {0.94, 0.99};
    case StageKind::bevel:
      return {0.95, 0.98};
    case StageKind::belt:
      return {0.94, 0.985};
    case StageKind::chain:
      return {0.94, 0.98};
    case StageKind::worm:
      return {0.5, 0.9};
    case StageKind::planetary:
      return {0.94, 0.99};
    case StageKind::crossed:  // from the helix angles and the friction: gear.crossed
    case StageKind::other:
      break;
  }
  return {unset<double>, unset<double>};
}

}  // namespace loadpath::drive
