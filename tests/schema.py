"""Holds every project of the repository against the schema, by a validator that is not ours.

Usage: schema.py PROGRAM ROOT; exit 77 where Python lacks jsonschema or tomllib.
"""
import json
import pathlib
import subprocess
import sys

try:
    import jsonschema
    import tomllib
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)

program, root = sys.argv[1], pathlib.Path(sys.argv[2])
schema = json.loads(subprocess.run([program, "schema"], check=True, capture_output=True).stdout)
Validator = jsonschema.Draft202012Validator
Validator.check_schema(schema)
validator = Validator(schema)
files = sorted([*root.glob("examples/*/project.toml"), *root.glob("reference/*.toml")])
wrong = 0
for file in files:
    for error in validator.iter_errors(tomllib.loads(file.read_text(encoding="utf-8"))):
        wrong += 1
        print(file.relative_to(root), ".".join(map(str, error.absolute_path)), error.message[:200])
refused = {"axle": {"calculator": "shaft.torsion", "T": "3 mm", "teapot": 1}}
if validator.is_valid(refused):
    wrong += 1
    print("a wrong project is taken")
for name, definition in schema["$defs"].items():
    own = Validator({"$ref": "#/$defs/" + name, "$defs": schema["$defs"]})
    for example in definition.get("examples", []):
        if not own.is_valid(example):
            wrong += 1
            print(name, "refuses its example", example)
print(len(files), "projects,", wrong, "faults")
sys.exit(1 if wrong or len(files) < 10 else 0)
