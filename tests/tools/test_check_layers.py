#!/usr/bin/env python3
"""Each rule of tools/check_layers.py, broken and kept."""

import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "tools"))
import check_layers  # noqa: E402


def faults(path, text):
    return [line for line, _ in check_layers.source_faults(path, text)]


class Includes(unittest.TestCase):
    def test_own_folder_and_lower_layers_are_allowed(self):
        self.assertEqual([], faults("terrain/a.cpp", '#include "terrain/b.hpp"\n#include "math/c.hpp"\n'))

    def test_a_higher_layer_is_not(self):
        self.assertEqual([2], faults("physics/a.hpp", '#include <cmath>\n#include "solver/b.hpp"\n'))

    def test_siblings_only_where_listed(self):
        self.assertEqual([], faults("terrain/a.hpp", '#include "particles/b.hpp"\n'))
        self.assertEqual([1], faults("particles/a.hpp", '#include "terrain/b.hpp"\n'))
        self.assertEqual([], faults("io/output/a.cpp", '#include "io/gis/b.hpp"\n'))
        self.assertEqual([1], faults("io/gis/a.cpp", '#include "io/output/b.hpp"\n'))
        self.assertEqual([1], faults("backend/cpu/a.cpp", '#include "backend/reference/b.hpp"\n'))

    def test_subfolders_belong_to_their_parent(self):
        self.assertEqual([], faults("physics/rheology/a.hpp", '#include "physics/yield.hpp"\n'))

    def test_paths_start_at_src(self):
        self.assertEqual([1], faults("math/a.hpp", '#include "vec3.hpp"\n'))

    def test_an_unknown_folder_is_a_fault(self):
        self.assertEqual([1], faults("helpers/a.hpp", ""))


class Words(unittest.TestCase):
    def test_low_layers_do_not_print_exit_or_open(self):
        for code in ("#include <iostream>", 'printf("x");', "std::cerr << 1;", "std::exit(1);",
                     "std::ofstream f(name);", 'fopen("a", "r");'):
            self.assertEqual([1], faults("solver/a.cpp", code + "\n"), code)

    def test_high_layers_print_but_only_io_opens(self):
        self.assertEqual([], faults("app/a.cpp", "#include <iostream>\n"))
        self.assertEqual([1], faults("run/a.cpp", "#include <fstream>\n"))
        self.assertEqual([], faults("io/gis/a.cpp", "#include <fstream>\n"))

    def test_formatting_into_a_buffer_is_not_printing(self):
        self.assertEqual([], faults("base/a.cpp", 'std::snprintf(buffer, 9, "%d", 1);\n'))

    def test_comments_and_literals_do_not_count(self):
        self.assertEqual([], faults("base/a.cpp", '// printf(\n/* exit(\n */ auto s = "exit(1) // ";\n'))
        self.assertEqual([2], faults("base/a.cpp", 'auto s = "//";\nexit(1);\n'))

    def test_the_solver_names_no_backend(self):
        self.assertEqual([1], faults("solver/a.cpp", "#pragma omp parallel\n"))
        self.assertEqual([], faults("solver/a.cpp", "compute(component);\n"))
        self.assertEqual([], faults("backend/cpu/a.cpp", "#pragma omp parallel\n"))

    def test_code_for_cards_searches_by_its_own_loops(self):
        self.assertEqual([1], faults("physics/a.hpp", "auto i = std::upper_bound(a, b, x);\n"))
        self.assertEqual([1], faults("backend/device/a.hpp", "std::advance(i, 3);\n"))
        self.assertEqual([], faults("terrain/a.cpp", "auto i = std::upper_bound(a, b, x);\n"))


class Length(unittest.TestCase):
    def test_400_lines_are_allowed_401_are_not(self):
        self.assertEqual([], check_layers.length_fault("x\n" * 400))
        self.assertEqual(1, len(check_layers.length_fault("x\n" * 401)))


if __name__ == "__main__":
    unittest.main()
