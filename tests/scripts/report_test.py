"""The report of scripts/reproduce_thesis from canned results.    usage: report_test.py TENTPOLE SOURCE_FOLDER

Exit code 77, skipped: matplotlib is not installed.
"""
import csv
import html.parser
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import canned_results

TENTPOLE, SOURCE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
EXHIBITS = [f"table_3_{i}" for i in range(1, 6)] + [f"figure_3_{i}" for i in range(1, 9)]


class Page(html.parser.HTMLParser):
    """What the page refers to, and its sections as text."""
    def __init__(self, text):
        super().__init__()
        self.references, self.sections, self.images, self.current = [], {}, {}, None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.references += [attributes[key] for key in ("src", "href") if key in attributes]
        if tag == "section":
            self.current = attributes["id"]
            self.sections[self.current], self.images[self.current] = "", 0
        self.images[self.current] = self.images.get(self.current, 0) + (tag == "img")

    def handle_data(self, data):
        if self.current:
            self.sections[self.current] += data.replace("\N{NO-BREAK SPACE}", " ") + "|"


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.folder = pathlib.Path(temporary.name)
        canned_results.write(cls.folder / "results")
        sys.path.insert(0, str(SOURCE / "scripts"))
        from report import drivers
        drivers.run_model(TENTPOLE, cls.folder / "results")
        draw(cls.folder)
        cls.text = (cls.folder / "index.html").read_text(encoding="utf-8")
        cls.page = Page(cls.text)

    def test_all_tables_and_figures_are_there_with_pictures(self):
        for name in EXHIBITS:
            self.assertIn(name, self.page.sections)
            self.assertGreater(self.page.images[name], 0, name)
            self.assertNotIn("has no result", self.page.sections[name])

    def test_page_needs_no_other_file_and_no_network(self):
        for reference in self.page.references:
            self.assertRegex(reference, r"^(data:image/png;base64,iVBOR|#)")
        self.assertNotIn("http", re.sub(r"base64,[A-Za-z0-9+/=]+", "", self.text))

    def test_patches_on_a_gpu_are_shown_where_there_is_one(self):
        self.assertNotIn("figure_3_9", self.page.sections)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            canned_results.write(folder / "results", ["bench_lu"])
            canned_results.write_gpu(folder / "results")
            draw(folder)
            section = Page((folder / "index.html").read_text(encoding="utf-8")).sections["figure_3_9"]
            self.assertIn("Whole patches on the GPU", section)
            rows = (folder / "figure_3_9.csv").read_text().splitlines()
            self.assertEqual(rows[1], "D,degree,patches,teams,lanes,patches/s,over host")
            self.assertIn("2,2,4096,2112,64,800000,16", rows)

    def test_every_part_has_csv_and_picture_and_is_either_measured_or_modelled(self):
        tables = sorted(self.folder.glob("*.csv"))
        self.assertGreaterEqual(len(tables), 16)
        for path in tables:
            self.assertRegex(path.read_text().splitlines()[0], r'^"?# (measured|modelled): ')
            self.assertTrue(path.with_suffix(".png").exists(), path)

    def test_thesis_numbers_stand_beside_ours(self):
        for name, text in (("table_3_1", "assembly [%]|69.88|70|measured"), ("table_3_4", "solution [%]|77.07|77|measured"),
                           ("figure_3_1", "speedup, k = 7|1.45|1.6|measured"), ("figure_3_4", "speedup on 60 threads|33.17|"),
                           ("figure_3_2", "12 threads|2.29|"), ("figure_3_6", "from 15 on|30|30|modelled"),
                           ("figure_3_5", "k = 7|–|4|measured")):
            self.assertIn(text, self.page.sections[name])
        self.assertIn("net, k = 7|10.6|9.6|measured", self.page.sections["ladder_3_3_1"])

    def test_figures_without_thesis_results_say_so(self):
        for name in ("table_3_5", "figure_3_7", "figure_3_8"):
            self.assertRegex(self.page.sections[name], "source (of the thesis )?ends before")

    def test_filtered_curve_has_balanced_counts_only(self):
        with open(self.folder / "figure_3_6.csv", encoding="utf-8") as stream:
            rows = list(csv.reader(stream))[2:]
        counts = [int(row[0]) for row in rows]
        self.assertEqual([p for p in range(1, 61) if 990 % p == 0 or 990 % p / p > 0.9], counts)

    def test_machine_compiler_and_commit_are_named(self):
        for text in ("clang &lt;19&gt;", "abc1234", "virtual_cpu: 2 threads"):
            self.assertIn(text, self.text)

    def test_stopped_driver_keeps_what_it_measured(self):
        from report import drivers
        with tempfile.TemporaryDirectory() as name:
            path = pathlib.Path(name) / "bench_lu.json"
            benchmarks = [{"name": "a", "real_time": 1}, {"name": "b", "real_time": 2}]
            whole = json.dumps({"context": {}, "benchmarks": benchmarks}, indent=2)
            for cut, kept in ((len(whole) - 9, 1), (whole.index('"a"'), 0)):
                path.write_text(whole[:cut])
                self.assertEqual(drivers.close_file(path), kept)
            self.assertFalse(path.exists())

    def test_missing_drivers_leave_a_reason(self):
        with tempfile.TemporaryDirectory() as name:
            canned_results.write(pathlib.Path(name) / "results", drivers=[])
            draw(pathlib.Path(name))
            page = Page((pathlib.Path(name) / "index.html").read_text(encoding="utf-8"))
        for name in EXHIBITS:
            self.assertIn("no result", page.sections[name])
            self.assertEqual(page.images[name], 0)


def draw(folder):
    subprocess.run([sys.executable, "-B", SOURCE / "scripts/reproduce_thesis", "--from-results", "--out", folder], check=True,
                   stdout=subprocess.DEVNULL)


if __name__ == "__main__":
    try:
        import matplotlib  # noqa: F401  (only whether it is there)
    except ImportError:
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
