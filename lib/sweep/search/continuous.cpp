#include "lib/sweep/search/continuous.hpp"

#include "lib/sweep/search/poll.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlopt.hpp>

namespace loadpath::sweep {

namespace {

/// The problem as NLopt sees it: free variables from 0 to 1, an objective near 1, constraints <= 0.
class Descent {
 public:
  Descent(Trials& at_work, Trial start, double usual) : trials(at_work), best(std::move(start)), scale(usual) {
    const auto& variables = trials.problem().variables;
    for (std::size_t i = 0; i < variables.size(); ++i) {
      if (!variables[i].is_discrete()) free.push_back(i);
    }
    for (const Constraint& constraint : trials.problem().constraints) {
      if (constraint.kind == Constraint::Kind::at_most_one) limited.push_back(&constraint);
    }
  }

  void follow(nlopt::algorithm algorithm, double first_step, double margin);
  /// By gradients to the constraints; a result slightly outside is repeated further inside.
  void follow_gradients();
  void poll() { best = polled(trials, best, free, 0.05); }
  [[nodiscard]] const Trial& result() const { return best; }

 private:
  static double objective(unsigned n, const double* x, double* gradient, void* self);
  static void constraints(unsigned m, double* values, unsigned n, const double* x, double* gradient, void* self);

  void look(const double* x);
  void differentiate(const double* x);
  void take(std::span<const double> outputs, double* values) const;
  [[nodiscard]] Places places(const double* x) const;
  [[nodiscard]] std::size_t rows() const { return limited.size() + 1; }
  /// Runs one call of NLopt; an error of the function stops it and is thrown on by follow().
  template <class Body>
  void guarded(const Body& body);

  Trials& trials;
  Trial best, last;  // last: where NLopt looked last
  double scale, inside = 0.0;
  std::vector<std::size_t> free;
  std::vector<const Constraint*> limited;
  std::vector<double> seen, values, sloped, slopes;  // the last point and its values: objective, then constraints
  nlopt::opt* running = nullptr;
  std::exception_ptr failure;
};

Places Descent::places(const double* x) const {
  Places at = best.at;
  for (std::size_t i = 0; i < free.size(); ++i) at[free[i]] = std::clamp(x[i], 0.0, 1.0);
  return at;
}

/// Large excesses grow as their logarithm, without a kink, for the sake of linear models.
double tamed(double by) { return by <= 1.0 ? by : 1.0 + std::log(by); }

void Descent::take(std::span<const double> outputs, double* into) const {
  constexpr double unknown = 50.0;  // beyond all known values: log(1e20) = 46
  const double f = outputs[trials.problem().objective];
  const double signed_f = trials.problem().maximise ? -f : f;
  into[0] = std::isfinite(f) ? signed_f / scale : 1e3;
  for (std::size_t i = 0; i < limited.size(); ++i) {
    const double u = outputs[limited[i]->output];
    const bool holds = !std::isfinite(u) && excess(trials.problem(), *limited[i], outputs) == 0.0;
    into[i + 1] = holds ? -1.0 : (std::isfinite(u) ? tamed(u / limited[i]->bound - 1.0) : unknown) + inside;
  }
}

void Descent::look(const double* x) {
  const std::span here(x, free.size());
  if (std::equal(here.begin(), here.end(), seen.begin(), seen.end())) return;
  last.at = places(x);
  const auto outputs = trials.outputs({&last.at, 1});
  last.standing = judge(trials.problem(), outputs);
  if (better(last.standing, best.standing)) best = last;
  values.resize(rows());
  take(outputs, values.data());
  seen.assign(here.begin(), here.end());
}

void Descent::differentiate(const double* x) {
  constexpr double h = 1e-6;  // share of the range: the truncation error, h^2, is near the rounding error
  const std::span here(x, free.size());
  if (std::equal(here.begin(), here.end(), sloped.begin(), sloped.end())) return;
  std::vector<Places> around;
  for (const std::size_t i : free) {
    around.insert(around.end(), 2, places(x));
    auto& low = around.end()[-2][i];
    auto& high = around.end()[-1][i];
    low = std::max(low - h, 0.0), high = std::min(high + h, 1.0);
  }
  const auto outputs = trials.outputs(around);
  const std::size_t width = outputs.size() / std::max<std::size_t>(around.size(), 1);
  std::vector<double> below(rows()), above(rows());
  slopes.resize(rows() * free.size());
  for (std::size_t i = 0; i < free.size(); ++i) {
    take(std::span(outputs).subspan(2 * i * width, width), below.data());
    take(std::span(outputs).subspan((2 * i + 1) * width, width), above.data());
    const double apart = around[2 * i + 1][free[i]] - around[2 * i][free[i]];
    for (std::size_t k = 0; k < rows(); ++k) slopes[k * free.size() + i] = (above[k] - below[k]) / apart;
  }
  sloped.assign(here.begin(), here.end());
}

template <class Body>
void Descent::guarded(const Body& body) {
  try {
    body();
  } catch (...) {
    failure = std::current_exception();
    running->force_stop();
  }
}

double Descent::objective(unsigned n, const double* x, double* gradient, void* self) {
  auto& descent = *static_cast<Descent*>(self);
  descent.guarded([&] {
    descent.look(x);
    if (gradient == nullptr) return;
    descent.differentiate(x);
    std::copy_n(descent.slopes.begin(), n, gradient);
  });
  return descent.failure ? 0.0 : descent.values[0];
}

void Descent::constraints(unsigned m, double* into, unsigned n, const double* x, double* gradient, void* self) {
  auto& descent = *static_cast<Descent*>(self);
  std::fill_n(into, m, 0.0);
  descent.guarded([&] {
    descent.look(x);
    std::copy_n(descent.values.begin() + 1, m, into);
    if (gradient == nullptr) return;
    descent.differentiate(x);
    std::copy_n(descent.slopes.begin() + n, std::size_t{m} * n, gradient);
  });
}

void Descent::follow(nlopt::algorithm algorithm, double first_step, double margin) {
  const auto n = static_cast<unsigned>(free.size());
  inside = margin;
  seen.clear(), sloped.clear();
  nlopt::opt optimiser(algorithm, n);
  running = &optimiser;
  optimiser.set_lower_bounds(0.0);
  optimiser.set_upper_bounds(1.0);
  optimiser.set_min_objective(objective, this);
  if (!limited.empty()) optimiser.add_inequality_mconstraint(constraints, this, std::vector(limited.size(), 0.0));
  optimiser.set_initial_step(first_step);
  optimiser.set_xtol_abs(1e-9);
  optimiser.set_ftol_rel(1e-13);
  optimiser.set_maxeval(static_cast<int>(std::min<std::uint64_t>(200 + 50 * n, trials.left() + 1)));
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = best.at[free[i]];
  try {
    double value = 0.0;
    optimiser.optimize(x, value);
  } catch (const std::exception&) {
    // Rounding, or a direction without progress: the best point so far is kept. Exceptions of the function are passed
    // on.
  }
  running = nullptr;
  if (failure) std::rethrow_exception(failure);
}

void Descent::follow_gradients() {
  constexpr double margin = 1e-10;
  follow(nlopt::LD_SLSQP, 0.1, margin);
  const double outside = last.standing.violation;
  if (last.standing.missing == 0 && outside > 0.0 && outside < 1e-5)
    follow(nlopt::LD_SLSQP, 0.1, margin + 2.0 * outside);
}

}  // namespace

Trial descended(Trials& trials, const Trial& start, double scale, Care care) {
  constexpr double wide = 0.1, narrow = 0.01;
  Descent descent(trials, start, scale);
  descent.follow_gradients();
  const bool allowed = descent.result().standing.allowed();
  if (care == Care::quick && allowed) return descent.result();
  descent.follow(nlopt::LN_COBYLA, allowed ? narrow : wide, 0.0);
  descent.follow_gradients();
  if (care == Care::thorough) descent.poll();
  return descent.result();
}

}  // namespace loadpath::sweep
