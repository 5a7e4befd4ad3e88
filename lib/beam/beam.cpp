#include "lib/beam/beam.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

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

Beam::Beam(const Row<Span>& spans, const OfSupports<Support>& supports)
    : spans_(spans), supports_(supports), factors_(2 * (spans_.size() + 1)) {
  for (std::size_t s = 0; s < spans_.size(); ++s) {
    const Stiffness k = stiffness_of(spans_[s]);
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j <= i; ++j) factors_.at(2 * s + i, 2 * s + j) += k[i][j];
    }
  }
  for (const Support& support : supports_) {
    if (support.k < rigid) factors_.at(2 * support.node, 2 * support.node) += support.k;
  }
  for (const Support& support : supports_) {
    if (!(support.k < rigid)) factors_.fix(2 * support.node);
  }
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

namespace {

/// The shape that the masses take when each is pushed in proportion to itself and to `shape`.
Row<double> pushed(const Beam& beam, std::span<const double> masses, std::span<const double> shape) {
  Unknowns u(2 * masses.size());
  for (std::size_t n = 0; n < masses.size(); ++n) u[2 * n] = masses[n] * shape[n];
  beam.displace(u);
  Row<double> v;
  for (std::size_t n = 0; n < masses.size(); ++n) v.push_back(u[2 * n]);
  return v;
}

double product(std::span<const double> masses, std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t n = 0; n < masses.size(); ++n) sum += masses[n] * a[n] * b[n];
  return sum;
}

/// Of each mass alone: the sum of what a unit force does where it acts, times the mass.
double sum_of_alone(const Beam& beam, std::span<const double> masses) {
  double sum = 0.0;
  for (std::size_t n = 0; n < masses.size(); ++n) {
    if (masses[n] == 0.0 || beam.is_held(n)) continue;
    Unknowns u(2 * masses.size());
    u[2 * n] = 1.0;
    beam.displace(u);
    sum += masses[n] * u[2 * n];
  }
  return sum;
}

}  // namespace

Frequencies frequencies(const Beam& beam, std::span<const double> masses) {
  Frequencies found;
  Row<double> shape(masses.size(), 1.0), next = pushed(beam, masses, shape);
  const double first = product(masses, next, next);
  if (!(first > 0.0)) return found;
  found.rayleigh = std::sqrt(product(masses, next, shape) / first);
  found.dunkerley = 1.0 / std::sqrt(sum_of_alone(beam, masses));
  // From a shape without any symmetry: that of the shaft would hide a lower mode that does not have it.
  for (std::size_t n = 0; n < next.size(); ++n) shape[n] = std::sin(1.0 + 2.3 * static_cast<double>(n));
  next = pushed(beam, masses, shape);
  constexpr int least_rounds = 30, most_rounds = 400;
  for (int round = 0; round < most_rounds; ++round) {
    const double size = std::sqrt(product(masses, next, next));
    for (double& x : next) x /= size;
    shape = next;
    next = pushed(beam, masses, shape);
    const double before = std::exchange(found.lowest, 1.0 / std::sqrt(product(masses, next, shape)));
    if (round > least_rounds && std::abs(found.lowest - before) <= 1e-12 * found.lowest) return found;
  }
  found.lowest = std::numeric_limits<double>::quiet_NaN();  // it does not settle
  return found;
}

}  // namespace loadpath::beam
