#include "lib/beam/beam.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace loadpath::beam {

namespace {

using Unknowns = boost::container::static_vector<double, 2 * most_nodes>;
using Stiffness = std::array<std::array<double, 4>, 4>;

/// Forces and couples on the two ends of a span per displacement and slope of them.
Stiffness stiffness_of(const Span& span) {
  const double l = span.l, phi = 12.0 * span.EI / (span.GA * l * l), c = span.EI / ((1.0 + phi) * l * l * l);
  const double a = 12.0 * c, b = 6.0 * l * c, near = (4.0 + phi) * l * l * c, far = (2.0 - phi) * l * l * c;
  return {{{a, b, -a, b}, {b, near, -b, far}, {-a, -b, a, -b}, {b, far, -b, near}}};
}

/// What an even load does to the two ends of a span that are held.
std::array<double, 4> held(const Span& span, double q) {
  return {q * span.l / 2.0, q * span.l * span.l / 12.0, q * span.l / 2.0, -q * span.l * span.l / 12.0};
}

/// What is nothing beside the largest of its kind is rounding.
constexpr double rounding = 1e-12;
template <class Elements, class Of>
void clean(Elements& all, const Of& of) {
  double largest = 0.0;
  for (auto& element : all) largest = std::max(largest, std::abs(of(element)));
  for (auto& element : all) {
    if (std::abs(of(element)) < rounding * largest) of(element) = 0.0;
  }
}

void clean(Bent& bent) {
  clean(bent.nodes, [](Node& n) -> double& { return n.v; });
  clean(bent.nodes, [](Node& n) -> double& { return n.slope; });
  clean(bent.reactions, [](double& reaction) -> double& { return reaction; });
  boost::container::static_vector<End*, 2 * most_nodes> ends;
  for (Ends& span : bent.spans) {
    ends.push_back(&span.left);
    ends.push_back(&span.right);
  }
  clean(ends, [](End* end) -> double& { return end->V; });
  clean(ends, [](End* end) -> double& { return end->M; });
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

Ends Beam::ends_of(std::size_t span, std::span<const double> u, double q) const {
  const Stiffness k = stiffness_of(spans_[span]);
  const std::array<double, 4> even = held(spans_[span], q);
  std::array<double, 4> f{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) f[i] += k[i][j] * u[2 * span + j];
    f[i] -= even[i];
  }
  return {{f[0], -f[1]}, {-f[2], f[3]}};
}

bool Beam::is_held(std::size_t node) const {
  return std::any_of(supports_.begin(), supports_.end(),
                     [&](const Support& support) { return support.node == node && !(support.k < rigid); });
}

void Beam::displace(std::span<double> unknowns) const {
  for (const Support& support : supports_) {
    if (!(support.k < rigid)) unknowns[2 * support.node] = 0.0;
  }
  factors_.solve(unknowns);
}

Bent Beam::bend(std::span<const Load> loads, std::span<const double> q) const {
  Row<double> forces(nodes());
  Unknowns u(2 * nodes());
  for (const Load& load : loads) {
    u[2 * load.node] += load.F;
    u[2 * load.node + 1] += load.M;
    forces[load.node] += load.F;
  }
  for (std::size_t s = 0; s < q.size(); ++s) {
    const std::array<double, 4> even = held(spans_[s], q[s]);
    for (std::size_t i = 0; i < 4; ++i) u[2 * s + i] += even[i];
  }
  displace(u);
  Bent bent;
  for (std::size_t n = 0; n < nodes(); ++n) bent.nodes.push_back({u[2 * n], u[2 * n + 1]});
  for (std::size_t s = 0; s < spans_.size(); ++s) bent.spans.push_back(ends_of(s, u, s < q.size() ? q[s] : 0.0));
  for (const Support& support : supports_) {
    const double right = support.node < spans_.size() ? bent.spans[support.node].left.V : 0.0;
    const double left = support.node > 0 ? bent.spans[support.node - 1].right.V : 0.0;
    bent.reactions.push_back(right - left - forces[support.node]);
  }
  clean(bent);
  return bent;
}

Row<double> Beam::flexibilities() const {
  Unknowns all(2 * nodes());
  factors_.inverse_diagonal(all);
  Row<double> each;
  for (std::size_t n = 0; n < nodes(); ++n) each.push_back(is_held(n) ? 0.0 : all[2 * n]);
  return each;
}

bool Beam::hums_above(std::span<const double> masses, double square) const {
  return assembled(masses, square).factor(0.0);
}

}  // namespace loadpath::beam
