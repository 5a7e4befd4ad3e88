"""Calculators on arrays: against closed forms, against single machines, and with everything that is wrong."""

import math
import threading
import unittest

import loadpath
import numpy as np
from loadpath import State

torsion = loadpath.calculator("shaft.torsion")
given = {"d": "60 mm", "tau_adm": "40 MPa", "G": "80 GPa"}


def same(a, b):
    """To the bit, but for the sign and the payload of NaN."""
    a, b = np.asarray(a), np.asarray(b)
    return a.shape == b.shape and bool(np.all((a.view(np.uint64) == b.view(np.uint64)) | (np.isnan(a) & np.isnan(b))))


class Columns(unittest.TestCase):
    def test_closed_form(self):
        T = np.linspace(100.0, 3000.0, 5001)
        sweep = torsion.sweep(T=T, **given)
        np.testing.assert_allclose(sweep["tau_max"], 16 * T / (math.pi * 0.06**3), rtol=1e-13)
        np.testing.assert_allclose(sweep["theta_max"], 32 * T / (math.pi * 80e9 * 0.06**4), rtol=1e-13)
        np.testing.assert_array_equal(sweep.passes, sweep["tau_max"] <= 40e6)
        self.assertEqual((sweep.unit("tau_max"), sweep.shown_in("tau_max")), ("Pa", "MPa"))
        np.testing.assert_allclose(sweep.to("tau_max"), sweep["tau_max"] / 1e6, rtol=1e-15)

    def test_rows_are_machines(self):
        T = np.array([400.0, 1234.5, 2999.0])
        d = np.array([0.05, 0.06, 0.07])
        sweep = torsion.sweep(T=T, d=d, tau_adm="40 MPa", G=80e9)
        for i in range(3):
            one = torsion.solve(T=float(T[i]), d=float(d[i]), tau_adm="40 MPa", G=80e9)
            for name in ("tau_max", "theta_max", "d_min"):
                self.assertTrue(same(sweep[name][i], one[name].value), name)
            self.assertEqual(State(int(sweep["state"][i])).name.lower(), one.state)

    def test_units(self):
        T = np.array([0.4, 1.2345, 2.999])
        in_kilo = torsion.sweep(T=("kN*m", T), **given)
        as_text = [torsion.solve(T=f"{x!r} kN*m", **given)["tau_max"].value for x in T.tolist()]
        self.assertTrue(same(in_kilo["tau_max"], as_text))
        self.assertTrue(same(torsion.sweep(T=("kN*m", 1.2345), **given)["tau_max"], [as_text[1]]))
        self.assertTrue(same(torsion.sweep(T="1.2345 kN*m", **given)["tau_max"], [as_text[1]]))
        with self.assertRaisesRegex(loadpath.Error, "is a force; a moment is expected") as caught:
            torsion.sweep(T=("kN", T), **given)
        self.assertEqual((caught.exception.file, caught.exception.line), ("T", 1))
        with self.assertRaisesRegex(loadpath.Error, "energy"):
            torsion.sweep(T=("kJ", T), **given)

    def test_every_default_unit_is_si(self):
        for name in loadpath.calculators():
            calculator = loadpath.calculator(name)
            for field in calculator.inputs.values():
                if field.si_unit not in ("", "1"):
                    loadpath.convert(1.0, field.unit, field.si_unit)

    def test_rows_and_words(self):
        materials = np.array(["C45E", "42CrMo4", "C45E"])
        sweep = torsion.sweep(T=np.array([1000.0, 1000.0, 2000.0]), d="60 mm", material=materials, S=2.0)
        for i, row in enumerate(materials):
            one = torsion.solve(T=[1000.0, 1000.0, 2000.0][i], d="60 mm", material=str(row), S=2.0)
            self.assertTrue(same(sweep["u_tau"][i], one["u_tau"].value))

    def test_lists_and_tables(self):
        one = torsion.solve(torques=[{"x": "0 mm", "T": "900 N*m"}, {"x": "300 mm", "T": "-900 N*m"}], d="60 mm",
                            tau_adm="40 MPa")
        self.assertAlmostEqual(one["tau_max"].value / (16 * 900 / (math.pi * 0.06**3)), 1.0, places=12)
        found = torsion.solve(T="1 kN*m", d={"stock": "R20"}, tau_adm="40 MPa")
        self.assertAlmostEqual(found["d"].value, 0.056)  # the least of 50, 56, 63 mm above (16 T/(pi 40 MPa))^(1/3) = 50.3 mm

    def test_everything(self):
        """What a project's sweep says of the same points, over many blocks and on several threads."""
        rng = np.random.default_rng(3)
        T, d = rng.uniform(100, 3000, 40000), rng.uniform(0.04, 0.08, 40000)
        T[rng.integers(0, 40000, 200)] = -5.0
        d[rng.integers(0, 40000, 200)] = 0.0
        T[17], T[18], T[19] = math.nan, math.inf, -math.inf
        one = torsion.sweep(T=T, d=d, tau_adm="40 MPa", jobs=1)
        for jobs in (2, 5):
            more = torsion.sweep(T=T, d=d, tau_adm="40 MPa", jobs=jobs)
            for name in one:
                self.assertTrue(same(one[name], more[name]), name)
            self.assertEqual(one.refused, more.refused)
        self.assertEqual(sum(r.count for r in one.refused), int(one.is_refused.sum()))
        self.assertTrue(np.isnan(one["tau_max"][one.is_refused]).all())


class Marks(unittest.TestCase):
    def test_refused_rows(self):
        T = np.array([1000.0, 1000.0, 1000.0])
        bore = np.array([0.02, 0.07, 0.03])
        sweep = torsion.sweep(T=T, d_bore=bore, **given)
        np.testing.assert_array_equal(sweep.is_refused, [False, True, False])
        self.assertTrue(np.isnan(sweep["tau_max"][1]) and not np.isnan(sweep["tau_max"][[0, 2]]).any())
        self.assertEqual((sweep.refused[0].count, sweep.refused[0].first), (1, 1))
        self.assertIn("the bore must be smaller than the outer diameter of the shaft", sweep.refused[0].message)

    def test_first_row_is_refused(self):
        d = np.full(3000, 0.06)
        d[:300] = -1.0
        sweep = torsion.sweep(T=1000.0, d=d, tau_adm="40 MPa")
        self.assertEqual(int(sweep.is_refused.sum()), 300)
        self.assertTrue((sweep["tau_max"][300:] == sweep["tau_max"][300]).all())

    def test_all_rows_are_refused(self):
        sweep = torsion.sweep(T=np.full(5, math.nan), **given)
        self.assertTrue(sweep.is_refused.all() and np.isnan(sweep["utilisation"]).all())
        self.assertEqual(sweep.refused, [(5, 0, "torsion.T", "T is not a number")])
        self.assertTrue(torsion.sweep(T=1000.0, d=np.zeros(3), tau_adm="40 MPa").is_refused.all())

    def test_not_covered(self):
        """A key of more than 1.3 times the shaft's diameter bears unevenly: the pressure is told, no verdict."""
        key = loadpath.calculator("shaft.key")
        inputs = example_of(key)
        d = loadpath.quantity(inputs["d"])
        columns = ["p_1", "x_l", "modes.length.state"]
        sweep = key.sweep({**inputs, "l": np.array([0.5, 1.0, 1.9, 2.0]) * d}, results=columns)
        self.assertEqual(list(sweep["x_l"] > 1.3), [False, False, True, True])
        self.assertEqual(list(sweep["modes.length.state"] == State.NOT_COVERED), [False, False, True, True])
        self.assertFalse(np.isnan(sweep["p_1"]).any() or sweep.passes[2:].any())


def example_of(calculator):
    """The inputs of a calculator's example."""
    import tomllib
    tables = tomllib.loads(calculator.example)
    step = next(t for t in tables.values() if isinstance(t, dict) and t.get("calculator") == calculator.id)
    return {k: v for k, v in step.items() if k not in ("calculator", "title", "note", "display", "accept")}


class Arrays(unittest.TestCase):
    def setUp(self):
        self.T = np.linspace(100.0, 2000.0, 100)
        self.tau = torsion.sweep(T=self.T, **given)["tau_max"]

    def test_in_place(self):
        """A column is read where it stands, and what comes out owns its memory."""
        from loadpath import _input
        self.assertIs(_input("T", self.T, set())[1], self.T)
        self.assertTrue(self.tau.flags.writeable and self.tau.flags.aligned and self.tau.base is not None)
        before = self.T.copy()
        self.tau[0] = 7.0
        torsion.sweep(T=("kN*m", self.T), **given)
        np.testing.assert_array_equal(self.T, before)

    def test_shapes_and_types(self):
        every_second = np.repeat(self.T, 2)[::2]
        self.assertFalse(every_second.flags.c_contiguous)
        for T in (every_second, self.T.tolist(), np.asfortranarray(self.T), self.T[::-1][::-1], self.T.astype(">f8")):
            self.assertTrue(same(torsion.sweep(T=T, **given)["tau_max"], self.tau))
        whole = np.arange(100, 200)
        for T in (whole, whole.astype(np.uint16), range(100, 200), whole.tolist()):
            self.assertTrue(same(torsion.sweep(T=T, **given)["tau_max"], torsion.sweep(T=whole * 1.0, **given)["tau_max"]))
        self.assertEqual(torsion.sweep(T=np.float64(5.0), **given).points, 1)
        self.assertEqual(torsion.sweep(T=np.array(5.0), **given).points, 1)
        masked = np.ma.masked_array(self.T, mask=self.T > 1000)
        np.testing.assert_array_equal(torsion.sweep(T=masked, **given).is_refused, self.T > 1000)

    def test_empty(self):
        for empty in (np.array([]), [], np.array([], dtype=int)):
            sweep = torsion.sweep(T=empty, **given)
            self.assertEqual((sweep.points, sweep["tau_max"].shape), (0, (0,)))

    def test_wrong_types(self):
        for T in (True, b"5 N*m", {1, 2}, object(), (x for x in (1.0, 2.0)), np.array([True]), np.array([1j]),
                  np.array([object()]), ("kN*m", True), ("kN*m", {"a": 1})):
            with self.assertRaises(TypeError, msg=repr(T)):
                torsion.sweep(T=T, **given)
        with self.assertRaises(ValueError):
            torsion.sweep(T=np.ones((2, 2)), **given)
        with self.assertRaisesRegex(loadpath.Error, "takes no column of words"):
            torsion.sweep(T=["5 N*m", "6 N*m"], **given)
        with self.assertRaisesRegex(loadpath.Error, "takes no numbers"):
            torsion.sweep(T=1.0, behaviour=self.T, **given)

    def test_lengths(self):
        with self.assertRaisesRegex(loadpath.Error, "'T' has 100 values, 'tau_adm' has 7"):
            torsion.sweep(T=self.T, tau_adm=np.full(7, 4e7), d="60 mm")

    def test_whole_numbers(self):
        key = loadpath.calculator("shaft.key")
        inputs = {**example_of(key), "i": np.array([1.0, 1.5, 2.0])}
        sweep = key.sweep(inputs)
        np.testing.assert_array_equal(sweep.is_refused, [False, True, False])
        self.assertIn("is not an integer", sweep.refused[0].message)


class Names(unittest.TestCase):
    def test_nearest(self):
        for call, hint in ((lambda: loadpath.calculator("shaft.torsoin"), "shaft.torsion"),
                           (lambda: torsion.sweep(tau_amd=1.0, T=1.0), "tau_adm"),
                           (lambda: torsion.sweep(T=1.0, results=["tau_mx"], **given), "tau_max"),
                           (lambda: torsion.solve(T=1.0, **given)["tau_mx"], "tau_max"),
                           (lambda: torsion.solve(T=1.0, d="60 mm", material="C45F", S=2.0), "C45E")):
            with self.assertRaisesRegex(loadpath.Error, hint):
                call()

    def test_results(self):
        sweep = torsion.sweep(T=1000.0, results=["tau_max", "passes", "modes.yield"], **given)
        self.assertEqual(list(sweep), ["tau_max", "passes", "modes.yield", "state", "utilisation"])
        self.assertEqual(sweep["passes"][0], 1.0)
        with self.assertRaisesRegex(loadpath.Error, "requested twice"):
            torsion.sweep(T=1000.0, results=["tau_max", "tau_max"], **given)

    def test_many_values_where_one_is_taken(self):
        with self.assertRaisesRegex(loadpath.Error, "sweep takes columns"):
            torsion.solve(T=np.ones(3), **given)
        with self.assertRaisesRegex(loadpath.Error, "many values of its own"):
            torsion.sweep(T={"from": "1 N*m", "to": "2 N*m", "count": 3}, **given)


class Threads(unittest.TestCase):
    def test_at_once(self):
        T = np.linspace(100.0, 2000.0, 20000)
        wanted = torsion.sweep(T=T, **given)["tau_max"]
        wrong = []

        def work():
            for _ in range(2):
                if not same(torsion.sweep(T=T, jobs=2, **given)["tau_max"], wanted):
                    wrong.append(1)

        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])


if __name__ == "__main__":
    unittest.main()
