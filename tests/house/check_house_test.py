#!/usr/bin/python3
"""scripts/check-house accepts a sound tree and refuses each kind of disorder in it."""

import contextlib
import importlib.util
import io
import subprocess
import sys
import tempfile
import unittest
from importlib.machinery import SourceFileLoader
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CHECK_HOUSE = ROOT / "scripts" / "check-house"

# The script has no ending by which Python would know it.
sys.dont_write_bytecode = True
loader = SourceFileLoader("check_house", str(CHECK_HOUSE))
check_house = importlib.util.module_from_spec(importlib.util.spec_from_loader("check_house", loader))
loader.exec_module(check_house)


def check(root: Path) -> tuple[int, list[str]]:
    """Exit code and findings of `check-house root`."""
    errors = io.StringIO()
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(errors):
        code = check_house.main([str(root)])
    return code, errors.getvalue().splitlines()


class CheckHouse(unittest.TestCase):
    """Each test spoils a sound tree: the project's public headers, emptied, and a few files."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        headers = ROOT / "include" / "rmap"
        for header in headers.rglob("*.hpp"):
            self.write(f"include/rmap/{header.relative_to(headers)}", "#pragma once\n")
        self.write("include/rmap/rmap.hpp", "#pragma once\n" + "".join(
            f"#include <rmap/{header.name}>\n" for header in headers.glob("*.hpp")
            if header.name != "rmap.hpp"))
        self.write("include/rmap/grid.hpp",
                   "#pragma once\n#include <Eigen/Core>\n#include <vector>\n#include <rmap/rtree.hpp>\n")
        self.write("src/CMakeLists.txt", "add_subdirectory(geometry)\n")
        for module in ["geometry", "rtree", "grid", "query", "approximation", "simulation", "io"]:
            self.write(f"src/{module}/part.hpp", "#pragma once\n")
        self.write("src/io/part.cpp", '#include "grid/part.hpp"\n#include <rmap/cast_ray.hpp>\n')
        self.write("apps/rmap/words.hpp", "#pragma once\n")
        self.write("apps/rmap/main.cpp", '#include "words.hpp"\n#include <rmap/rmap.hpp>\n')
        self.write("tests/support/scenes.hpp", "#pragma once\n")
        self.write("benchmarks/insert.cpp", '#include "support/scenes.hpp"\n')

    def write(self, path: str, text: str):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def assert_refused(self, *expected: str):
        """check-house has one finding, and its line holds each of `expected`."""
        code, lines = check(self.root)
        self.assertEqual(code, 1)
        self.assertEqual(len(lines), 1, lines)
        for part in expected:
            self.assertIn(part, lines[0])

    def test_a_sound_tree_is_accepted(self):
        self.assertEqual(check(self.root), (0, []))

    def test_every_arrow(self):
        """All pairs of modules, by their inner and by their public headers."""
        order = {"geometry": "cell", "rtree": "rtree", "grid": "grid", "query": "cells",
                 "simulation": "simulation", "io": "map_file"}
        allowed = {("rtree", "geometry"), ("grid", "geometry"), ("grid", "rtree"),
                   ("query", "geometry"), ("query", "rtree"), ("query", "grid"),
                   ("simulation", "geometry"), ("io", "geometry"), ("io", "rtree"),
                   ("io", "grid"), ("io", "query")}
        tried = 0
        for module in order:
            for target, header in order.items():
                for line in [f'#include "{target}/part.hpp"', f"#include <rmap/{header}.hpp>"]:
                    with self.subTest(module=module, line=line):
                        self.write(f"src/{module}/tried.cpp", f"// A comment.\n{line}\n")
                        if module == target or (module, target) in allowed:
                            self.assertEqual(check(self.root), (0, []))
                        else:
                            self.assert_refused(f"src/{module}/tried.cpp:2:", f" of {target}: ")
                        tried += 1
            (self.root / f"src/{module}/tried.cpp").unlink()
        self.assertEqual(tried, 72)

    def test_query_and_approximation_do_not_know_each_other(self):
        self.write("src/query/part.cpp", '#include "approximation/part.hpp"\n')
        self.assert_refused("src/query/part.cpp:1:", "query may include geometry, grid, rtree")
        self.write("src/query/part.cpp", "")
        self.write("src/approximation/part.cpp", '#include "query/part.hpp"\n')
        self.assert_refused("src/approximation/part.cpp:1:")

    def test_public_header_against_the_arrow(self):
        self.write("include/rmap/cell.hpp", "#pragma once\n#include <rmap/grid.hpp>\n")
        self.assert_refused("include/rmap/cell.hpp:2:", "geometry may include no other module")

    def test_public_header_of_a_folder_against_the_arrow(self):
        self.write("include/rmap/rtree/statistics.hpp",
                   "#pragma once\n#  include <rmap/leaf.hpp>\n")
        self.assert_refused("include/rmap/rtree/statistics.hpp:2:", "of grid")

    def test_public_header_that_needs_a_library(self):
        for name in ["fmt/format.h", "zstd.h", "unistd.h", "tbb/parallel_for.h"]:
            with self.subTest(name=name):
                self.write("include/rmap/cell.hpp", f"#pragma once\n#include <{name}>\n")
                self.assert_refused(f"<{name}>", "Eigen, the standard library")

    def test_public_header_that_reaches_into_src(self):
        self.write("include/rmap/cell.hpp", '#pragma once\n#include "grid/part.hpp"\n')
        self.assert_refused('"grid/part.hpp"')
        self.write("include/rmap/cell.hpp", "#pragma once\n#include <geometry/part.hpp>\n")
        self.assert_refused("<geometry/part.hpp>")

    def test_public_header_without_a_module(self):
        self.write("include/rmap/rtree.hpp", "#pragma once\n")
        self.write("include/rmap/odd/thing.hpp", "#pragma once\n")
        self.assert_refused("include/rmap/odd/thing.hpp:1:", "PUBLIC_HEADERS")

    def test_listed_header_that_does_not_exist(self):
        (self.root / "include/rmap/cells.hpp").unlink()
        umbrella = self.root / "include/rmap/rmap.hpp"
        umbrella.write_text(umbrella.read_text().replace("#include <rmap/cells.hpp>\n", ""))
        self.assert_refused("include/rmap/cells.hpp", "does not exist")

    def test_header_that_the_umbrella_leaves_out(self):
        umbrella = self.root / "include/rmap/rmap.hpp"
        umbrella.write_text(umbrella.read_text().replace("#include <rmap/cells.hpp>\n", ""))
        self.assert_refused("rmap.hpp:1:", "does not include <rmap/cells.hpp>")

    def test_module_that_includes_the_umbrella(self):
        self.write("src/io/part.cpp", "#include <rmap/rmap.hpp>\n")
        self.assert_refused("src/io/part.cpp:1:", "for programs")

    def test_include_of_a_public_header_that_does_not_exist(self):
        self.write("tests/grid/x_test.cpp", "#include <rmap/no_such.hpp>\n")
        self.assert_refused("tests/grid/x_test.cpp:1:", "does not exist")

    def test_include_of_src_without_its_module(self):
        self.write("src/io/other.cpp", '#include "part.hpp"\n')
        self.assert_refused("src/io/other.cpp:1:", '"module/file.hpp"')

    def test_folder_of_src_that_is_no_module(self):
        self.write("src/misc/x.cpp", "")
        self.assert_refused("src/misc:1:", "no module")

    def test_program_that_reaches_into_the_library(self):
        for program in ["apps/rmap/x.cpp", "examples/x.cpp", "benchmarks/x.cpp"]:
            for line in ['#include "grid/part.hpp"', "#include <grid/part.hpp>",
                         '#include "../../src/grid/part.hpp"', '#include "../src/grid/part.hpp"']:
                with self.subTest(program=program, line=line):
                    self.write(program, f"{line}\n")
                    self.assert_refused(f"{program}:1:")
            (self.root / program).unlink()

    def test_app_that_borrows_from_the_tests(self):
        self.write("apps/rmap/x.cpp", '#include "support/scenes.hpp"\n')
        self.assert_refused("apps/rmap/x.cpp:1:")

    def test_length_of_files(self):
        self.write("src/grid/long.cpp", "int x;\n" * 600)
        self.assertEqual(check(self.root), (0, []))
        self.write("src/grid/long.cpp", "int x;\n" * 601)
        self.assert_refused("src/grid/long.cpp:601:", "at most 600")

    def test_header_without_pragma_once(self):
        self.write("src/grid/odd.hpp", "int x;\n")
        self.assert_refused("src/grid/odd.hpp:1:", "#pragma once")

    def test_path_of_a_machine(self):
        folder = "/" + "home/someone"  # in two parts: this file is checked too
        for text in [f"{folder}/x", f'open("{folder}/x")', f"file://{folder}"]:
            with self.subTest(text=text):
                self.write("docs/page.md", f"# A page\n\n{text}\n")
                self.assert_refused("docs/page.md:3:", folder)
        self.write("docs/page.md", "see src/home/x, ~/home/x and http://example.org/home/x\n")
        self.assertEqual(check(self.root), (0, []))

    def test_link_that_leads_nowhere(self):
        self.write("README.md", "See [docs](docs/x.md).\n")
        self.assert_refused("README.md:1:", "docs/x.md")
        self.write("docs/x.md", "[Up](../README.md#see), [here](#x), [far](https://x.org/y).\n")
        self.assertEqual(check(self.root), (0, []))

    def test_mark_of_unfinished_work(self):
        mark = "TO" + "DO"
        self.write("src/grid/x.cpp", f"int x;  // {mark}: more\n")
        self.assert_refused("src/grid/x.cpp:1:", mark)

    def test_what_a_build_made_is_passed_over(self):
        self.write("build/dev/x.cpp", "int x;\n" * 601)
        self.write(".git/x.cpp", "int x;\n" * 601)
        self.assertEqual(check(self.root), (0, []))
        self.write(".ci/run", "int x;\n" * 601)
        self.assert_refused(".ci/run:601:")

    def test_binary_files_are_passed_over(self):
        (self.root / "golden.bin").write_bytes(b"\xff\xfe\n" * 1000)
        self.assertEqual(check(self.root), (0, []))

    def test_several_findings_each_have_a_line(self):
        self.write("src/grid/odd.hpp", '#include "io/part.hpp"\n')
        code, lines = check(self.root)
        self.assertEqual(code, 1)
        self.assertEqual(len(lines), 2)

    def test_usage(self):
        self.assertEqual(check(self.root / "src" / "grid")[0], 2)
        for arguments, code in [(["--odd"], 2), (["a", "b"], 2), (["--help"], 0)]:
            result = subprocess.run([sys.executable, CHECK_HOUSE, *arguments], check=False,
                                    capture_output=True)
            self.assertEqual(result.returncode, code)


if __name__ == "__main__":
    unittest.main()
