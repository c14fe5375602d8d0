#!/usr/bin/env python3
"""The stages of `cargo bench --bench stages` beside the quickest programs known that do the same, on the same helical gears.

    pip install numpy meshlib manifold3d trimesh embreex
    cargo bench --bench stages --no-run        # prints where the program of the bench is
    benches/peers.py target/release/deps/stages-HASH [10k 100k 1M] [--clearbeam target/release/clearbeam]

Each stage is timed in turns: ours, each peer, ours, each peer, in fresh processes of the bench and in this one; of each the
median. Prints a table: milliseconds of ours and of the quickest peer, and ours / peer: below 1 ours is quicker. With
--clearbeam, whole commands are timed as well, from start to end of the process.
"""

import argparse
import math
import os
import re
import statistics
import subprocess
import sys
import tempfile
import time

import meshlib.mrmeshnumpy as mn
import meshlib.mrmeshpy as mm
import numpy as np

SIZES = {"10k": (14, 4, 8, 3), "100k": (40, 8, 15, 4), "1M": (40, 24, 54, 11)}
WIDTH, BORE, ROOT, TIP, TURN = 40.0, 12.0, 40.0, 46.0, np.radians(25.0)
# Corners of a tooth: share of the pitch, radius.
TOOTH = [(0.0, ROOT), (0.22, ROOT), (0.40, TIP), (0.66, TIP), (0.84, ROOT), (1.0, ROOT)]
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
ANGLE = math.radians(20.0)
BEAMS = 100_000
TURNS = 3
UNITS_MS = {"ns": 1e-6, "µs": 1e-3, "us": 1e-3, "ms": 1.0, "s": 1e3}


def helical_gear(teeth, k, layers, rings):
    """Triangles (n, 3, 3) float32 of `sample::solids::helical_gear`."""
    tooth = []
    for section, ((s0, r0), (s1, r1)) in enumerate(zip(TOOTH, TOOTH[1:])):
        n = max(k // 2, 1) if section in (0, 4) else k
        f = np.arange(n) / n
        tooth.append(np.column_stack([s0 + f * (s1 - s0), r0 + f * (r1 - r0)]))
    tooth = np.concatenate(tooth)
    share = (np.arange(teeth)[:, None] + tooth[None, :, 0]).ravel()
    angle, radius = share * (2 * np.pi / teeth), np.tile(tooth[:, 1], teeth)

    def row(z, inwards):
        r = np.full_like(radius, BORE) if inwards == 1 else radius + inwards * (BORE - radius)
        a = angle + TURN * z / WIDTH
        return np.column_stack([r * np.cos(a), r * np.sin(a), np.full_like(r, z)]).astype(np.float32)

    def tube(rows):
        for low, high in zip(rows, rows[1:]):
            low1, high1 = np.roll(low, -1, axis=0), np.roll(high, -1, axis=0)
            yield np.stack([low, low1, high1], axis=1)
            yield np.stack([low, high1, high], axis=1)

    z = [WIDTH * i / layers for i in range(layers + 1)]
    f = [i / rings for i in range(rings + 1)]
    skins = (
        [row(h, 0) for h in z],
        [row(h, 1) for h in reversed(z)],
        [row(0.0, i) for i in reversed(f)],
        [row(WIDTH, i) for i in f],
    )
    return np.concatenate([strip for rows in skins for strip in tube(rows)])


def write_stl(path, triangles):
    records = np.zeros(len(triangles), RECORD)
    records["corners"] = triangles
    with open(path, "wb") as file:
        file.write(b"helical gear".ljust(80))
        file.write(np.uint32(len(triangles)).tobytes())
        records.tofile(file)


def surface_beams(triangles):
    """Points spread evenly over the area, with the normal of their facet."""
    a, b, c = triangles.astype(np.float64).transpose(1, 0, 2)
    cross = np.cross(b - a, c - a)
    size = np.linalg.norm(cross, axis=1)
    facet = np.searchsorted(np.cumsum(size), (np.arange(BEAMS) + 0.5) / BEAMS * size.sum())
    i = np.arange(1, BEAMS + 1)
    u, v = np.sqrt(i * 0.7548776662466927 % 1.0)[:, None], (i * 0.5698402909980532 % 1.0)[:, None]
    a, b, c, normal = a[facet], b[facet], c[facet], (cross / size[:, None])[facet]
    # Off the surface, or its own facet would be hit.
    return a + ((b - a) * (1 - v) + (c - a) * v) * u + normal * 1e-3, normal


def peers(path, triangles):
    """Of each stage of the bench what the peers do: name and work."""
    whole = mm.loadMesh(path)
    faces, vertices = mn.getNumpyFaces(whole.topology).astype(np.int32), mn.getNumpyVerts(whole).astype(np.float32)

    def topology():
        return mn.meshFromFacesVerts(faces, vertices)

    def surfaces():
        creases = whole.findCreaseEdges(ANGLE)
        return mm.MeshComponents.getAllComponentsMap(mm.MeshPart(whole), mm.MeshComponents.FaceIncidence.PerEdge, creases)

    whole.getAABBTree()
    part, (low, high) = mm.MeshPart(whole), (float(vertices[:, 2].min()), float(vertices[:, 2].max()))

    def heights(count):
        return [float(z) for z in low + (np.arange(count) + 0.5617) / count * (high - low)]

    def sections(count):
        return [mm.extractXYPlaneSections(part, z) for z in heights(count)]

    yield "read, weld, topology", [("MeshLib", lambda: mm.loadMesh(path))]
    yield "topology", [("MeshLib", topology)]
    yield "dihedral angles, merge tree", [("MeshLib", surfaces)]
    yield "recut, tree alone", [("MeshLib", surfaces)]
    yield "recut, all surfaces", [("MeshLib", surfaces)]
    slicers = [("MeshLib", lambda: sections(100))]
    try:
        import manifold3d

        solid = manifold3d.Manifold(manifold3d.Mesh(vert_properties=vertices, tri_verts=faces.astype(np.uint32)))
        if solid.num_tri() > 0:
            slicers.append(("manifold3d", lambda: [solid.slice(z).to_polygons() for z in heights(100)]))
    except ImportError:
        pass
    yield "slicing, 100 planes", slicers
    if len(faces) in range(50_000, 500_000):
        yield "slicing, 500 planes", [("MeshLib", lambda: sections(500))]
    import trimesh
    from trimesh.ray.ray_pyembree import RayMeshIntersector

    mesh = trimesh.Trimesh(vertices, faces, process=False, validate=False)
    origins, normals = surface_beams(triangles)

    def structure():
        # It is built at the first ray.
        rays = RayMeshIntersector(mesh)
        rays.intersects_any(origins[:1], normals[:1])
        return rays

    rays = structure()
    yield "ray structure", [("Embree", structure)]
    yield "interference, 100k beams", [("Embree", lambda: rays.intersects_any(origins, normals))]


def timed_ms(work):
    start = time.perf_counter()
    work()
    return (time.perf_counter() - start) * 1e3


def ours_ms(bench, stage, size):
    """Criterion's estimate of one stage, in a process of its own."""
    name = f"stages/{stage}/{size}"
    told = subprocess.run([bench, "--bench", "--noplot", "--exact", name], capture_output=True, text=True).stdout
    found = re.search(r"time:\s+\[\S+ \S+ (\S+) (\S+) ", told)
    if not found:
        sys.exit(f"the bench has no stage {name}")
    return float(found[1]) * UNITS_MS[found[2]]


def program(clearbeam, path, folder):
    """The whole program, files included."""
    plan = ["plan", path, "--surfaces", "all", "--overwrite", "--out", os.path.join(folder, "plan"), "--spacing"]
    yield "clearbeam inspect", ["inspect", path]
    yield "clearbeam plan, 4 mm", [*plan, "4"]
    yield "clearbeam plan, 0.5 mm", [*plan, "0.5"]


def growth(of_stages):
    """By which power of the facets the time of each stage grows: the slope of a straight line through the logarithms."""
    for stage, points in of_stages.items():
        if len(points) > 1:
            facets, ms = np.log([p[0] for p in points]), np.log([p[1] for p in points])
            yield stage, float(np.polyfit(facets, ms, 1)[0])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("bench", help="the program of the bench")
    parser.add_argument("--clearbeam", help="the program; without it no whole command is timed")
    parser.add_argument("sizes", nargs="*", help="10k, 100k, 1M; all by default")
    arguments = parser.parse_args()
    unknown = [s for s in arguments.sizes if s not in SIZES]
    if unknown:
        sys.exit(f"{unknown[0]}: give 10k, 100k or 1M")
    of_stages = {}
    print("| stage | facets | clearbeam | peer | clearbeam / peer |\n|---|---|---|---|---|", flush=True)
    for size in arguments.sizes or SIZES:
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, f"gear_{size}.stl")
            triangles = helical_gear(*SIZES[size])
            write_stl(path, triangles)
            for stage, works in peers(path, triangles):
                ours, theirs = [], {name: [] for name, _ in works}
                for _ in range(TURNS):
                    ours.append(ours_ms(arguments.bench, stage, size))
                    for name, work in works:
                        theirs[name].append(timed_ms(work))
                own = statistics.median(ours)
                of_stages.setdefault(stage, []).append((len(triangles), own))
                name, best = min(((n, statistics.median(t)) for n, t in theirs.items()), key=lambda pair: pair[1])
                print(f"| {stage} | {size} | {own:.3g} | {best:.3g} {name} | {own / best:.2f} |", flush=True)
            for name, words in program(arguments.clearbeam, path, folder) if arguments.clearbeam else ():
                command = [arguments.clearbeam, *words]
                quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
                ms = statistics.median(timed_ms(lambda: subprocess.run(command, **quiet)) for _ in range(TURNS))
                of_stages.setdefault(name, []).append((len(triangles), ms))
                print(f"| {name} | {size} | {ms:.0f} | – | |", flush=True)
    print("\n| stage | time grows as facets to the power of |\n|---|---|")
    for stage, power in growth(of_stages):
        print(f"| {stage} | {power:.2f} |")


if __name__ == "__main__":
    main()
