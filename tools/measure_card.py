#!/usr/bin/env python3
"""Measures the backend for graphics cards beside two cores of the same machine and writes the tables
of docs/performance.md. For a machine with a card, after `make build` (minutes; --fine: half an hour).

    measure_card.py [--sabo PROGRAM] [--runs FOLDER] [--fine SECONDS] [--only-table]
"""

import argparse
import json
import pathlib
import re
import subprocess
import tomllib

ROOT = pathlib.Path(__file__).parents[1]
PAGE = ROOT / "docs" / "performance.md"
MARKS = ("<!-- card -->\n", "<!-- end -->")
EVENT = 300  # s, as in the paper
BESIDE = 12  # s, of the event on the card and on two cores


def run(command, log):
    """Runs a command with its words in a file."""
    with open(log, "w") as out:
        subprocess.run([str(word) for word in command], check=True, stdout=out, stderr=out)


def measure_event(sabo, runs, case, name, spacing, duration, arguments):
    """Of one run: particles, steps, seconds of flow and of computing."""
    folder = runs / name
    run([sabo, "run", case, "-o", folder, "--overwrite", "--method", "fast", "--spacing", spacing,
         "--duration", duration, *arguments], runs / f"{name}.log")
    manifest = tomllib.loads((folder / "manifest.toml").read_text())
    return {key: manifest["run"][key] for key in ("particles", "steps", "simulated_s", "wall_s")}


def measure(sabo, runs, fine):
    """Leaves card.json and events.json in a folder."""
    runs.mkdir(parents=True, exist_ok=True)
    run([sabo, "bench", "--backend", "cuda", "--json", runs / "card.json"], runs / "card.log")
    case = runs / "case"
    if not case.exists():
        run([sabo, "new", "yohutagawa", case], runs / "case.log")
        # The sound speed follows the flow.
        file = case / "case.toml"
        file.write_text(re.sub(r"(?m)^reference_speed.*\n", "", file.read_text()))
    card, cores = ["--backend", "cuda"], ["--threads", 2]
    wanted = {"card": (0.75, EVENT, card), "card-beside": (0.75, BESIDE, card),
              "cores-beside": (0.75, BESIDE, cores)}
    if fine:
        wanted["fine"] = (0.25, fine, card)
    events = {name: measure_event(sabo, runs, case, name, *what) for name, what in wanted.items()}
    events["name"] = subprocess.run(
        ["nvidia-smi", "--query-gpu=name", "--format=csv,noheader"], check=True,
        capture_output=True, text=True).stdout.splitlines()[0]
    (runs / "events.json").write_text(json.dumps(events))


def step_table(measured):
    lines = ["| step of a deep layer | particles of the fluid | ns a particle-step | bytes a particle, ground included |",
             "|---|---:|---:|---:|"]
    for key, nanoseconds in measured.items():
        found = re.fullmatch(r"card/(\w+)/(\d+)/step", key)
        if not found:
            continue
        method, count = found[1], int(found[2])
        bytes_each = measured[f"card/{method}/{count}/memory"]
        lines.append(f"| `{method}` | {count:,} | {nanoseconds:.1f} | {bytes_each:.0f} |")
    return lines


def pass_table(measured):
    speeds = {}
    for key, value in measured.items():
        found = re.fullmatch(r"card/(\w+)/(\d+)/(.+)/speed", key)
        if found:
            speeds.setdefault((found[1], found[3]), {})[int(found[2])] = value
    counts = sorted({count for row in speeds.values() for count in row})
    lines = ["| billion pairs/s | " + " | ".join(f"{count:,}" for count in counts) + " |",
             "|---|" + "---:|" * len(counts)]
    for (method, name), row in speeds.items():
        cells = " | ".join(f"{row[count]:.0f}" if count in row else "" for count in counts)
        lines.append(f"| `{method}`: {name} | {cells} |")
    return lines


def event_table(events):
    def speed(name):
        return events[name]["steps"] / events[name]["wall_s"]

    lines = ["| the event at Yohutagawa by `fast` | particles | flow | steps | time | steps/s |",
             "|---|---:|---:|---:|---:|---:|"]
    for name, words in (("card", "card, 0.75 m"), ("card-beside", "card, 0.75 m, its start"),
                        ("cores-beside", "two cores, 0.75 m, its start"),
                        ("fine", "card, 0.25 m, its start")):
        if name not in events:
            continue
        of = events[name]
        lines.append(f"| {words} | {of['particles']:,} | {of['simulated_s']:.0f} s | {of['steps']:,} | "
                     f"{of['wall_s']:.1f} s | {speed(name):.0f} |")
    ratio = speed("card-beside") / speed("cores-beside")
    return lines + ["", f"The card is {ratio:.0f} times as fast there as two cores of its machine."]


def table(runs):
    card = json.loads((runs / "card.json").read_text())
    events = json.loads((runs / "events.json").read_text())
    measured = {row["name"]: row["value"] for row in card["results"]}
    head = [f"{events['name']}, sabo {card['version']}, {card['date'][:10]}; by `tools/measure_card.py`."]
    parts = (head, step_table(measured), pass_table(measured), event_table(events))
    return "\n\n".join("\n".join(part) for part in parts) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sabo", type=pathlib.Path, default=ROOT / "build/release/src/sabo")
    parser.add_argument("--runs", type=pathlib.Path, default=ROOT / "runs/card")
    parser.add_argument("--fine", type=float, metavar="SECONDS", default=0,
                        help="so much of the event at 0.25 m as well")
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
