#!/usr/bin/env python3
"""The stages of `cargo bench`, done by trimesh (numpy, scipy, embreex) on the same helical gears.

    pip install numpy scipy trimesh embreex shapely networkx
    benches/peers.py [--clearbeam target/release/clearbeam] [10k 100k 1M]

Prints medians of five, milliseconds. With --clearbeam, `inspect` and `plan` of that program are
timed as well, from start to end of the process. Compare with `cargo bench` of the same sitting.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time

import numpy as np
import trimesh
from trimesh.ray.ray_pyembree import RayMeshIntersector

SIZES = {"10k": (14, 4, 8, 3), "100k": (40, 8, 15, 4), "1M": (40, 24, 54, 11)}
WIDTH, BORE, ROOT, TIP, TURN = 40.0, 12.0, 40.0, 46.0, np.radians(25.0)
# Corners of a tooth: share of the pitch, radius.
TOOTH = [(0.0, ROOT), (0.22, ROOT), (0.40, TIP), (0.66, TIP), (0.84, ROOT), (1.0, ROOT)]
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
ANGLE = np.radians(20.0)
BEAMS = 100_000


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


def surface_beams(mesh):
    """Points spread evenly over the area, with the normal of their facet."""
    areas = np.cumsum(mesh.area_faces)
    facet = np.searchsorted(areas, (np.arange(BEAMS) + 0.5) / BEAMS * areas[-1])
    i = np.arange(1, BEAMS + 1)
    u, v = np.sqrt(i * 0.7548776662466927 % 1.0)[:, None], (i * 0.5698402909980532 % 1.0)[:, None]
    a, b, c = mesh.triangles[facet].transpose(1, 0, 2)
    normal = mesh.face_normals[facet]
    # Off the surface, or its own facet would be hit.
    return a + ((b - a) * (1 - v) + (c - a) * v) * u + normal * 1e-3, normal


def median_ms(work, repeats=5):
    times = []
    for _ in range(repeats):
        start = time.perf_counter()
        result = work()
        times.append((time.perf_counter() - start) * 1e3)
    return sorted(times)[len(times) // 2], result


def stages(path):
    """Name and work of every stage, and what to say of its result."""
    loaded = trimesh.load(path, process=True)
    vertices, faces = np.array(loaded.vertices), np.array(loaded.faces)

    def fresh():
        # trimesh keeps what it has computed: every repeat begins with a new mesh.
        return trimesh.Trimesh(vertices, faces, process=False, validate=False)

    def topology():
        mesh = fresh()
        return len(mesh.face_adjacency), len(mesh.edges_unique)

    def surfaces():
        mesh = fresh()
        smooth = mesh.face_adjacency[mesh.face_adjacency_angles < ANGLE]
        return trimesh.graph.connected_component_labels(smooth, node_count=len(faces))

    known = fresh()
    known.face_adjacency, known.face_adjacency_angles

    def recut():
        smooth = known.face_adjacency[known.face_adjacency_angles < ANGLE]
        return trimesh.graph.connected_component_labels(smooth, node_count=len(faces))

    low, high = vertices[:, 2].min(), vertices[:, 2].max()

    def sliced(count):
        heights = (np.arange(count) + 0.5617) / count * (high - low)
        return fresh().section_multiplane([0, 0, low], [0, 0, 1], heights)

    def segments():
        heights = (np.arange(100) + 0.5617) / 100 * (high - low)
        return trimesh.intersections.mesh_multiplane(fresh(), [0, 0, low], [0, 0, 1], heights)[0]

    def structure():
        # The structure is built at the first ray.
        RayMeshIntersector(fresh()).intersects_any(np.zeros((1, 3)), np.array([[0.0, 0.0, 1.0]]))

    rays = RayMeshIntersector(known)
    origins, normals = surface_beams(known)
    rays.intersects_any(origins[:1], normals[:1])

    def lines(sections):
        return f"{sum(len(s.paths) for s in sections if s is not None)} lines"

    yield "load, weld", lambda: trimesh.load(path, process=True), lambda m: f"{len(m.vertices)} vertices"
    yield "topology", topology, lambda n: f"{n[0]} pairs, {n[1]} edges"
    yield "topology, surfaces at 20°", surfaces, lambda s: f"{s.max() + 1} surfaces"
    yield "recut, adjacency known", recut, lambda s: f"{s.max() + 1} surfaces"
    yield "slicing, 100 planes", lambda: sliced(100), lines
    yield "segments alone, 100 planes", segments, lambda s: f"{sum(map(len, s))} segments, in no order"
    if len(faces) in range(50_000, 500_000):
        yield "slicing, 500 planes", lambda: sliced(500), lines
    yield "ray structure", structure, lambda _: "embreex"
    yield "interference, 100k rays", lambda: rays.intersects_any(origins, normals), lambda h: f"{h.sum()} hit, embreex"


def program(clearbeam, path, folder):
    """The whole program, files included."""

    def run(*arguments):
        return subprocess.run([clearbeam, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode

    plan = ("plan", path, "--out", os.path.join(folder, "plan"), "--direction", "auto", "--spacing", "4")
    yield "clearbeam inspect", lambda: run("inspect", path), lambda status: f"status {status}"
    yield "clearbeam plan", lambda: run(*plan), lambda status: f"status {status}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--clearbeam", help="the program; without it only the peers are timed")
    parser.add_argument("sizes", nargs="*", help="10k, 100k, 1M; all by default")
    arguments = parser.parse_args()
    unknown = [s for s in arguments.sizes if s not in SIZES]
    if unknown:
        sys.exit(f"{unknown[0]}: give 10k, 100k or 1M")
    print(f"trimesh {trimesh.__version__}, numpy {np.__version__}, median of 5", flush=True)
    for size in arguments.sizes or SIZES:
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, f"gear_{size}.stl")
            triangles = helical_gear(*SIZES[size])
            write_stl(path, triangles)
            work = list(stages(path))
            if arguments.clearbeam:
                work += program(arguments.clearbeam, path, folder)
            for name, stage, said in work:
                ms, result = median_ms(stage)
                print(f"{size:>5} {len(triangles):>7}  {name:<26} {ms:>10.2f} ms  {said(result)}", flush=True)


if __name__ == "__main__":
    main()
