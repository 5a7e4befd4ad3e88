// The module _loadpath: the C++ interface as Python sees it; python/loadpath/__init__.py makes it pleasant.
//
// Arrays are passed without copying: an input is read in numpy's memory, a result is handed over with its memory.
// During a computation the interpreter is free for other threads.
#include <loadpath/loadpath.hpp>
#include <memory>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;
namespace api = loadpath::api;

namespace {

/// The memory of the vector becomes the array's.
py::array_t<double> as_array(std::vector<double>&& values) {
  auto owned = std::make_unique<std::vector<double>>(std::move(values));
  const auto size = static_cast<py::ssize_t>(owned->size());
  const double* const start = owned->data();
  const py::capsule owner(owned.release(), [](void* p) { delete static_cast<std::vector<double>*>(p); });
  return py::array_t<double>(size, start, owner);
}

using Input = std::tuple<std::string, py::object, std::string>;  // name, value, unit

/// Text, number, TOML text as bytes, array of doubles, list of words.
api::Given given(const Input& input) {
  const auto& [name, value, unit] = input;
  api::Given one{name, {}, unit};
  if (py::isinstance<py::array>(value)) {
    using Array = py::array_t<double, py::array::c_style>;
    if (!py::isinstance<Array>(value)) throw py::type_error(name + ": an array of float64 without gaps is expected");
    const auto array = py::cast<Array>(value);
    if (array.ndim() != 1) throw py::type_error(name + ": an array of one dimension is expected");
    one.value = std::span<const double>(array.data(), static_cast<std::size_t>(array.size()));
  } else if (py::isinstance<py::bytes>(value)) {
    one.value = api::Inline{py::cast<std::string>(value)};
  } else if (py::isinstance<py::str>(value)) {
    one.value = py::cast<std::string>(value);
  } else if (py::isinstance<py::list>(value)) {
    one.value = py::cast<std::vector<std::string>>(value);
  } else {
    one.value = py::cast<double>(value);
  }
  return one;
}

std::vector<api::Given> all_given(const std::vector<Input>& inputs) {
  std::vector<api::Given> all;
  for (const Input& input : inputs) all.push_back(given(input));
  return all;
}

/// Ctrl-C is heard while a sweep runs.
class Watch {
 public:
  explicit Watch(api::SweepOptions& options) {
    options.goes_on = [this](std::uint64_t, std::uint64_t) {
      const py::gil_scoped_acquire gil;
      return !(interrupted_ = PyErr_CheckSignals() != 0);
    };
  }
  [[nodiscard]] bool interrupted() const { return interrupted_; }

 private:
  bool interrupted_ = false;
};

template <class Solve>
api::Sweep watched(api::SweepOptions& options, const Solve& solve) {
  const Watch watch(options);
  try {
    const py::gil_scoped_release free;
    return solve();
  } catch (const api::Error&) {
    if (watch.interrupted()) throw py::error_already_set();
    throw;
  }
}

/// Everything of a sweep; its columns give their memory away.
py::dict parts_of(api::Sweep&& sweep) {
  py::list columns, refused;
  for (api::Column& c : sweep.columns)
    columns.append(py::make_tuple(c.name, as_array(std::move(c.values)), c.si_unit, c.unit, c.words));
  for (const api::Refused& r : sweep.refused) refused.append(py::make_tuple(r.count, r.first, r.key, r.message));
  py::dict parts;
  parts["points"] = sweep.points;
  parts["columns"] = columns;
  parts["refused"] = refused;
  parts["summary"] = sweep.summary;
  return parts;
}

api::SweepOptions options_of(const py::dict& from) {
  api::SweepOptions options;
  const auto take = [&](const char* key, auto& to) {
    if (from.contains(key)) to = py::cast<std::decay_t<decltype(to)>>(from[key]);
  };
  take("results", options.results);
  take("jobs", options.jobs);
  take("strict", options.strict);
  take("samples", options.samples);
  take("seed", options.seed);
  take("latin", options.latin);
  take("zip", options.zip);
  take("rows", options.rows);
  return options;
}

void bind_errors(py::module_& m) {
  py::class_<api::Issue>(m, "Issue")
      .def_readonly("file", &api::Issue::file)
      .def_readonly("line", &api::Issue::line)
      .def_readonly("column", &api::Issue::column)
      .def_readonly("length", &api::Issue::length)
      .def_readonly("key", &api::Issue::key)
      .def_readonly("message", &api::Issue::message)
      .def_readonly("help", &api::Issue::help)
      .def_readonly("is_error", &api::Issue::is_error)
      .def("__repr__", [](const api::Issue& i) {
        return i.file + ":" + std::to_string(i.line) + ":" + std::to_string(i.column) + ": " + i.message;
      });
  static const py::exception<api::Error> error(m, "Error", PyExc_ValueError);
  py::register_exception_translator([](std::exception_ptr p) {
    try {
      if (p) std::rethrow_exception(p);
    } catch (const api::Error& e) {
      const py::object raised = static_cast<const py::object&>(error)(e.what());
      const api::Issue* first = nullptr;
      for (const api::Issue& issue : e.issues()) {
        if (first == nullptr && issue.is_error) first = &issue;
      }
      raised.attr("issues") = e.issues();
      raised.attr("file") = first == nullptr ? std::string() : first->file;
      raised.attr("line") = first == nullptr ? 0 : first->line;
      raised.attr("column") = first == nullptr ? 0 : first->column;
      PyErr_SetObject(error.ptr(), raised.ptr());
    }
  });
}

const char* word_of(api::Role role) {
  switch (role) {
    case api::Role::input:
      return "input";
    case api::Role::check:
      return "check";
    case api::Role::limit:
      return "limit";
    case api::Role::result:
      break;
  }
  return "result";
}

void bind_solutions(py::module_& m) {
  py::class_<api::Quantity>(m, "Quantity")
      .def_readonly("name", &api::Quantity::name)
      .def_readonly("meaning", &api::Quantity::meaning)
      .def_property_readonly("role", [](const api::Quantity& q) { return word_of(q.role); })
      .def_readonly("kind", &api::Quantity::kind)
      .def_readonly("si_unit", &api::Quantity::si_unit)
      .def_readonly("unit", &api::Quantity::unit)
      .def_property_readonly("value",
                             [](const api::Quantity& q) -> py::object {
                               if (!q.word.empty()) return py::str(q.word);
                               if (!q.series.empty()) return as_array(std::vector<double>(q.series));
                               return py::float_(q.value);
                             })
      .def_readonly("axis", &api::Quantity::axis)
      .def_property_readonly("positions",
                             [](const api::Quantity& q) { return as_array(std::vector<double>(q.positions)); })
      .def_readonly("text", &api::Quantity::text)
      .def_readonly("reason", &api::Quantity::reason)
      .def("__float__", [](const api::Quantity& q) { return q.value; })
      .def("__repr__", [](const api::Quantity& q) { return q.name + " = " + q.text; });
  py::class_<api::Mode>(m, "Mode")
      .def_readonly("step", &api::Mode::step)
      .def_readonly("id", &api::Mode::id)
      .def_readonly("meaning", &api::Mode::meaning)
      .def_property_readonly("state", [](const api::Mode& mode) { return api::word_of(mode.state); })
      .def_readonly("utilisation", &api::Mode::utilisation)
      .def_readonly("governs", &api::Mode::governs)
      .def_readonly("group", &api::Mode::group)
      .def_readonly("reason", &api::Mode::reason)
      .def("__repr__",
           [](const api::Mode& mode) { return mode.step + "." + mode.id + ": " + api::word_of(mode.state); });
  py::class_<api::Check>(m, "Check")
      .def_readonly("step", &api::Check::step)
      .def_readonly("name", &api::Check::name)
      .def_readonly("meaning", &api::Check::meaning)
      .def_readonly("value", &api::Check::value)
      .def_readonly("bound", &api::Check::bound)
      .def_property_readonly("state", [](const api::Check& check) { return api::word_of(check.state); });
  py::class_<api::Solution>(m, "Solution")
      .def_property_readonly("state", [](const api::Solution& s) { return api::word_of(s.state); })
      .def_readonly("headline", &api::Solution::headline)
      .def_readonly("verdict", &api::Solution::verdict)
      .def_readonly("passes", &api::Solution::passes)
      .def_readonly("modes", &api::Solution::modes)
      .def_readonly("checks", &api::Solution::checks)
      .def_readonly("warnings", &api::Solution::warnings)
      .def("__getitem__", &api::Solution::operator[], py::return_value_policy::reference_internal)
      .def("__contains__", [](const api::Solution& s, const std::string& name) { return s.find(name) != nullptr; })
      .def("__len__", [](const api::Solution& s) { return s.quantities.size(); })
      .def("keys",
           [](const api::Solution& s) {
             std::vector<std::string> names;
             for (const api::Quantity& q : s.quantities) names.push_back(q.name);
             return names;
           })
      .def("__iter__", [](const py::object& s) { return py::iter(s.attr("keys")()); })
      .def("__repr__", [](const api::Solution& s) { return s.verdict; });
}

void bind_projects(py::module_& m) {
  py::class_<api::Project>(m, "Project")
      .def_static("open", &api::Project::open, py::call_guard<py::gil_scoped_release>())
      .def_static("read", &api::Project::read, py::call_guard<py::gil_scoped_release>())
      .def_property_readonly("title", &api::Project::title)
      .def_property_readonly("steps", &api::Project::steps)
      .def_property_readonly("swept", &api::Project::swept)
      .def("solve", &api::Project::solve, py::call_guard<py::gil_scoped_release>())
      .def("solve_point",
           [](const api::Project& project, std::uint64_t point, const py::dict& from) {
             const api::SweepOptions options = options_of(from);
             const py::gil_scoped_release free;
             return project.solve_point(point, options);
           })
      .def("sweep", [](const api::Project& project, const py::dict& from) {
        api::SweepOptions options = options_of(from);
        return parts_of(watched(options, [&] { return project.sweep(options); }));
      });
}

void bind_calculators(py::module_& m) {
  py::class_<api::Field>(m, "Field")
      .def_readonly("name", &api::Field::name)
      .def_readonly("meaning", &api::Field::meaning)
      .def_property_readonly("role", [](const api::Field& f) { return word_of(f.role); })
      .def_readonly("kind", &api::Field::kind)
      .def_readonly("si_unit", &api::Field::si_unit)
      .def_readonly("unit", &api::Field::unit)
      .def_readonly("optional", &api::Field::optional)
      .def_readonly("words", &api::Field::words)
      .def("__repr__", [](const api::Field& f) {
        return f.name + (f.unit.empty() ? ", " + f.kind : " [" + f.unit + "]") + ": " + f.meaning;
      });
  py::class_<api::Calculator>(m, "Calculator")
      .def_static("find", &api::Calculator::find)
      .def_static("all", &api::Calculator::all)
      .def_property_readonly("id", &api::Calculator::id)
      .def_property_readonly("title", &api::Calculator::title)
      .def_property_readonly("scope", &api::Calculator::scope)
      .def_property_readonly("example", &api::Calculator::example)
      .def_property_readonly("inputs", &api::Calculator::inputs)
      .def_property_readonly("results", &api::Calculator::results)
      .def("solve",
           [](const api::Calculator& calculator, const std::vector<Input>& inputs, bool strict) {
             const auto all = all_given(inputs);
             const py::gil_scoped_release free;
             return calculator.solve(all, strict);
           })
      .def("sweep", [](const api::Calculator& calculator, const std::vector<Input>& inputs, const py::dict& from) {
        const auto all = all_given(inputs);
        api::SweepOptions options = options_of(from);
        return parts_of(watched(options, [&] { return calculator.sweep(all, options); }));
      });
}

}  // namespace

PYBIND11_MODULE(_loadpath, m) {
  m.attr("__version__") = api::version();
  bind_errors(m);
  bind_solutions(m);
  bind_projects(m);
  bind_calculators(m);
  m.def("convert", [](py::array_t<double, py::array::c_style>& values, const std::string& from, const std::string& to) {
    api::convert({values.mutable_data(), static_cast<std::size_t>(values.size())}, from, to);
  });
  m.def("in_si", &api::in_si);
}
