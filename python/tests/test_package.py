"""The example runs headless, and the stubs tell what is there."""

import ast
import contextlib
import io
import pathlib
import runpy
import unittest

import loadpath

folder = pathlib.Path(__file__).parents[1]


class Example(unittest.TestCase):
    def test_shaft_study(self):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            runpy.run_path(str(folder / "examples/shaft_study.py"))
        for line in ("28.2942 MPa", "bore   70 mm: REFUSED", "2 refused, the first is row 6",
                     "shaft.toml, line 3, column 6: '5 kN' is a force"):
            self.assertIn(line, said.getvalue())


class Stubs(unittest.TestCase):
    def test_names(self):
        tree = ast.parse((folder / "loadpath/__init__.pyi").read_text())
        classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
        functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
        self.assertEqual(set(classes) | functions, set(loadpath.__all__))
        torsion = loadpath.calculator("shaft.torsion")
        solution = torsion.solve(T=1000.0, d=0.06, tau_adm=4e7)
        sweep = torsion.sweep(T=1000.0, d=0.06, tau_adm=4e7)
        project = loadpath.read_project(torsion.example)
        try:
            loadpath.quantity("5 blah")
        except loadpath.Error as raised:
            error = raised
        objects = {"Calculator": torsion, "Solution": solution, "Sweep": sweep, "Project": project, "Error": error,
                   "Issue": error.issues[0], "Quantity": solution["tau_max"], "Mode": solution.modes[0],
                   "Check": solution.checks[0], "Field": torsion.inputs["T"], "State": loadpath.State,
                   "Refused": loadpath.Refused(1, 0, "", "")}
        self.assertEqual(set(objects), set(classes))
        for name, node in classes.items():
            for member in node.body:
                target = getattr(member, "target", None) or (member.targets[0] if isinstance(member, ast.Assign) else None)
                said = target.id if target is not None else getattr(member, "name", None)
                if said is not None:
                    self.assertTrue(hasattr(objects[name], said), f"{name}.{said}")


if __name__ == "__main__":
    unittest.main()
