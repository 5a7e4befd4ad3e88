"""Projects: solved, swept, with the bytes of the command; errors with their places."""

import json
import os
import pathlib
import subprocess
import tempfile
import threading
import unittest

import loadpath
import numpy as np

program = os.environ.get("LOADPATH_PROGRAM", "loadpath")
root = pathlib.Path(os.environ.get("LOADPATH_ROOT", pathlib.Path(__file__).parents[2]))
strut = root / "examples/strut-sweep/project.toml"
lever = root / "examples/slotted-lever/project.toml"


class Projects(unittest.TestCase):
    def test_as_the_command(self):
        project = loadpath.project(lever)
        solution = project.solve()
        said = json.loads(subprocess.run([program, "run", str(lever), "--json", "--quiet"], capture_output=True).stdout)
        self.assertEqual(solution.state, said["verdict"]["state"])
        self.assertEqual(solution.verdict, said["verdict"]["scope"])
        numbers = 0
        for step in said["steps"]:
            for path, entry in {**step["inputs"], **step["results"]}.items():
                if "value" not in entry or entry["value"] is None or isinstance(entry["value"], str):
                    continue
                ours = solution[step["name"] + "." + path]
                self.assertEqual(ours.si_unit, entry["unit"] or "1")
                if np.ndim(ours.value) > 0:  # a series, of which the command prints one value
                    continue
                self.assertEqual(ours.value, entry["value"], path)
                numbers += 1
        self.assertGreater(numbers, 50)
        series = solution["lever.drive.M"]
        self.assertEqual((series.value.shape, series.kind), (series.positions.shape, "moment"))

    def test_sweep_has_the_bytes_of_the_command(self):
        results = ["strut.lambda", "strut.utilisation"]
        project = loadpath.project(strut)
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "out"
            run = subprocess.run([program, "sweep", str(strut), "--samples", "200", "--seed", "5", "--out", str(out),
                                  "--quiet", "--json", "--results", results[0]], capture_output=True, text=True)
            self.assertEqual(run.returncode, 0, run.stderr)
            for jobs in (1, 3):
                sweep = project.sweep([results[0]], samples=200, seed=5, jobs=jobs)
                manifest = json.loads((out / "manifest.json").read_text())
                self.assertEqual([c["name"] for c in manifest["columns"]], list(sweep))
                for column in manifest["columns"]:
                    theirs = np.load(out / column["file"])
                    self.assertEqual(sweep[column["name"]].tobytes(), theirs.tobytes(), column["name"])
                self.assertEqual(sweep.summary["results"], json.loads(run.stdout)["results"])
        self.assertEqual(dict(project.sweep(samples=20, rows=False)), {})

    def test_point_is_its_row(self):
        project = loadpath.project(strut)
        sweep = project.sweep(["lambda = strut.lambda"], samples=5)
        last = sweep.points - 1
        one = project.point(last, samples=5)
        self.assertEqual(one["strut.lambda"].value, sweep["lambda"][last])
        with self.assertRaisesRegex(loadpath.Error, "does not exist"):
            project.point(sweep.points, samples=5)

    def test_places(self):
        text = '[shaft]\ncalculator = "shaft.torsion"\nT = "5 kN"\ntau_adm = "40 MPa"\n'
        with self.assertRaises(loadpath.Error) as caught:
            loadpath.read_project(text, "wrong.toml")
        error = caught.exception
        self.assertEqual((error.file, error.line, error.column), ("wrong.toml", 3, 6))
        self.assertIn("N*m", error.issues[0].help)
        self.assertIn('3 | T = "5 kN"', str(error))
        with self.assertRaisesRegex(loadpath.Error, "strut.lambda") as caught:
            loadpath.project(strut).sweep(["strut.A", "strut.lamda"])
        self.assertEqual((caught.exception.file, caught.exception.line), ("results[2]", 1))
        with self.assertRaisesRegex(loadpath.Error, "cannot read"):
            loadpath.project("there/is/none.toml")
        with self.assertRaisesRegex(loadpath.Error, "a single value is required|uncertain"):
            loadpath.read_project(text.replace('"5 kN"', '["5 N*m", "6 N*m"]')).solve()
        with self.assertRaisesRegex(loadpath.Error, "does not exist"):
            loadpath.project(lever).solve()["lever.drive.Q"]

    def test_threads(self):
        project = loadpath.project(strut)
        wanted = project.sweep(["lambda = strut.lambda"], samples=50)["lambda"].tobytes()
        found = []
        threads = [threading.Thread(target=lambda: found.append(project.sweep(["lambda = strut.lambda"], samples=50)["lambda"].tobytes()))
                   for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [wanted] * 4)


class Units(unittest.TestCase):
    def test_quantities(self):
        self.assertEqual(loadpath.quantity("12 kN*m"), 12000.0)
        self.assertEqual(loadpath.convert(20.0, "degC", "K"), 293.15)
        np.testing.assert_allclose(loadpath.convert([60.0], "rpm", "rad/s"), [2 * np.pi])
        with self.assertRaisesRegex(loadpath.Error, "is a unit of"):
            loadpath.convert(1.0, "kN", "MPa")
        with self.assertRaises(loadpath.Error):
            loadpath.convert(1.0, "kN", "blah")


if __name__ == "__main__":
    unittest.main()
