#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Finds what the tests of the numerics would not notice.

Makes one small change of Filters/Core after the other (mutant_list.py) in a copy of the sources,
builds lmoCoreTests and runs it: a mutant is killed if a test fails, else it has survived.

  python3 Testing/mutants.py --scratch DIR [--area AREA] [-D VTK_DIR=...]

DIR keeps the copy, its build and the results, so that the next call builds only what has changed.
Exit code: 0 if all mutants are killed, 1 if one has survived, 2 if the list does not fit the
sources, the unchanged core fails, or a mutant does not compile.
"""
import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

from mutant_list import MUTANTS

SOURCE = pathlib.Path(__file__).resolve().parent.parent
CORE = pathlib.Path("Filters/Core")
PATIENCE = 10  # a mutant may make a test so many times as slow, and then counts as killed
SHORTEST_PATIENCE = 60  # seconds


def tests_in(scratch):
    """The commands of the tests of the numerics, by their names without "Core-"."""
    listed = subprocess.run(
        ["ctest", "--test-dir", scratch / "build-vtk", "-R", "^Core-", "--show-only=json-v1"],
        check=True, capture_output=True, text=True)
    commands = {test["name"].removeprefix("Core-"): test["command"]
                for test in json.loads(listed.stdout)["tests"]}
    return {name: command for name, command in commands.items() if name != "TestLayers"}


def check_list(tests):
    """\\return what does not fit the sources or the tests, one line each."""
    faults = []
    for mutant in MUTANTS:
        path = SOURCE / CORE / mutant.file
        count = path.read_text().count(mutant.old) if path.exists() else 0
        if count != 1:
            faults.append(f"{mutant.file}: {mutant.old!r} is found {count} times")
        if tests and mutant.test not in tests:
            faults.append(f"{mutant.file}: there is no test {mutant.test}")
    return faults


def write_if_changed(path, data):
    if not path.exists() or path.read_bytes() != data:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


def copy_sources(scratch):
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=SOURCE,
                            check=True, capture_output=True, text=True).stdout.splitlines()
    for name in listed:
        if (SOURCE / name).is_file():
            write_if_changed(scratch / name, (SOURCE / name).read_bytes())


def configure(scratch, definitions):
    flags = [] if "CMAKE_BUILD_TYPE" in " ".join(definitions) else [
        "CMAKE_BUILD_TYPE=Release", "CMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"]
    subprocess.run(
        ["cmake", "-S", scratch, "-B", scratch / "build-vtk", "-G", "Ninja", "-DBUILD_TESTING=ON",
         "-DLMO_PARAVIEW=OFF", *(f"-D{definition}" for definition in flags + definitions)],
        check=True, stdout=subprocess.DEVNULL)


def build(scratch, jobs):
    """\\return the compiler's output if it fails, else None"""
    done = subprocess.run(
        ["cmake", "--build", scratch / "build-vtk", f"-j{jobs}", "--target", "lmoCoreTests"],
        capture_output=True, text=True)
    return done.stdout + done.stderr if done.returncode else None


def fails(command, limit):
    """\\return what the test prints about its failure, or None if it passes"""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return f"takes longer than {limit:.0f} s"
    if done.returncode == 0:
        return None
    failures = [line for line in done.stdout.splitlines() if line.startswith("FAILS")]
    return failures[0].removeprefix("FAILS ") if failures else f"exit code {done.returncode}"


def measure_costs(scratch, tests):
    """\\return seconds that each test takes with the unchanged core, measured once"""
    kept = scratch / "costs.json"
    costs = json.loads(kept.read_text()) if kept.exists() else {}
    for name in tests.keys() - costs.keys():
        begin = time.monotonic()
        failure = fails(tests[name], None)
        if failure:
            sys.exit(f"{name} fails with the unchanged core: {failure}")
        costs[name] = time.monotonic() - begin
        kept.write_text(json.dumps(costs, indent=1))
    return costs


def find_killer(mutant, tests, costs):
    """Tries the test that is meant to kill it, then all others, the fastest first.

    \\return (test, failure), or None if all pass
    """
    for name in sorted(tests, key=lambda test: (test != mutant.test, costs[test])):
        failure = fails(tests[name], max(SHORTEST_PATIENCE, PATIENCE * costs[name]))
        if failure:
            return name, failure
    return None


def try_mutant(mutant, scratch, tests, costs, jobs):
    """\\return "killed by ...", "SURVIVED" or "does not compile: ...\""""
    path = scratch / CORE / mutant.file
    unchanged = path.read_text()
    try:
        path.write_text(unchanged.replace(mutant.old, mutant.new))
        errors = build(scratch, jobs)
        if errors:
            return "does not compile: " + errors[-2000:]
        killer = find_killer(mutant, tests, costs)
        return f"killed by {killer[0]}: {killer[1]}" if killer else "SURVIVED"
    finally:
        path.write_text(unchanged)


def print_table(results):
    """Killed and all mutants of each area, as in Documentation/robustness.md."""
    print("\n| area | mutants | killed |\n|---|---|---|")
    for area in dict.fromkeys(mutant.area for mutant in results):
        verdicts = [verdict for mutant, verdict in results.items() if mutant.area == area]
        print(f"| {area} | {len(verdicts)} | {sum(v.startswith('killed') for v in verdicts)} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scratch", type=pathlib.Path, help="folder of the copy and its build")
    parser.add_argument("--area", help="only mutants of this area")
    parser.add_argument("--text", default="", help="only mutants that have this in file or promise")
    parser.add_argument("--again", action="store_true", help="also those that have been killed")
    parser.add_argument("--check", action="store_true", help="only compare the list and the sources")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    parser.add_argument("-D", dest="definitions", action="append", default=[], help="for cmake")
    options = parser.parse_args()
    faults = check_list(None)
    if options.check or faults or not options.scratch:
        print("\n".join(faults))
        print(f"{len(MUTANTS)} mutants, {len(faults)} of them do not fit the sources")
        return 2 if faults else 0

    scratch = options.scratch.resolve()
    if shutil.which("ccache"):
        os.environ.setdefault("CMAKE_CXX_COMPILER_LAUNCHER", "ccache")
    copy_sources(scratch)
    configure(scratch, options.definitions)
    errors = build(scratch, options.jobs)
    if errors:
        print(errors)
        return 2
    tests = tests_in(scratch)
    faults = check_list(tests)
    if faults:
        print("\n".join(faults))
        return 2
    costs = measure_costs(scratch, tests)

    kept = scratch / "results.json"
    known = {} if options.again or not kept.exists() else json.loads(kept.read_text())
    results = {}
    for mutant in MUTANTS:
        if options.area in (None, mutant.area) and options.text in f"{mutant.file} {mutant.promise}":
            verdict = known.get(mutant.key(), "")
            if not verdict.startswith("killed"):
                verdict = try_mutant(mutant, scratch, tests, costs, options.jobs)
            results[mutant] = known[mutant.key()] = verdict
            kept.write_text(json.dumps(known, indent=1))
            print(f"{mutant.area}: {mutant.promise}\n  {verdict}", flush=True)
    print_table(results)
    if any(verdict.startswith("does not") for verdict in results.values()):
        return 2
    return int(any(verdict == "SURVIVED" for verdict in results.values()))


if __name__ == "__main__":
    sys.exit(main())
