#!/usr/bin/env python3
"""Plans every part file of a folder in three directions with two corrections, and prints a table.

    benches/parts_table.py FOLDER --clearbeam target/release/clearbeam [--markdown] [--out TABLE] [--limit SECONDS]

Planes along x, y and z, each with the corrections section-plane and clearance: six runs a file, on all surfaces,
without a robot. A run that takes longer than the limit is ended, and its row says so. Exit statuses are those of
`clearbeam plan` (README): 0 all of it, 3 not all of it, others an error.
"""

import argparse
import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

DIRECTIONS = ["x", "y", "z"]
CORRECTIONS = ["section-plane", "clearance"]
COLUMNS = [
    "file", "facets", "surfaces", "direction", "correction", "status", "passes",
    "free mm", "corrected mm", "blocked mm", "proven", "seconds",
]


def run(command, limit_s):
    """Standard output, standard error, status in words, and seconds; never longer than the limit."""
    begun = time.monotonic()
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=limit_s, check=False)
        out, err, status = done.stdout, done.stderr, str(done.returncode)
        if done.returncode < 0:
            status = f"signal {-done.returncode}"
    except subprocess.TimeoutExpired:
        out, err, status = "", "", f"over {limit_s:g} s"
    except OSError as error:
        sys.exit(f"{command[0]}: {error}")
    return out, err, status, time.monotonic() - begun


def inspected(clearbeam, file, units, limit_s):
    """Number of facets and of feature surfaces; empty where the file cannot be read."""
    out, _, _, _ = run([clearbeam, "inspect", "--json", "--units", units, str(file)], limit_s)
    try:
        report = json.loads(out)
    except ValueError:
        return "", ""
    surfaces = report.get("surfaces", "")
    return report.get("facets", ""), len(surfaces) if isinstance(surfaces, list) else surfaces


def planned(clearbeam, file, options, limit_s):
    """The row of one run, from its status on."""
    with tempfile.TemporaryDirectory() as folder:
        command = [clearbeam, "plan", str(file), "--out", str(Path(folder) / "out"), "--json", *options]
        out, err, status, seconds = run(command, limit_s)
    row = {"status": status, "seconds": f"{seconds:.2f}"}
    try:
        report = json.loads(out)
    except ValueError:
        if err.strip():
            row["status"] += ": " + re.sub(r"\s+", " ", err.strip().splitlines()[0])[:80]
        return row
    proof = report.get("proof") or {}
    row["passes"] = report.get("passes", "")
    lit, corrected, blocked = (float(report.get(key) or 0.0) for key in ("work_mm", "corrected_mm", "blocked_mm"))
    # Lit is along the normal, or tilted away from what is in the way.
    row["free mm"], row["corrected mm"], row["blocked mm"] = (f"{mm:.1f}" for mm in (lit - corrected, corrected, blocked))
    if proof:
        row["proven"] = f"{proof.get('proven', 0)} of {proof.get('intervals', 0)}"
    return row


def rows(args):
    kinds = {"." + kind.lower().lstrip(".") for kind in args.kinds.split(",")}
    files = sorted(p for p in Path(args.folder).rglob("*") if p.is_file() and p.suffix.lower() in kinds)
    if not files:
        sys.exit(f"{args.folder}: no file of {args.kinds}")
    for file in files:
        facets, surfaces = inspected(args.clearbeam, file, args.units, args.limit)
        for direction in DIRECTIONS:
            for correction in CORRECTIONS:
                options = ["--direction", direction, "--correction", correction, "--units", args.units]
                options += ["--spacing", str(args.spacing)] if args.spacing else []
                row = planned(args.clearbeam, file, options, args.limit)
                told = {"file": file.relative_to(args.folder), "facets": facets, "surfaces": surfaces}
                yield {**told, "direction": direction, "correction": correction, **row}


def cell(row, column):
    return str(row.get(column, "")).replace("\t", " ").replace("|", "/")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="folder of part files, looked through with those in it")
    parser.add_argument("--clearbeam", required=True, help="the program")
    parser.add_argument("--kinds", default="stl", help="endings of the files, such as stl,obj (default: stl)")
    parser.add_argument("--units", default="mm", help="unit of the files: mm, m or inch")
    parser.add_argument("--spacing", type=float, help="distance between section planes, mm (default: the program's)")
    parser.add_argument("--limit", type=float, default=300.0, help="seconds after which a run is ended (default: 300)")
    parser.add_argument("--markdown", action="store_true", help="a table of Markdown instead of tabs")
    parser.add_argument("--out", help="file for the table (default: standard output)")
    args = parser.parse_args()
    with open(args.out, "w", encoding="utf-8") if args.out else sys.stdout as out:
        line = (lambda cells: "| " + " | ".join(cells) + " |") if args.markdown else "\t".join
        print(line(COLUMNS), file=out)
        if args.markdown:
            print(line(["---"] * len(COLUMNS)), file=out)
        for row in rows(args):
            # Row by row, so that a long table can be watched.
            print(line([cell(row, column) for column in COLUMNS]), file=out, flush=True)


if __name__ == "__main__":
    main()
