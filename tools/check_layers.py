#!/usr/bin/env python3
"""Checks the layers of ARCHITECTURE.md: includes, forbidden words, length of files.

    check_layers.py [ROOT]      ROOT is the repository; default: the one this script is in

Prints "file:line: reason" for each fault and exits 1 if there is one.
"""

import pathlib
import re
import sys

# Folder under src/ -> its layer. A file includes its own folder and lower layers.
LAYERS = {
    "base": 0,
    "math": 1,
    "physics": 2,
    "geometry": 2,
    "particles": 3,
    "terrain": 3,
    "case": 3,
    "backend": 4,
    "backend/reference": 4,
    "backend/cpu": 4,
    "backend/cuda": 4,
    "backend/device": 4,
    "solver": 5,
    "analysis": 6,
    "io/gis": 6,
    "io/mesh": 6,
    "io/case_file": 6,
    "io/output": 6,
    "io/web": 6,
    "run": 7,
    "report": 7,
    "post": 7,
    "bench": 7,
    "verify": 7,
    "app": 8,
}

# What a folder may include of its own layer besides itself.
SIBLINGS = {
    "terrain": {"particles"},
    "backend/reference": {"backend"},
    "backend/cpu": {"backend"},
    "backend/cuda": {"backend", "backend/device"},
    "backend/device": {"backend"},
    "io/output": {"io/gis", "analysis"},
    "report": {"run"},
    "post": {"run"},
    "io/web": {"io/output"},
    "bench": {"run"},
    "verify": {"run"},
}

QUIET_LAYERS = 5  # layers up to this one never print or exit
MAX_LINES = 400
SUFFIXES = {".hpp", ".cpp", ".cu", ".cuh"}

PRINTS = re.compile(
    r"<iostream>|\bstd::(?:cout|cerr|clog|print)\b|\bfmt::print\b"
    r"|\b(?:v?f?printf|f?puts|f?putchar)\s*\("
)
EXITS = re.compile(r"\b(?:exit|_Exit|quick_exit|abort|std::terminate)\s*\(")
OPENS = re.compile(r"<fstream>|\b(?:std::)?[io]?fstream\b|\b(?:fopen|freopen)\s*\(")
PARALLEL = re.compile(r"\bomp\b|omp_|openmp|cuda\w|__global__|<<<", re.IGNORECASE)
# In device code nvcc 13 compiles std::advance of libstdc++ 12, and what is made of it, to nothing.
CARD_FOLDERS = {"math", "physics", "backend/device"}
LOST_ON_CARDS = re.compile(
    r"\bstd::(?:ranges::)?(?:advance|next|prev|upper_bound|lower_bound|equal_range|partition_point)\b"
)

# A comment, or a literal, which is matched first so that "//" within it starts no comment.
COMMENT_OR_LITERAL = re.compile(
    r'R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|//[^\n]*|/\*.*?\*/', re.DOTALL
)
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"')


def folder_of(path):
    """Longest key of LAYERS that holds a path below src/, or None."""
    for parent in pathlib.PurePosixPath(path).parents:
        if str(parent) in LAYERS:
            return str(parent)
    return None


def blank(match):
    """A comment or literal as blank lines, so that line numbers stay."""
    return "\n" * match.group().count("\n")


def include_fault(folder, target):
    """Why a file of `folder` may not include `target`, or None."""
    other = folder_of(target)
    if other is None:
        return f'"{target}" is not in a folder of a known layer; write includes from src/'
    if other == folder or LAYERS[other] < LAYERS[folder]:
        return None
    if LAYERS[other] > LAYERS[folder]:
        return f'"{target}" is of layer {LAYERS[other]}, this file of layer {LAYERS[folder]}'
    if other in SIBLINGS.get(folder, ()):
        return None
    return f'"{target}": {folder} may not use {other}, of the same layer {LAYERS[folder]}'


def word_fault(folder, line):
    """Why a line of code, without comments and literals, may not stand in `folder`, or None."""
    if LAYERS[folder] <= QUIET_LAYERS:
        if PRINTS.search(line):
            return f"layers 0 to {QUIET_LAYERS} never print"
        if EXITS.search(line):
            return f"layers 0 to {QUIET_LAYERS} never exit; throw CaseError or RunError"
    if OPENS.search(line) and not folder.startswith("io/"):
        return "only io/ opens files"
    if folder == "solver" and PARALLEL.search(line):
        return "the solver names no OpenMP and no CUDA; that is for the backends"
    if folder in CARD_FOLDERS and LOST_ON_CARDS.search(line):
        return "graphics cards lose the steps of std::advance and of searches; write the loop"
    return None


def source_faults(path, text):
    """(line, reason) of each fault of a file; `path` is below src/."""
    folder = folder_of(path)
    if folder is None:
        return [(1, "is in no folder of a known layer; add it to tools/check_layers.py")]
    faults = []
    for number, line in enumerate(text.splitlines(), 1):
        include = INCLUDE.match(line)
        if include and (reason := include_fault(folder, include.group(1))):
            faults.append((number, reason))
    for number, line in enumerate(COMMENT_OR_LITERAL.sub(blank, text).splitlines(), 1):
        if reason := word_fault(folder, line):
            faults.append((number, reason))
    return sorted(faults)


def length_fault(text):
    lines = text.count("\n")
    return [(MAX_LINES + 1, f"{lines} lines; split at {MAX_LINES}")] if lines > MAX_LINES else []


def check(root):
    """Number of files and all faults, as "file:line: reason"."""
    files = [p for top in ("src", "tests") for p in sorted((root / top).rglob("*"))
             if p.suffix in SUFFIXES]
    messages = []
    for file in files:
        text = file.read_text(encoding="utf-8")
        path = file.relative_to(root).as_posix()
        faults = length_fault(text)
        if path.startswith("src/"):
            faults = source_faults(path.removeprefix("src/"), text) + faults
        messages += [f"{path}:{line}: {reason}" for line, reason in faults]
    return len(files), messages


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1])
    count, messages = check(root)
    for message in messages:
        print(message)
    print(f"check_layers: {count} files, {len(messages)} faults")
    return 1 if messages or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
