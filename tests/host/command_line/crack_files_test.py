"""Crack files and history hold what is true at the time of their label, whatever the front looks like then: two halves of
a body part at constant velocity, which the solution follows exactly.

usage: crack_files_test.py TENTPOLE SOURCE_FOLDER
"""
import h5py
import numpy

import program

TIMES = [0.05, 0.313, 0.77, 1.0]

CASE = """[domain]
dimension = {dimension}
min = {low}
max = {high}
cells = {cells}
[material.all]
density = 1.0
youngs_modulus = 1.0
poisson_ratio = 0.21
{sides}
[initial]
velocity = {velocity}
[time]
end = 1.0
[discretization]
degree = 2
[adaptivity]
enabled = true
error_tolerance = 1e-3
min_size = 0.02
[fracture]
enabled = true
threshold = 1e3
strength = 2e3
relaxation_time = 100.0
[[fracture.crack]]
{crack}
[output]
times = {times}
history_interval = 0.01
"""


class CrackFilesTest(program.ProgramTest):
    def run_parting_halves(self, dimension, **settings):
        free = "[boundary.{}]\ntraction = {}\n"
        names = ["left", "right", "bottom", "top"][:2 * dimension]
        sides = "".join(free.format(name, ["0"] * dimension).replace("'", '"') for name in names)
        text = CASE.format(dimension=dimension, sides=sides, times=TIMES, **settings)
        (self.folder / "parting.toml").write_text(text)
        self.tentpole("run", "parting.toml", "--out", "r", "--quiet")

    def crack_file(self, index):
        """Time, points [num_points, 3], opening and damage at them."""
        with h5py.File(self.folder / f"r/cracks_{index:04d}.vtkhdf") as file:
            data = file["VTKHDF"]
            return (float(data["FieldData/time"][0]), data["Points"][:], data["PointData/opening"][:],
                    data["PointData/damage"][:])

    def test_the_halves_of_a_bar_part_by_velocity_times_time(self):
        self.run_parting_halves(1, low=[0.0], high=[2.0], cells=[7], velocity='["x < 1 ? -0.01 : 0.05"]',
                                crack="points = [[1.0]]\ndamage = 1.0")
        for index, wanted_time in enumerate(TIMES):
            time, points, opening, damage = self.crack_file(index)
            self.assertEqual(time, wanted_time)
            self.assertEqual(points[:, 0].tolist(), [1.0])
            self.assertAlmostEqual(opening[0], 0.06 * time, delta=1e-12)
            self.assertEqual(damage.tolist(), [1.0])
        self.assertEqual({row["crack_length"] for row in self.table("r/history.csv")}, {1.0})

    def test_the_halves_of_a_plate_part_by_velocity_and_spin_times_time(self):
        self.run_parting_halves(2, low=[0.0, 0.0], high=[2.0, 0.5], cells=[8, 2], crack="points = [[1.0, 0.0], [1.0, 0.5]]\ndamage = 1.0",
                                velocity='["x < 1 ? 0 : 0.05-0.04*y", "x < 1 ? 0 : 0.04*(x-1)"]')
        for index, wanted_time in enumerate(TIMES):
            time, points, opening, damage = self.crack_file(index)
            self.assertEqual(time, wanted_time)
            with h5py.File(self.folder / f"r/cracks_{index:04d}.vtkhdf") as file:
                lines = file["VTKHDF/Connectivity"][:].reshape(-1, 2)
            lengths = numpy.abs(points[lines[:, 0], 1] - points[lines[:, 1], 1])
            self.assertAlmostEqual(lengths.sum(), 0.5, delta=1e-12)
            # Each chain ends with the value of its nearest Gauss point.
            inner = self.inner_points(lines)
            wanted = (0.05 - 0.04 * points[inner, 1]) * time
            self.assertLess(numpy.abs(opening[inner] - wanted).max(), 1e-12)
            self.assertLess(numpy.abs(damage - 1).max(), 1e-15)
        for row in self.table("r/history.csv"):
            self.assertAlmostEqual(row["crack_length"], 0.5, delta=1e-12)
            self.assertAlmostEqual(row["damage_mean"], 1, delta=1e-12)

    def inner_points(self, lines):
        """Points that two lines share: the Gauss points."""
        numbers, counts = numpy.unique(lines, return_counts=True)
        inner = numbers[counts == 2]
        self.assertGreater(len(inner), 0)
        return inner


program.main()
