#!/usr/bin/env python3
"""Runs the example `yohutagawa` with each treatment of the ground and writes the table of its page.

    yohutagawa_study.py [--sabo PROGRAM] [--runs FOLDER] [--jobs N] [--only-table]

Makes the case once, runs the variants that FOLDER does not hold yet (hours in all; the one at
0.75 m alone takes one to two) and puts the table between the marks of docs/yohutagawa.md.
"""

import argparse
import csv
import pathlib
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).parents[1]
PAGE = ROOT / "docs" / "yohutagawa.md"
MARKS = ("<!-- study -->\n", "<!-- end -->")

RELEASED = 8863  # m3
SHARE = 0.01  # of the released volume that counts as the flow's arrival, as for its front
SMOOTHING = 2  # s, over which discharge and speed are averaged


class Variant:
    """One run. The sound speed follows the reference speed (m/s), so faster flows need more; a
    flow that the ground hardly holds back is over after 100 s."""

    def __init__(self, stress, as_printed, pore_pressure, spacing=1.5):
        self.stress, self.as_printed = stress, as_printed
        self.pore_pressure, self.spacing = pore_pressure, spacing
        is_free = stress == "none"
        self.duration = 100 if is_free else 300
        self.reference_speed = 90 if is_free else 30 if pore_pressure else 20

    @property
    def name(self):
        grain = "" if self.spacing == 1.5 else f"_{self.spacing:g}m"
        return f"{self.stress}_{str(self.as_printed).lower()}_{self.pore_pressure:g}{grain}"

    def case_text(self, template):
        replaced = {
            "pore_pressure_ratio": f"{self.pore_pressure:g}",
            "reference_speed": f"{self.reference_speed}",
            "spacing": f"{self.spacing:g}",
            "duration": f"{self.duration}",
        }
        for key, value in replaced.items():
            template = re.sub(rf"(?m)^{key} = \S+", f"{key} = {value}", template)
        switches = (f'boundary_stress = "{self.stress}"\n'
                    f"as_printed = {str(self.as_printed).lower()}\n")
        # All to the same time, as in the paper.
        template = template.replace("[run]\n", "[run]\nstop_at_rest = false\n")
        return template.replace("[numerics]\n", "[numerics]\n" + switches)


VARIANTS = [Variant(stress, printed, pore)
            for pore in (0, 0.5) for stress in ("own", "mirror", "none") for printed in (False, True)]
VARIANTS.insert(2, Variant("own", False, 0, 0.75))


def columns(file):
    """The columns of a series by their names, as lists of numbers."""
    with open(file, encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    return {name: [float(row[name] or "nan") for row in rows] for name in rows[0]}


def first_time(times, values, level):
    return next((t for t, v in zip(times, values) if v > level), None)


def peak_rate(times, totals):
    """Greatest mean rate over SMOOTHING, and the middle of that time."""
    best, when, start = 0.0, 0.0, 0
    for end, time in enumerate(times):
        while times[start] < time - SMOOTHING - 1e-6:
            start += 1
        span = time - times[start]
        if span > 0.5 * SMOOTHING and (totals[end] - totals[start]) / span > best:
            best, when = (totals[end] - totals[start]) / span, time - span / 2
    return best, when


def row_of(variant, folder):
    front = columns(folder / "series" / "front.csv")
    discharge = columns(folder / "series" / "discharge.csv")
    volumes = columns(folder / "series" / "volumes.csv")
    time = discharge["time [s]"]
    net = {p: [f - b for f, b in zip(discharge[f"{p} forward volume [m3]"],
                                     discharge[f"{p} backward volume [m3]"])] for p in ("p1", "p2")}
    speed, when = peak_rate(front["time [s]"], front["position [m]"])
    arrival = first_time(time, net["p1"], SHARE * RELEASED)
    over = first_time(time, net["p2"], SHARE * RELEASED)
    peaks = {p: peak_rate(time, net[p]) for p in net}

    def seconds(value):
        return "–" if value is None else f"{value:.0f}"

    return [variant.stress, "yes" if variant.as_printed else "no", f"{variant.pore_pressure:g}",
            f"{variant.spacing:g}", seconds(arrival), f"{speed:.0f} at {when:.0f} s", seconds(over),
            f"{peaks['p1'][0]:.0f}", f"{peaks['p2'][0]:.0f} at {peaks['p2'][1]:.0f} s",
            f"{volumes['dam trapped [m3]'][-1]:.0f}", f"{volumes['dam beyond [m3]'][-1]:.0f}",
            f"{volumes['outflow [m3]'][-1]:.0f}", f"{time[-1]:.0f}"]


HEADER = ["`boundary_stress`", "`as_printed`", "r_u", "spacing [m]", "at p1 [s]",
          "fastest front [m/s]", "at p2 [s]", "peak p1 [m³/s]", "peak p2 [m³/s]", "trapped [m³]",
          "beyond [m³]", "left the map [m³]", "end [s]"]
PAPER = ["*published*", "", "", "0.75", "about 30", "25 at 28 s", "about 70", "350", "80 at 100 s",
         "5353", "3510", "", "300"]
FIELD = ["*field survey*", "", "", "", "", "", "", "", "", "5621", "3076", "", ""]


def table(runs):
    rows = [row_of(v, runs / v.name) for v in VARIANTS
            if (runs / v.name / "series" / "volumes.csv").exists()]
    lines = [HEADER, ["---"] * 4 + ["---:"] * (len(HEADER) - 4), *rows, PAPER, FIELD]
    return "".join("| " + " | ".join(cells) + " |\n" for cells in lines)


def run(variant, sabo, runs, base):
    case = runs / "cases" / variant.name
    if (runs / variant.name / "index.html").exists():
        return
    shutil.copytree(base, case, dirs_exist_ok=True)
    text = (base / "case.toml").read_text(encoding="utf-8")
    (case / "case.toml").write_text(variant.case_text(text), encoding="utf-8")
    print("running", variant.name, flush=True)
    subprocess.run([sabo, "run", case, "-o", runs / variant.name, "--overwrite", "--threads", "1"],
                   check=True, stdout=subprocess.DEVNULL)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sabo", default=ROOT / "build" / "release" / "src" / "sabo")
    parser.add_argument("--runs", type=pathlib.Path, default=ROOT / "runs" / "yohutagawa-study")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only-table", action="store_true")
    options = parser.parse_args()

    if not options.only_table:
        base = options.runs / "cases" / "base"
        if not base.exists():
            subprocess.run([options.sabo, "new", "yohutagawa", base], check=True)
        with ThreadPoolExecutor(options.jobs) as pool:
            list(pool.map(lambda v: run(v, options.sabo, options.runs, base), VARIANTS))
    text = PAGE.read_text(encoding="utf-8")
    begin = text.index(MARKS[0]) + len(MARKS[0])
    text = text[:begin] + table(options.runs) + text[text.index(MARKS[1], begin):]
    PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
