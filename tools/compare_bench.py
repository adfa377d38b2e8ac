#!/usr/bin/env python3
"""Compares two results of `sabo bench --json`.

    compare_bench.py BEFORE.json AFTER.json

Prints the ratio AFTER / BEFORE of every value that both have. A * marks what the spread of the
repetitions does not explain: the ranges from the least to the greatest do not touch; a ? what was
measured once and has no spread. Names that only one file has are listed at the end. Exits 0, or 2
when a file cannot be read.
"""

import json
import sys

# What makes two files hard to compare when it differs.
CONDITIONS = ("cpu", "instruction_set", "threads", "compiler")


def read(path):
    """The machine and the results by name; ValueError with a reason where a file is no result."""
    try:
        with open(path, encoding="utf-8") as file:
            bench = json.load(file)
    except (OSError, UnicodeDecodeError, json.JSONDecodeError) as error:
        raise ValueError(f"{path}: {error}") from error
    if not isinstance(bench, dict) or not isinstance(bench.get("results"), list):
        raise ValueError(f"{path}: is no result of sabo bench --json")
    if bench.get("format") != 1:
        raise ValueError(f"{path}: has format {bench.get('format')}, this program reads format 1")
    return bench, {result["name"]: result for result in bench["results"]}


def mark_of(a, b):
    """Whether the spread of the repetitions explains the difference."""
    if 1 in (a["repeats"], b["repeats"]):
        return "?"
    return "" if a["low"] <= b["high"] and b["low"] <= a["high"] else "*"


def rows(before, after):
    """(name, unit, before, after, ratio, mark) for each name in both, in the order of `before`."""
    result = []
    for name, a in before.items():
        b = after.get(name)
        if b is None or None in (a["value"], b["value"]) or a["value"] == 0:
            continue
        result.append((name, a["unit"], a["value"], b["value"], b["value"] / a["value"],
                       mark_of(a, b)))
    return result


def conditions(a, b):
    """Lines that warn of what differs besides the program."""
    return [f"{key} differs: {a.get(key)} and {b.get(key)}" for key in CONDITIONS
            if a.get(key) != b.get(key)]


def report(before_file, after_file):
    before, before_results = read(before_file)
    after, after_results = read(after_file)
    lines = [f"A {before.get('version')}, {before.get('date')}: {before_file}",
             f"B {after.get('version')}, {after.get('date')}: {after_file}"]
    lines += conditions(before, after)
    table = rows(before_results, after_results)
    width = max([len(row[0]) for row in table] + [4])
    lines.append(f"{'name':<{width}}  {'A':>9}  {'B':>9}  {'B/A':>6}    unit")
    lines += [f"{name:<{width}}  {a:>9.4g}  {b:>9.4g}  {ratio:>6.3f} {mark:1}  {unit}"
              for name, unit, a, b, ratio, mark in table]
    for label, ours, others in (("A", before_results, after_results),
                                ("B", after_results, before_results)):
        lines += [f"only in {label}: {name}" for name in ours if name not in others]
    lines.append("* the ranges of the repetitions do not touch; ? measured once")
    return lines


def main():
    if len(sys.argv) != 3:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    try:
        print("\n".join(report(sys.argv[1], sys.argv[2])))
    except ValueError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
