"""plot_test.py SOURCE: scripts/plot.py draws what is there, and says in a sentence what it cannot draw."""
import contextlib
import io
import itertools
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

SOURCE = Path(sys.argv[1])
try:
    import h5py
    import matplotlib.image
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}; install python3-numpy, python3-matplotlib and python3-h5py")
    sys.exit(77)
sys.path.insert(0, str(SOURCE / "scripts"))
import plot  # noqa: E402
from canned_pictures import write_result  # noqa: E402
from plotting.quantity import choose_quantity  # noqa: E402
from plotting.sequence import panel_name  # noqa: E402
from plotting.snapshot import read_snapshot  # noqa: E402
from plotting.style import plt  # noqa: E402
from plotting.text import PlotError, pictured, printable  # noqa: E402

plt.rcParams["savefig.dpi"] = 25  # what is drawn is all one here
FIELDS = ("displacement", "velocity", "stress", "strain_energy_density")


class PlotTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name) / "r"

    def plot(self, *arguments):
        """Draws the folder; the names of the pictures, and what went to stderr."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            plot.draw_folder(plot.parse_arguments([str(self.folder), *map(str, arguments)]))
        pictures = [Path(line) for line in out.getvalue().splitlines()]
        for picture in pictures:
            self.assertGreater(picture.stat().st_size, 0)
        return {picture.name for picture in pictures}, err.getvalue()

    def refused(self, *arguments):
        """The sentence; nothing is left behind."""
        with self.assertRaises(PlotError) as raised:
            self.plot(*arguments)
        self.assertEqual([path.name for path in self.folder.glob("*.partial")], [])
        self.assertNotIn("\n", str(raised.exception))
        return str(raised.exception)


class Fields(PlotTest):
    def test_every_choice_of_fields_makes_a_picture(self):
        for number in range(len(FIELDS) + 1):
            for fields in itertools.combinations(FIELDS, number):
                with self.subTest(fields=fields), tempfile.TemporaryDirectory() as name:
                    self.folder = write_result(Path(name) / "r", 2, fields, num_snapshots=1, rows=None)
                    self.assertEqual(self.plot()[0], {"snapshot_0000.png"})

    def test_one_field_alone_is_drawn_in_any_dimension(self):
        for dimension in (1, 3):
            for field in FIELDS:
                with self.subTest(dimension=dimension, field=field), tempfile.TemporaryDirectory() as name:
                    self.folder = write_result(Path(name) / "r", dimension, [field], num_snapshots=1, rows=None)
                    self.assertEqual(self.plot()[0], {"snapshot_0000.png"})

    def test_bar_without_fields_has_no_picture_and_the_note_says_which_to_add(self):
        write_result(self.folder, 1, [])
        pictures, err = self.plot("--animate")
        self.assertEqual(pictures, {"history.png", "probe_mid.png"})
        self.assertIn("add displacement, velocity, stress or strain_energy_density to [output] fields", err)

    def test_energy_density_comes_from_stress_and_displacement(self):
        for dimension in (1, 2, 3):
            write_result(self.folder, dimension, ["displacement", "stress"], num_snapshots=1)
            snapshot = read_snapshot(self.folder / "snapshot_0000.vtkhdf")
            quantity = choose_quantity(snapshot)
            self.assertEqual((quantity.label, quantity.unit), ("strain energy density", "J/m³"))
            write_result(self.folder, dimension, num_snapshots=1)
            energy = read_snapshot(self.folder / "snapshot_0000.vtkhdf").fields["strain_energy_density"]
            np.testing.assert_allclose(quantity.values(snapshot), energy, rtol=1e-12)

    def test_equivalent_stress_of_shear_is_sqrt_3_times_the_shear(self):
        write_result(self.folder, 2, ["stress"], num_snapshots=1)
        snapshot = read_snapshot(self.folder / "snapshot_0000.vtkhdf")
        snapshot.fields["stress"][:] = [5, 5, 5, 2, 0, 0]  # and pressure, which does not count
        quantity = choose_quantity(snapshot)
        self.assertEqual(quantity.label, "equivalent stress")
        np.testing.assert_allclose(quantity.values(snapshot), 2 * np.sqrt(3))

    def test_option_that_needs_a_missing_field_is_refused(self):
        write_result(self.folder, 2, ["stress"])
        self.assertIn("needs the fields displacement; add them to [output] fields", self.refused("--deformation", 10))
        self.assertIn("needs the fields velocity", self.refused("--height", "vx"))

    def test_values_that_are_not_finite_are_drawn_as_zero_and_counted(self):
        for dimension in (1, 2, 3):
            write_result(self.folder, dimension)
            with h5py.File(self.folder / "snapshot_0001.vtkhdf", "a") as file:
                for name, bad in zip(FIELDS, (np.nan, np.inf, np.nan, -np.inf)):
                    file[f"VTKHDF/PointData/{name}"][1] = bad
            text = (self.folder / "history.csv").read_text().replace(",2e-06,", ",nan,").replace(",1e-06,", ",inf,")
            (self.folder / "history.csv").write_text(text)
            err = self.plot()[1]
            if dimension == 1:  # each note is said once
                self.assertIn("snapshot_0001.vtkhdf: 3 values of displacement are not finite and drawn as 0", err)


class Folders(PlotTest):
    def test_body_at_rest_has_all_pictures(self):
        for dimension, others in ((1, {"spacetime.png"}), (2, {"sequence.png"}), (3, set())):
            with self.subTest(dimension=dimension), tempfile.TemporaryDirectory() as name:
                self.folder = write_result(Path(name) / "r", dimension, scale=0.0)
                self.assertEqual(self.plot()[0], {"snapshot_0001.png", "history.png", "probe_mid.png"} | others)

    def test_last_line_that_is_cut_off_is_left_out(self):
        write_result(self.folder, 1)
        for name in ("history.csv", "probe_mid.csv"):
            path = self.folder / name
            path.write_text(path.read_text()[:-7])
        pictures, err = self.plot()
        self.assertIn("history.png", pictures)
        self.assertIn("history.csv: the last line is cut off and left out\n", err)

    def test_run_that_was_stopped_before_its_first_snapshot_has_its_energies(self):
        write_result(self.folder, 2, num_snapshots=0, rows=1)
        (self.folder / "summary.json").unlink()
        self.assertEqual(self.plot()[0], {"history.png", "probe_mid.png"})
        write_result(self.folder, 2, num_snapshots=0, rows=0)
        for path in self.folder.glob("*.png"):
            path.unlink()
        pictures, err = self.plot()
        self.assertEqual(pictures, set())
        self.assertIn("history.csv: there is no row yet", err)

    def test_folder_without_a_result_is_refused(self):
        self.assertIn("no such folder", self.refused())
        self.folder.mkdir()
        self.assertIn("there is nothing to draw", self.refused())

    def test_folder_of_another_user_is_refused_before_anything_is_drawn(self):
        write_result(self.folder, 1)
        with mock.patch("os.access", return_value=False):
            self.assertIn("this folder cannot be written to", self.refused())

    def test_folder_that_cannot_be_entered_is_refused(self):
        write_result(self.folder, 1)
        self.folder.parent.chmod(0)
        is_root = os.geteuid() == 0
        try:
            if is_root:  # who may enter any folder
                os.seteuid(65534)
            with self.assertRaisesRegex(PlotError, "this folder cannot be entered"):
                plot.draw_folder(plot.parse_arguments([str(self.folder)]))
        finally:
            if is_root:
                os.seteuid(0)
            self.folder.parent.chmod(0o700)

    def test_picture_that_cannot_be_written_is_named(self):
        write_result(self.folder, 1, num_snapshots=1)
        (self.folder / "snapshot_0000.png").mkdir()
        self.assertIn("snapshot_0000.png: the picture cannot be written (Is a directory)", self.refused())

    def test_damaged_files_are_named(self):
        damages = [("snapshot_0001.vtkhdf", b"noise", "cannot be read as a snapshot"),
                   ("snapshot_0001.vtkhdf", None, "cannot be read as a snapshot"),
                   ("snapshot.vtkhdf.series", b'{"files": [', "cannot be read as a list of snapshots"),
                   ("snapshot.vtkhdf.series", b'{"files": 3}', "cannot be read as a list of snapshots"),
                   ("cracks_0001.vtkhdf", b"noise", "cannot be read as cracks"),
                   ("history.csv", b"time,kinetic\n1,2\n", "there is no column strain"),
                   ("history.csv", b"time,a\n1\n2,3\n", "line 2: 1 columns instead of 2"),
                   ("history.csv", b"time,a\n1,\xff\n", "an entry is no number"),
                   ("probe_mid.csv", b"a,b\n1,2\n", "there is no column time")]
        for name, content, sentence in damages:
            with self.subTest(name=name, content=content), tempfile.TemporaryDirectory() as parent:
                is_table = name.endswith(".csv")
                self.folder = write_result(Path(parent) / "r", 1, num_snapshots=0 if is_table else 2, cracks=[])
                (self.folder / name).unlink()
                if content is not None:
                    (self.folder / name).write_bytes(content)
                refusal = self.refused()
                self.assertIn(name, refusal)
                self.assertIn(sentence, refusal)

    def test_summary_that_is_damaged_costs_the_title_only(self):
        for content in ("{", "[]", '{"title": 3}', '{"title": null, "dimension": "x"}'):
            write_result(self.folder, 1, ["displacement"], num_snapshots=1, rows=None)
            (self.folder / "summary.json").write_text(content)
            self.plot()

    def test_cracks_may_be_none_or_some(self):
        for dimension, crack in ((1, [[0.5, 0, 0]]), (2, [[1 / 3, 0, 0], [1 / 3, 0.25, 0], [1 / 3, 0.5, 0]])):
            for cracks in ([], crack):
                with self.subTest(dimension=dimension, cracks=cracks), tempfile.TemporaryDirectory() as name:
                    self.folder = write_result(Path(name) / "r", dimension, cracks=cracks, rows=None)
                    self.assertIn("snapshot_0001.png", self.plot()[0])

    def test_slim_body_has_a_page_of_ordinary_size(self):
        for sides in ((1, 1e-4), (1e-4, 1)):
            with self.subTest(sides=sides), tempfile.TemporaryDirectory() as name:
                self.folder = write_result(Path(name) / "r", 2, sides=sides, rows=None)
                self.plot()
                for picture in ("snapshot_0001.png", "sequence.png"):
                    height, width, _ = matplotlib.image.imread(self.folder / picture).shape
                    self.assertLess(max(height, width) / 25, 80)  # inches


class Texts(PlotTest):
    TITLES = ["$", "$x$ costs 5 $", r"\$\alpha_{", "a\x1b[31mb\nc", "Bruch 破壊 كسر 🙂", "x" * 100000, "\ud800", "  "]

    def test_any_title_is_drawn(self):
        write_result(self.folder, 1, num_snapshots=1, rows=None)
        for title in self.TITLES:
            with self.subTest(title=title[:20]):
                with mock.patch("plot.read_summary", return_value={"title": title}):
                    self.plot()
                height, width, _ = matplotlib.image.imread(self.folder / "snapshot_0000.png").shape
                self.assertLess(width / 25, 20)
                (self.folder / "snapshot_0000.png").unlink()

    def test_printable_is_one_line_without_escapes(self):
        self.assertEqual(printable("a\x1b[31mb\nc\t\x7f\x9b\u202e"), r"a\x1b[31mb\nc\t\x7f\u009b\u202e")
        self.assertEqual(printable("Bruch 破壊 50 % \\ $"), "Bruch 破壊 50 % \\ $")
        self.assertEqual(printable("\udcff"), r"\xff")  # a byte of a file name
        self.assertEqual(pictured("5 $"), r"5 \$")
        self.assertEqual(len(pictured("x" * 1000)), 120)

    def test_names_reach_the_terminal_without_escapes(self):
        self.folder = self.folder.with_name("r\x1b[2J\nx")
        write_result(self.folder, 1, num_snapshots=1)
        (self.folder / "probe_mid.csv").rename(self.folder / "probe_\x1b[7m.csv")
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            plot.draw_folder(plot.parse_arguments([str(self.folder)]))
        self.assertNotIn("\x1b", out.getvalue() + err.getvalue())
        self.assertIn(r"r\x1b[2J\nx/probe_\x1b[7m.png", out.getvalue())


class Arguments(PlotTest):
    def test_numbers_are_finite_and_moments_fit_on_a_page(self):
        for arguments in (["--time", "nan"], ["--deformation", "inf"], ["--sequence", "1000000"], ["--sequence", "-1"]):
            with self.subTest(arguments=arguments), contextlib.redirect_stderr(io.StringIO()) as err:
                with self.assertRaises(SystemExit):
                    plot.parse_arguments(["r", *arguments])
                self.assertRegex(err.getvalue(), r"must (be finite|lie in \[0, 60\])")

    def test_panels_are_named_beyond_z(self):
        self.assertEqual([panel_name(index) for index in (0, 25, 26, 59)], ["a", "z", "aa", "bh"])

    def test_missing_packages_are_named(self):
        result = subprocess.run([sys.executable, "-S", "-E", SOURCE / "scripts/plot.py", "r"], capture_output=True, text=True)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, r"^plot: No module named .*; install python3-numpy, .*\n$")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
