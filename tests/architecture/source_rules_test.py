"""The checker finds what it is meant to find, and only that: each test writes a small tree with one fault."""

import contextlib
import io
import pathlib
import subprocess
import sys
import tempfile
import unittest

import source_rules


class SourceRules(unittest.TestCase):
    def findings(self, rule, tree):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder).resolve()
            for name, text in tree.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return [line.split(": ")[0] for line in source_rules.RULES[rule](root)]

    def test_includes_may_only_point_down(self):
        up = '#pragma once\n#include "host/front/front.hpp"\n'
        tree = {"host/front/front.hpp": "", "kernels/a.hpp": up, "common/b.hpp": up, "bench/c.cpp": up,
                "tests/d.cpp": up}
        self.assertEqual(self.findings("includes", tree), ["common/b.hpp:2", "kernels/a.hpp:2"])

    def test_kernels_and_device_do_not_know_each_other(self):
        tree = {"kernels/a.hpp": '#include "device/b.hpp"\n', "device/b.hpp": '#  include <kernels/a.hpp>\n'}
        self.assertEqual(self.findings("includes", tree), ["device/b.hpp:1", "kernels/a.hpp:1"])

    def test_rooms_of_the_host_include_those_before_them(self):
        tree = {"host/mesh/a.hpp": '#include "host/front/b.hpp"\n', "host/front/b.hpp": '#include "host/mesh/c.hpp"\n',
                "host/march/c.cpp": '#include "host/march/d.hpp"\n#include "host/run/e.hpp"\n', "host/attic/f.cpp": ""}
        self.assertEqual(self.findings("rooms", tree), ["host/attic/f.cpp:1", "host/march/c.cpp:2", "host/mesh/a.hpp:1"])

    def test_headers_do_not_include_each_other_in_a_circle(self):
        tree = {"host/a.hpp": '#include "host/b.hpp"\n', "host/b.hpp": '#include "host/c.hpp"\n#include "host/d.hpp"\n',
                "host/c.hpp": '#include "host/a.hpp"\n', "host/d.hpp": "", "host/e.cpp": '#include "host/a.hpp"\n'}
        self.assertEqual(self.findings("circles", tree), ["host/a.hpp:1"])

    def test_nobody_includes_tests(self):
        tree = {"tests/a.hpp": "", "host/b.cpp": '#include "tests/a.hpp"\n', "bench/c.cpp": '#include "tests/a.hpp"\n'}
        self.assertEqual(self.findings("includes", tree), ["host/b.cpp:1"])

    def test_quoted_includes_start_at_the_root_and_exist(self):
        tree = {"host/a.hpp": "", "host/b.cpp": '#include "a.hpp"\n#include "host/a.hpp"\n#include "host/gone.hpp"\n',
                "host/c.cpp": '#include "../common/x.hpp"\n'}
        self.assertEqual(self.findings("includes", tree), ["host/b.cpp:1", "host/b.cpp:3", "host/c.cpp:1"])

    def test_heavy_headers_stay_in_source_files(self):
        text = "#include <vector>\n#include <toml++/toml.h>\n#include <Eigen/Dense>\n"
        tree = {"host/a.hpp": text, "host/b.cpp": text}
        self.assertEqual(self.findings("includes", tree), ["host/a.hpp:2", "host/a.hpp:3"])

    def test_every_source_file_is_listed(self):
        tree = {"host/CMakeLists.txt": "add_library(host mesh/a.cpp)\nforeach(driver bench_b)", "host/mesh/a.cpp": "",
                "host/bench_b.cpp": "", "host/mesh/extra_a.cpp": "", "tests/c_test.cpp": ""}
        self.assertEqual(self.findings("listed", tree), ["host/mesh/extra_a.cpp:1", "tests/c_test.cpp:1"])

    def test_files_that_pages_name_are_there(self):
        text = "see `host/a.cpp`, `host/a`, `host/b.cpp`\n`host/`, `kernels/c.hpp` and `std/d`\n"
        tree = {"host/a.cpp": "", "README.md": text, "docs/decisions/1.md": text, "CHANGELOG.md": text}
        self.assertEqual(self.findings("named", tree), ["README.md:1", "README.md:2"])

    def test_files_and_functions_have_a_length(self):
        long_function = "int f() {\n" + 60 * "  g();\n" + "}\n"
        method = "class A {\n  void f() {\n" + 58 * "    g();\n" + "  }\n  void h() {\n" + 59 * "    g();\n" + "  }\n};\n"
        tree = {"host/a.cpp": "namespace b {\n" + long_function.replace("  g();\n", "", 2) + long_function + "}\n", "host/b.cpp": method,
                "device/c.cpp": 351 * "int x;\n", "common/d.hpp": 350 * "int x;\n", "tests/e.cpp": long_function}
        self.assertEqual(self.findings("sizes", tree), ["device/c.cpp:1", "host/a.cpp:62", "host/b.cpp:62"])

    def test_functions_of_kernels_have_six_arguments_at_most(self):
        six, seven = "int a, F<int, int> b, int (&c)[2], int d, int e, int f", "int a, int b, int c, int d,\n    int e, int f, int g"
        tree = {"kernels/a.hpp": f"void six({six});\ninline double seven({seven}) {{\n  call(1, 2, 3, 4, 5, 6, 7);\n}}\n",
                "host/b.hpp": f"void seven({seven});\n"}
        self.assertEqual(self.findings("sizes", tree), ["kernels/a.hpp:2"])

    def test_static_schedule_of_chunk_one_is_found_in_any_spelling(self):
        tree = {"kernels/a.cpp": "#pragma omp for schedule(static,1)\n#pragma omp for schedule( static , 1 )\n",
                "kernels/b.cpp": "#pragma omp parallel for schedule(static, 16)\n#pragma omp for schedule(static)\n"}
        self.assertEqual(self.findings("schedule", tree), ["kernels/a.cpp:1", "kernels/a.cpp:2"])

    def test_dynamic_schedule_must_be_monotonic(self):
        tree = {"kernels/a.cpp": "#pragma omp for schedule(dynamic, 4)\n#pragma omp for schedule(nonmonotonic:dynamic)\n",
                "kernels/b.cpp": "#pragma omp for schedule(monotonic : dynamic, 4)\n"}
        self.assertEqual(self.findings("schedule", tree), ["kernels/a.cpp:1", "kernels/a.cpp:2"])

    def test_paths_of_one_machine_are_found(self):
        bad = "cd /home/ada/x\nopen('/tmp/x')\nsee /work\n"
        good = "build/tmp/x\n${TMPDIR}/tmp\n/usr/lib/llvm-19/lib\nhttps://example.org/home/\n#!/usr/bin/env bash\n"
        self.assertEqual(self.findings("paths", {"scripts/a": bad, "docs/b.md": good}),
                         ["scripts/a:1", "scripts/a:2", "scripts/a:3"])

    def test_temporary_folders_of_tests_come_from_the_helper(self):
        tree = {"tests/a.cpp": 'TempDir() + "a"\nx = std::filesystem::temp_directory_path();\ntest_folder("a");\n',
                "tests/temporary_folder.hpp": "mkdtemp(name);\n", "host/b.cpp": "mkdtemp(name);\n",
                "tests/b.py": "open(tempfile.gettempdir() + '/x')\ntempfile.TemporaryDirectory()\n"}
        self.assertEqual(self.findings("temporary", tree), ["tests/a.cpp:1", "tests/a.cpp:2", "tests/b.py:1"])

    def test_marks_of_unfinished_work_are_found(self):
        tree = {"host/a.cpp": "// TODO later\nint x;  // FIXME\n", "docs/b.md": "mktemp XXXX, TODOS, todo\n"}
        self.assertEqual(self.findings("unfinished", tree), ["host/a.cpp:1", "host/a.cpp:2"])

    def test_build_products_and_results_are_not_looked_at(self):
        tree = {"build/x.cpp": "// TODO", "build-other/y.md": "TODO", "host/a.cpp": "",
                "result_bar/summary.json": "TODO"}
        self.assertEqual(self.findings("unfinished", tree), [])

    def test_exit_code_tells_clean_faulty_and_misspelt_apart(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()) as out:
            (pathlib.Path(folder) / "a.md").write_text("fine\n")
            self.assertEqual(source_rules.main(folder, "unfinished"), 0)
            (pathlib.Path(folder) / "a.md").write_text("TODO\n")
            self.assertEqual(source_rules.main(folder, "unfinished"), 1)
            self.assertIn("a.md:1", out.getvalue())
            with contextlib.redirect_stderr(io.StringIO()):
                self.assertEqual(source_rules.main(folder, "unfinishd"), 2)


class FormatCheck(unittest.TestCase):
    """scripts/format --check, run on a copy of itself beside one file."""

    def check(self, text):
        root = pathlib.Path(__file__).resolve().parents[2]
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder)
            for name in ("common", "kernels", "device", "host", "bench", "tests", "scripts"):
                (copy / name).mkdir()
            (copy / ".clang-format").write_text((root / ".clang-format").read_text())
            (copy / "scripts/format").write_text((root / "scripts/format").read_text())
            (copy / "host/a.cpp").write_text(text)
            result = subprocess.run(["bash", copy / "scripts/format", "--check"], capture_output=True, text=True)
        if result.returncode == 77:
            self.skipTest(result.stderr)
        return result

    def test_formatted_file_passes(self):
        self.assertEqual(self.check("int main() {\n  return 0;\n}\n").returncode, 0)

    def test_unformatted_file_fails_and_is_named(self):
        result = self.check("int main(  ) {return 0;}\n")
        self.assertNotEqual(result.returncode, 0)
        self.assertIn("host/a.cpp:1", result.stderr)


if __name__ == "__main__":
    sys.exit(unittest.main())
