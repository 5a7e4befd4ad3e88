#include "lib/beam/beam.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::beam {

namespace {

using Stiffness = std::array<std::array<double, 4>, 4>;

/// Forces and couples on the two ends of a span per displacement and slope of them: a couple where the ends turn
/// against each other, and a force through the centre where they shift against each other there.
Stiffness stiffness_of(const Span& span) {
  const double turned = 1.0 / span.bending, shifted = 1.0 / span.shifting;
  const double left = span.centre, right = span.l - left, a = shifted * left, b = shifted * right;
  return {{{shifted, a, -shifted, b},
           {a, turned + a * left, -a, a * right - turned},
           {-shifted, -a, shifted, -b},
           {b, a * right - turned, -b, turned + b * right}}};
}

/// Values below this share of the maximum of their kind are rounding errors: those of one kind, by their largest.
constexpr double rounding = 1e-12;
void clean(double& one, double largest) { one = std::abs(one) < rounding * largest ? 0.0 : one; }
void enlarge(double& largest, double one) { largest = std::max(largest, std::abs(one)); }

void clean(LoadedBeam& bent) {
  Node most;
  for (const Node& node : bent.nodes) enlarge(most.v, node.v), enlarge(most.slope, node.slope);
  for (Node& node : bent.nodes) clean(node.v, most.v), clean(node.slope, most.slope);
  double reaction = 0.0;
  for (const double one : bent.reactions) enlarge(reaction, one);
  for (double& one : bent.reactions) clean(one, reaction);
  End force;
  for (const auto& [left, right] : bent.spans) {
    enlarge(force.V, left.V), enlarge(force.V, right.V);
    enlarge(force.M, left.M), enlarge(force.M, right.M);
  }
  for (auto& [left, right] : bent.spans) {
    clean(left.V, force.V), clean(right.V, force.V);
    clean(left.M, force.M), clean(right.M, force.M);
  }
}

}  // namespace

Beam::Matrix Beam::assembled(std::span<const double> masses, double square) const {
  Matrix matrix(2 * nodes());
  for (std::size_t s = 0; s < spans_.size(); ++s) {
    const Stiffness k = stiffness_of(spans_[s]);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j <= i; ++j) matrix.at(2 * s + i, 2 * s + j) += k[i][j];
    }
  }
  for (std::size_t n = 0; n < masses.size(); ++n) matrix.at(2 * n, 2 * n) -= square * masses[n];
  for (const Support& support : supports_) {
    if (support.k < rigid) matrix.at(2 * support.node, 2 * support.node) += support.k;
  }
  for (const Support& support : supports_) {
    if (!(support.k < rigid)) matrix.fix(2 * support.node);
  }
  return matrix;
}

Beam::Beam(const Row<Span>& spans, const OfSupports<Support>& supports)
    : spans_(spans), supports_(supports), factors_(assembled()) {
  holds_ = factors_.factor();
}

std::optional<Beam> Beam::of(const Row<Span>& spans, const OfSupports<Support>& supports) {
  Beam beam(spans, supports);
  if (!beam.holds_) return std::nullopt;
  return beam;
}

Ends Beam::ends_of(std::size_t span, std::span<const double> u, const OfEnds& along) const {
  const Span& own = spans_[span];
  const double* const left = &u[2 * span];
  const double* const right = left + 2;
  const double V = (left[0] - right[0] + own.centre * left[1] + (own.l - own.centre) * right[1]) / own.shifting;
  const double M = (right[1] - left[1]) / own.bending;  // at the centre
  return {{V - along[0], M - V * own.centre + along[1]}, {V + along[2], M + V * (own.l - own.centre) - along[3]}};
}

bool Beam::is_held(std::size_t node) const {
  return std::any_of(supports_.begin(), supports_.end(),
                     [&](const Support& support) { return support.node == node && !(support.k < rigid); });
}

void Beam::hold(std::span<double> unknowns) const {
  for (const Support& support : supports_) {
    if (!(support.k < rigid)) unknowns[2 * support.node] = 0.0;
  }
}

void Beam::displace(std::span<double> unknowns) const {
  hold(unknowns);
  factors_.solve(unknowns);
}

Beam::Unknowns Beam::pushed_by(const Loading& loading) const {
  Unknowns u(2 * nodes());
  for (const Load& load : loading.loads) {
    u[2 * load.node] += load.F;
    u[2 * load.node + 1] += load.M;
  }
  for (std::size_t s = 0; s < loading.along.size(); ++s) {
    for (std::size_t i = 0; i < 4; ++i) u[2 * s + i] += loading.along[s][i];
  }
  hold(u);
  return u;
}

void Beam::fill(const Loading& loading, const Unknowns& u, LoadedBeam& bent) const {
  bent.nodes.resize(nodes());
  for (std::size_t n = 0; n < nodes(); ++n) bent.nodes[n] = {u[2 * n], u[2 * n + 1]};
  bent.spans.resize(spans_.size());
  constexpr OfEnds none{};
  for (std::size_t s = 0; s < spans_.size(); ++s)
    bent.spans[s] = ends_of(s, u, s < loading.along.size() ? loading.along[s] : none);
  bent.reactions.clear();
  for (const Support& support : supports_) {
    const double right = support.node < spans_.size() ? bent.spans[support.node].left.V : 0.0;
    const double left = support.node > 0 ? bent.spans[support.node - 1].right.V : 0.0;
    double force = 0.0;  // at the node
    for (const Load& load : loading.loads) force += load.node == support.node ? load.F : 0.0;
    bent.reactions.push_back(right - left - force);
  }
  clean(bent);
}

LoadedBeam Beam::bend(std::span<const Load> loads, std::span<const OfEnds> along) const {
  const Loading loading{loads, along};
  Unknowns u = pushed_by(loading);
  factors_.solve(u);
  LoadedBeam bent;
  fill(loading, u, bent);
  return bent;
}

void Beam::bend(const Loading& in_x, const Loading& in_y, LoadedBeam& x, LoadedBeam& y) const {
  Unknowns u = pushed_by(in_x), v = pushed_by(in_y);
  factors_.solve_all(std::array<std::span<double>, 2>{u, v});
  fill(in_x, u, x);
  fill(in_y, v, y);
}

Row<double> Beam::flexibilities() const {
  Unknowns all(2 * nodes());
  factors_.inverse_diagonal(all);
  Row<double> each;
  for (std::size_t n = 0; n < nodes(); ++n) each.push_back(is_held(n) ? 0.0 : all[2 * n]);
  return each;
}

bool Beam::has_no_frequency_below(std::span<const double> masses, double square) const {
  return assembled(masses, square).factor(0.0);
}

}  // namespace loadpath::beam
