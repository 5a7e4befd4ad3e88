# %% [markdown]
# How large must a shaft be, if neither its torque nor the strength of its steel is known for sure?
# Cells begin with `# %%`: editors run them one by one, `python3 shaft_study.py` runs all.

# %%
import loadpath
import numpy as np

torsion = loadpath.calculator("shaft.torsion")
print(torsion.title, "-", ", ".join(torsion.inputs))

# %% One machine
one = torsion.solve(T="1.2 kN*m", d="60 mm", tau_adm="40 MPa")
print(one["tau_max"].text, "|", one.verdict)

# %% A hundred thousand torques, each with its own allowable stress: columns in, columns out
rng = np.random.default_rng(1)
n = 100_000
T = rng.normal(1.2, 0.12, n)  # kN*m
tau_adm = rng.lognormal(np.log(40.0), 0.06, n)  # MPa

for d in ("50 mm", "56 mm", "63 mm"):
    sweep = torsion.sweep(T=("kN*m", T), tau_adm=("MPa", tau_adm), d=d, results=["tau_max", "u_tau"])
    share = 1.0 - sweep.passes.mean()
    print(f"{d}: {100 * share:.2f} % fail, stress {sweep.to('tau_max').mean():.1f} MPa in the mean")

# %% Rows that are invalid designs are marked, not dropped
bores = np.linspace(0.0, 0.07, 8)
sweep = torsion.sweep(T="1.2 kN*m", d="60 mm", d_bore=bores, tau_adm="40 MPa")
for bore, state in zip(bores, sweep.state):
    print(f"bore {1e3 * bore:4.0f} mm: {loadpath.State(state).name}")
for refused in sweep.refused:
    print(f"{refused.count} refused, the first is row {refused.first}: {refused.message}")

# %% A project: everything that its file says, with the numbers of the command
project = loadpath.read_project("""
[project.sweep]
results = ["tau = shaft.tau_max"]
samples = 2000

[shaft]
calculator = "shaft.torsion"
T = { mean = "1.2 kN*m", sd = "10 %" }
d = { each = "R20", from = "50 mm", to = "63 mm" }
tau_adm = "40 MPa"
""")
sweep = project.sweep()
for d in np.unique(sweep["shaft.d"]):
    at = sweep["shaft.d"] == d
    print(f"{1e3 * d:.0f} mm: {100 * (1 - sweep.passes[at].mean()):.1f} % fail")
print("worst point:", project.point(sweep.summary["worst"][0]["point"]).verdict)

# %% What is wrong says where
try:
    loadpath.read_project('[shaft]\ncalculator = "shaft.torsion"\nT = "5 kN"\ntau_adm = "40 MPa"\n', "shaft.toml")
except loadpath.Error as error:
    print(f"{error.file}, line {error.line}, column {error.column}: {error.issues[0].message}")
