#!/usr/bin/env python3
"""tools/compare_bench.py: ratios, the mark, and files that cannot be compared."""

import json
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "tools"))
import compare_bench  # noqa: E402


def result(name, value, low, high, repeats=3):
    return {"name": name, "value": value, "unit": "s", "low": low, "high": high,
            "repeats": repeats}


def bench(*results, **machine):
    return {"format": 1, "cpu": "x", "results": list(results), **machine}


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def file(self, name, content):
        path = pathlib.Path(self.folder.name) / name
        path.write_text(content if isinstance(content, str) else json.dumps(content), "utf-8")
        return str(path)

    def lines(self, before, after):
        return compare_bench.report(self.file("a", before), self.file("b", after))

    def test_the_ratio_is_after_over_before(self):
        lines = self.lines(bench(result("p", 4, 3, 5)), bench(result("p", 6, 5, 7)))
        row = next(line for line in lines if line.startswith("p "))
        self.assertEqual(["p", "4", "6", "1.500", "s"], row.split())

    def test_marks_only_what_the_spread_does_not_explain(self):
        before = bench(result("p", 4, 3, 5), result("q", 4, 3, 5), result("r", 4, 3, 5))
        after = bench(result("p", 6, 5.1, 7), result("q", 6, 4.9, 7), result("r", 2, 1, 2.9))
        marks = {row[0]: row[5] for row in compare_bench.rows(
            {r["name"]: r for r in before["results"]}, {r["name"]: r for r in after["results"]})}
        self.assertEqual({"p": "*", "q": "", "r": "*"}, marks)

    def test_does_not_judge_what_was_measured_once(self):
        a, b = result("p", 4, 4, 4, 1), result("p", 8, 7, 9)
        self.assertEqual("?", compare_bench.mark_of(a, b))

    def test_names_what_only_one_has(self):
        lines = self.lines(bench(result("old", 1, 1, 1)), bench(result("new", 1, 1, 1)))
        self.assertIn("only in A: old", lines)
        self.assertIn("only in B: new", lines)

    def test_leaves_out_what_has_no_ratio(self):
        lines = self.lines(bench(result("p", None, None, None), result("q", 0, 0, 0)),
                           bench(result("p", 1, 1, 1), result("q", 1, 1, 1)))
        self.assertFalse([line for line in lines if line.startswith(("p ", "q "))])

    def test_warns_of_another_machine(self):
        lines = self.lines(bench(cpu="x", threads=2), bench(cpu="y", threads=2))
        self.assertIn("cpu differs: x and y", lines)
        self.assertFalse([line for line in lines if line.startswith("threads")])

    def test_refuses_what_is_no_result(self):
        good = self.file("good", bench())
        for content in ("no json", "[]", "{}", '{"format": 2, "results": []}'):
            with self.assertRaises(ValueError):
                compare_bench.report(good, self.file("bad", content))
        with self.assertRaises(ValueError):
            compare_bench.report(good, "/nowhere/absent.json")


if __name__ == "__main__":
    unittest.main()
