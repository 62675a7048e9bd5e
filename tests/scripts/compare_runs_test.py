"""scripts/compare_runs: ratios, their ranges, and what is refused.    usage: compare_runs_test.py SOURCE_FOLDER"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(sys.argv[1]).resolve() / "scripts/compare_runs"


def entry(name, time, unit="ms", **more):
    return {"name": name, "run_name": name, "run_type": "iteration", "real_time": time, "time_unit": unit, **more}


class CompareRuns(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def compare(self, first, second, exit_code=0):
        for name, entries in (("a.json", first), ("b.json", second)):
            text = entries if isinstance(entries, str) else json.dumps({"context": {}, "benchmarks": entries})
            (self.folder / name).write_text(text)
        result = subprocess.run([sys.executable, SCRIPT, "a.json", "b.json"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(result.returncode, exit_code, result.stderr)
        return result.stdout if exit_code == 0 else result.stderr

    def test_ratio_of_medians_and_widest_range_across_units(self):
        out = self.compare([entry("x", 10), entry("x", 20), entry("x", 12)], [entry("x", 6e3, "us"), entry("x", 3e3, "us")])
        self.assertRegex(out, r"x +0\.375  0\.150\.\.0\.600  3, 2  faster\n")

    def test_range_with_one_is_no_difference(self):
        out = self.compare([entry("x", 10), entry("x", 12)], [entry("x", 11), entry("x", 13)])
        self.assertRegex(out, r"x +1\.091  0\.917\.\.1\.300  2, 2\n")

    def test_aggregates_and_failures_are_left_out_and_lonely_names_listed(self):
        out = self.compare([entry("x", 1), entry("x", 9, run_type="aggregate"), entry("y", 1, error_occurred=True)],
                           [entry("x", 2), entry("z", 1)])
        self.assertRegex(out, r"x +2\.000  2\.000\.\.2\.000  1, 1  slower\n")
        self.assertIn("only in b.json: z", out)
        self.assertNotIn("y", out.replace("only", ""))

    def test_files_without_common_names_are_refused(self):
        self.assertIn("no benchmark in common. A has, e.g., x, B y.", self.compare([entry("x", 1)], [entry("y", 1)], 2))

    def test_other_files_are_refused(self):
        for text in ("", "{}", "[1]", '{"benchmarks": [{"name": "x"}]}', '{"benchmarks": [{"real_time": "x", "name": "x"}]}'):
            self.assertIn("a.json: is no result file of Google Benchmark", self.compare(text, [entry("x", 1)], 2))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
