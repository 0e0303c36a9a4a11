"""Matrices that CalculiX itself writes, of each of its eighteen element types, against the frequencies
that CalculiX finds of them.

    python3 tests/calculix/check_elements.py build/graze FOLDER

A strip of steel, 200 x 30 x 4 mm, is held at one end (*BOUNDARY). CalculiX writes its matrices
(*FREQUENCY, SOLVER=MATRIXSTORAGE) and, in a run of its own, its five lowest frequencies with seven
digits, which are those of `graze modes` to 1e-6. Of solids the matrices are written without *BOUNDARY
as well, and the end is held by a set of nodes: the same frequencies, and the whole mass. The file of
the mesh gives the elements of mode_1.vtu. Needs ccx (Debian: calculix-ccx). Exit 1 where one fails.
"""
import itertools
import json
import pathlib
import re
import subprocess
import sys

LENGTH, WIDTH, THICKNESS, DENSITY = 0.2, 0.03, 0.004, 7850.0
ELEMENTS = 4  # along the strip
HEXAHEDRON = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
WEDGE = [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)]
TETRAHEDRON = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)]
SQUARE, TRIANGLE = [(0, 1), (1, 2), (2, 3), (3, 0)], [(0, 1), (1, 2), (2, 0)]


def corners(kind, i):
    """The elements of one cell of the strip, each by its corners."""
    floor = [(i, 0, 0), (i + 1, 0, 0), (i + 1, 1, 0), (i, 1, 0)]
    cube = floor + [(x, y, 1) for x, y, _ in floor]
    if kind in ("C3D4", "C3D10"):
        return [[cube[k] for k in t] for t in
                ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6))]
    if kind in ("C3D6", "C3D15"):
        return [[cube[k] for k in t] for t in ((0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7))]
    if kind.startswith("C3D"):
        return [cube]
    if kind in ("S3", "S6"):
        return [[floor[k] for k in t] for t in ((0, 1, 2), (0, 2, 3))]
    return [floor] if kind.startswith("S") else [[(i, 0, 0), (i + 1, 0, 0)]]


EDGES = {"C3D10": TETRAHEDRON, "C3D15": WEDGE, "C3D20": HEXAHEDRON, "C3D20R": HEXAHEDRON, "S6": TRIANGLE,
         "S8": SQUARE, "S8R": SQUARE}
KINDS = ["C3D4", "C3D6", "C3D8", "C3D8R", "C3D8I", "C3D10", "C3D15", "C3D20", "C3D20R",
         "S3", "S4", "S4R", "S6", "S8", "S8R", "B31", "B32", "B32R"]
# Of VTK: tetrahedron, wedge, hexahedron, the same with nodes on edges, triangles, squares, lines.
CELLS = {"C3D4": 10, "C3D6": 13, "C3D8": 12, "C3D8R": 12, "C3D8I": 12, "C3D10": 24, "C3D15": 26, "C3D20": 25,
         "C3D20R": 25, "S3": 5, "S4": 9, "S4R": 9, "S6": 22, "S8": 23, "S8R": 23, "B31": 3, "B32": 21, "B32R": 21}


def mesh(kind):
    nodes, elements = {}, []
    number = lambda place: nodes.setdefault(place, len(nodes) + 1)
    middle = lambda a, b: tuple((p + q) / 2 for p, q in zip(a, b))
    for i in range(ELEMENTS):
        for places in corners(kind, i):
            element = [number(tuple(map(float, place))) for place in places]
            element += [number(middle(places[a], places[b])) for a, b in EDGES.get(kind, [])]
            if kind.startswith("B32"):  # end, middle, end
                element.insert(1, number(middle(*places)))
            elements.append(element)
    return nodes, elements


def mesh_text(kind, nodes, elements):
    lines = ["*NODE, NSET=NALL"]
    lines += [f"{n}, {x * LENGTH / ELEMENTS!r}, {y * WIDTH!r}, {z * THICKNESS!r}" for (x, y, z), n in nodes.items()]
    lines.append(f"*ELEMENT, TYPE={kind}, ELSET=EALL")
    for e, element in enumerate(elements, 1):
        numbers = [str(k) for k in [e, *element]]
        lines += [", ".join(numbers[k:k + 11]) + ("," if k + 11 < len(numbers) else "")
                  for k in range(0, len(numbers), 11)]
    lines.append("*NSET, NSET=FIX")
    lines += [f"{n}," for (x, _, _), n in nodes.items() if x == 0]
    lines += ["*NSET, NSET=TIP", f"{nodes[(float(ELEMENTS), 0.0, 0.0)]},", "*MATERIAL, NAME=STEEL", "*ELASTIC",
              "2.1e11, .3", "*DENSITY", f"{DENSITY}"]
    if kind.startswith("C"):
        lines += ["*SOLID SECTION, ELSET=EALL, MATERIAL=STEEL"]
    elif kind.startswith("S"):
        lines += ["*SHELL SECTION, ELSET=EALL, MATERIAL=STEEL", f"{THICKNESS}"]
    else:
        lines += ["*BEAM SECTION, ELSET=EALL, MATERIAL=STEEL, SECTION=RECT", f"{WIDTH}, {THICKNESS}", "0, 1, 0"]
    return "\n".join(lines) + "\n"


def calculix(folder, name, kind, step, held=True):
    hold = f"*BOUNDARY\nFIX, 1, {3 if kind.startswith('C') else 6}\n" if held else ""
    (folder / f"{name}.inp").write_text(f"*INCLUDE, INPUT=mesh.inp\n{hold}*STEP\n{step}\n*END STEP\n")
    done = subprocess.run(["ccx", name], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0 or "*ERROR" in done.stdout:
        raise RuntimeError(f"ccx {name}: {done.stdout[-400:]}")


def frequencies_of(data):
    rows = re.findall(r"^ +\d+ +\S+ +(\S+) +\S+ +\S+ *$", data, re.M)
    return [float(row) for row in rows[:5]]


def graze(program, folder, scene, *options):
    (folder / "scene.toml").write_text(scene)
    done = subprocess.run([program, "modes", "scene.toml", "--json", *options], cwd=folder, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"graze: {done.stderr.strip()}")
    return json.loads(done.stdout)


def compare(document, exact):
    found = [mode["frequency"] for mode in document["modes"]]
    worst = max(abs(a / b - 1.0) for a, b in zip(found, exact))
    if len(exact) != 5 or worst > 1e-6:
        raise RuntimeError(f"frequencies {found}, of CalculiX {exact}")
    return worst


def check(program, folder, kind):
    folder.mkdir(parents=True, exist_ok=True)
    nodes, elements = mesh(kind)
    (folder / "mesh.inp").write_text(mesh_text(kind, nodes, elements))
    calculix(folder, "found", kind, "*FREQUENCY\n5")
    calculix(folder, "held", kind, "*FREQUENCY, SOLVER=MATRIXSTORAGE\n5")
    exact = frequencies_of((folder / "found.dat").read_text())
    scene = '[matrices]\nmass = "{0}.mas"\nstiffness = "{0}.sti"\ndofs = "{0}.dof"\ncoordinates = "mesh.inp"\nmodes = 5\n'
    document = graze(program, folder, scene.format("held"), "--out", "shapes")
    worst = compare(document, exact)
    drawn = (folder / "shapes" / "mode_1.vtu").read_text()
    types = re.search(r'Name="types".*?>\s*(.*?)\s*</DataArray>', drawn, re.S).group(1).split()
    if types != [str(CELLS[kind])] * len(elements):
        raise RuntimeError(f"cells {types}")
    if kind.startswith("C"):
        calculix(folder, "free", kind, "*FREQUENCY, SOLVER=MATRIXSTORAGE\n5", held=False)
        held = 'constraints = ["FIX.1", "FIX.2", "FIX.3"]\n[[stop]]\nnode = "TIP.3"\ngap = 1\nrestitution = 0.5\n'
        document = graze(program, folder, scene.format("free") + held)
        worst = max(worst, compare(document, exact))
        whole = LENGTH * WIDTH * THICKNESS * DENSITY
        for share in document["directions"]:
            if share["direction"] and abs(share["total_mass"] / whole - 1.0) > 1e-9:
                raise RuntimeError(f"whole mass {share['total_mass']}, exact {whole}")
    return worst, document["notes"]


def main():
    program, folder = str(pathlib.Path(sys.argv[1]).resolve()), pathlib.Path(sys.argv[2])
    failed = False
    for kind in KINDS:
        try:
            worst, notes = check(program, folder / kind, kind)
            print(f"{kind:7} {worst:.1e}  {notes[0]}")
        except RuntimeError as error:
            failed = True
            print(f"{kind:7} {error}")
    sys.exit(failed)


if __name__ == "__main__":
    main()
