"""`loadpath sweep --hdf5`: the values of `--out`, what a manifest says, the same bytes every time."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import h5py
import numpy as np

program = os.environ.get("LOADPATH_PROGRAM", "loadpath")
root = pathlib.Path(os.environ.get("LOADPATH_ROOT", pathlib.Path(__file__).parents[2]))
strut = root / "examples/strut-sweep/project.toml"


class Hdf5(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def sweep(self, file, *more):
        run = subprocess.run([program, "sweep", str(file), "--quiet", *more], capture_output=True, text=True,
                             cwd=self.folder)
        return run.returncode, run.stderr

    def test_values_and_manifest(self):
        words = ["--results", "a/b = strut.A", "--results", "a_b = strut.lambda"]
        for jobs in ("1", "3"):  # 49 tubes, each 400 times: more rows than are written at once
            self.assertEqual(self.sweep(strut, "--samples", "400", "--jobs", jobs, "--hdf5", f"{jobs}.h5", *words), (0, ""))
        self.assertEqual((self.folder / "1.h5").read_bytes(), (self.folder / "3.h5").read_bytes())
        self.assertEqual(self.sweep(strut, "--samples", "400", "--out", "out", *words), (0, ""))
        manifest = json.loads((self.folder / "out/manifest.json").read_text())
        with h5py.File(self.folder / "1.h5") as file:
            self.assertEqual(len(file), len(manifest["columns"]))
            for key in ("program", "project", "input", "seed", "points"):
                said = file.attrs[key]
                self.assertEqual(said.decode() if isinstance(said, bytes) else said, manifest[key], key)
            for dataset in file.values():
                column = manifest["columns"][dataset.attrs["number"]]
                for key in ("name", "unit", "shown_in"):
                    said = dataset.attrs[key]
                    self.assertEqual(said.decode() if isinstance(said, bytes) else said, column[key])
                self.assertEqual(dataset[:].tobytes(), np.load(self.folder / "out" / column["file"]).tobytes())

    def test_words(self):
        (self.folder / "a.toml").write_text("""[shaft]
calculator = "shaft.torsion"
T = "1 kN*m"
d = "60 mm"
material = ["C45E", "42CrMo4"]
S = 2
""")
        self.assertEqual(self.sweep("a.toml", "--hdf5", "a.h5"), (0, ""))
        with h5py.File(self.folder / "a.h5") as file:
            material = file["shaft.material"]
            self.assertEqual(list(material[:]), [0.0, 1.0])
            self.assertEqual([w.decode() for w in material.attrs["words"]], ["C45E", "42CrMo4"])

    def test_refused(self):
        code, said = self.sweep(strut, "--hdf5", "there/is/no/folder.h5")
        self.assertEqual(code, 2)
        self.assertIn("cannot write 'there/is/no/folder.h5'", said)
        self.assertEqual(self.sweep(strut, "--hdf5", "a.h5", "--out", "b", "--shard", "1/2")[0], 2)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
