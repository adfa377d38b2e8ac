#!/usr/bin/env python3
"""Measures the backend for graphics cards beside two cores of the same machine and writes the table
of docs/performance.md. For a machine with a card, after `make build` (minutes; --fine: half an hour).

    measure_card.py [--sabo PROGRAM] [--runs FOLDER] [--fine] [--only-table]
"""

import argparse
import json
import pathlib
import re
import subprocess
import time

ROOT = pathlib.Path(__file__).parents[1]
PAGE = ROOT / "docs" / "performance.md"
MARKS = ("<!-- card -->\n", "<!-- end -->")
EVENT = 300  # s, as in the paper


def run(command, log):
    """Runs a command with its words in a file; seconds."""
    start = time.monotonic()
    with open(log, "w") as out:
        subprocess.run([str(word) for word in command], check=True, stdout=out, stderr=out)
    return time.monotonic() - start


def measure(sabo, runs, is_fine):
    """Leaves card.json, cores.json and events.json in a folder."""
    runs.mkdir(parents=True, exist_ok=True)
    run([sabo, "bench", "--backend", "cuda", "--json", runs / "card.json"], runs / "card.log")
    run([sabo, "bench", "--only", "steps,particles", "--threads", 2, "--json", runs / "cores.json"],
        runs / "cores.log")
    case = runs / "case"
    if not case.exists():
        run([sabo, "new", "yohutagawa", case], runs / "case.log")
    events = {}
    for method in ("fast", "paper"):
        for name, arguments in (("card", ["--backend", "cuda"]), ("cores", ["--threads", "2"])):
            if (method, name) == ("paper", "cores"):
                continue  # an hour or two
            folder = runs / f"{method}-{name}"
            events[f"{method} 0.75 {name}"] = run(
                [sabo, "run", case, "-o", folder, "--overwrite", "--method", method, "--spacing",
                 0.75, "--duration", EVENT, *arguments], runs / f"{folder.name}.log")
    if is_fine:
        events["fast 0.25 card"] = run(
            [sabo, "run", case, "-o", runs / "fine", "--overwrite", "--spacing", 0.25, "--duration",
             EVENT, "--method", "fast", "--backend", "cuda"], runs / "fine.log")
    (runs / "events.json").write_text(json.dumps(events))


def values(file):
    return {row["name"]: row["value"] for row in file["results"]}


def table(runs):
    card, cores = (json.loads((runs / f"{name}.json").read_text()) for name in ("card", "cores"))
    events = json.loads((runs / "events.json").read_text())
    name = subprocess.run(["nvidia-smi", "--query-gpu=name", "--format=csv,noheader"], check=True,
                          capture_output=True, text=True).stdout.splitlines()[0]
    lines = [f"{name}; two cores of an {cores['cpu']}; {card['date'][:10]}, sabo {card['version']};",
             "by `tools/measure_card.py`.", "",
             "| step of a deep layer | particles of the fluid | ns a particle-step | bytes a particle |",
             "|---|---:|---:|---:|"]
    measured = values(card)
    for key, value in measured.items():
        found = re.fullmatch(r"card/(\w+)/(\d+)/step", key)
        if found:
            method, count = found.groups()
            lines.append(f"| `{method}` | {int(count):,} | {value:.3g} | "
                         f"{measured[f'card/{method}/{count}/memory']:.0f} |")
    lines += ["", "| pass over pairs | method | particles | billion pairs/s |", "|---|---|---:|---:|"]
    for key, value in measured.items():
        found = re.fullmatch(r"card/(\w+)/(\d+)/(.+)/speed", key)
        if found:
            method, count, name_of_pass = found.groups()
            lines.append(f"| {name_of_pass} | `{method}` | {int(count):,} | {value:.1f} |")
    lines += ["", "| the event at Yohutagawa, 300 s | card | two cores | ratio |", "|---|---:|---:|---:|"]
    for key, seconds in events.items():
        method, spacing, where = key.split()
        if where != "card":
            continue
        other = events.get(f"{method} {spacing} cores")
        ratio = f"{other:.0f} s | {other / seconds:.1f}" if other else "| "
        lines.append(f"| `{method}`, {spacing} m | {seconds:.0f} s | {ratio} |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sabo", type=pathlib.Path, default=ROOT / "build/release/src/sabo")
    parser.add_argument("--runs", type=pathlib.Path, default=ROOT / "runs/card")
    parser.add_argument("--fine", action="store_true", help="the event at 0.25 m as well")
    parser.add_argument("--only-table", action="store_true", help="of what has been measured")
    options = parser.parse_args()
    if not options.only_table:
        measure(options.sabo, options.runs, options.fine)
    page = PAGE.read_text()
    start = page.index(MARKS[0]) + len(MARKS[0])
    end = page.index(MARKS[1], start)
    PAGE.write_text(page[:start] + table(options.runs) + page[end:])


if __name__ == "__main__":
    main()
