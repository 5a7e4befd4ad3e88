// The internal forces of a link as a straight bar: axial force, shear and bending moment over its length, in its axes.
#pragma once

#include "lib/mechanism/equations/kinetostatics.hpp"
#include "lib/mechanism/model/model.hpp"
#include "lib/mechanism/model/position.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace loadpath::mechanism {

/// The distribution of a link's mass along its axis.
enum class MassLine {
  uniform,  // evenly from start to end
  lumped    // all of it, with its moment of inertia, at the mass centre
};

/// The axis of a link, in its frame. Loads off the axis act on it through a rigid arm.
struct Member {
  std::size_t link = 0;
  Vec start, end;
  MassLine mass = MassLine::lumped;
  [[nodiscard]] double length() const { return mechanism::length(end - start); }
};

/// Whether mass centre and moment of inertia are those of a uniform bar: J = m l^2 / 12 within 1 %.
bool is_uniform(const Model& model, const Member& member);

/// The axis between the two points of the link's joints that are farthest apart; of no length where they coincide.
Member member_of(const Model& model, std::size_t link);

/// At a cut at the distance x from the start.
struct SectionForces {
  double x = 0.0;  // m
  double N = 0.0;  // tension positive, N
  double V = 0.0;  // N; on the part before the cut upwards, the axis pointing to the right
  double M = 0.0;  // N m; positive where it stretches the lower side
};

/// Fills itself again for every position; the lists keep their memory.
class MemberLoads {
 public:
  explicit MemberLoads(const Model& model, const Member& member);

  /// Takes the loads on the link at a solved position. `statics`: without inertia.
  void take(const Position& at, bool statics);
  /// Just before and just after each point of action, in rising order; nothing may be left after the last.
  [[nodiscard]] std::span<const SectionForces> stations() const { return stations_; }
  /// Anywhere between, 0 <= x <= length.
  [[nodiscard]] SectionForces at(double x) const;
  /// The section forces of the largest magnitude over the length, between the stations too.
  struct Peaks {
    SectionForces N, V, M;
  };
  [[nodiscard]] Peaks peaks() const;

 private:
  struct Action {
    double x;
    Vec force;      // in the axes of the member
    double couple;  // with the moment of the force about the axis
  };
  void add(Vec place, Vec force, double couple);
  void add_joints(const Position& at);
  void add_drives(const Position& at);
  void add_loads(const Position& at);
  void add_mass(const Position& at, bool statics);
  void spread_mass(const Acceleration& moving, Vec arm);
  void sum_up();
  [[nodiscard]] SectionForces further(const SectionForces& from, double x) const;

  const Model& model_;
  Member member_;
  std::vector<std::size_t> joints_;  // of the link
  double length_;
  Vec origin_;   // origin of the member at the position, global axes
  Turn turned_;  // rotation of the member
  // Distributed mass, per length: first + slope * x, in the axes of the member.
  Vec first_, slope_;
  std::vector<Action> actions_;
  std::vector<SectionForces> stations_;
};

}  // namespace loadpath::mechanism
