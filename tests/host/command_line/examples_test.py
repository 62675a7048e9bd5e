"""Each example runs, and its known number holds to the tolerance stated here."""
import math
import subprocess

import h5py
import numpy

from program import SOURCE, ProgramTest, main


class Examples(ProgramTest):
    def run_example(self, name, *arguments, out="r", balance=1e-12):
        self.tentpole("run", SOURCE / f"examples/{name}.toml", "--quiet", "--out", out, *arguments)
        summary = self.summary(out)
        energy = summary["energy"]
        largest = max(abs(energy[name]) for name in ("initial", "external_work", "kinetic", "strain"))
        self.assertLess(abs(energy["balance_error"]), balance * largest)
        self.assertGreaterEqual(energy["numerical"], 0)
        return summary

    def relative_error(self, *arguments, **options):
        return self.run_example(*arguments, **options)["errors"]["displacement_l2_relative"]

    def between(self, path, column, first, last):
        """Values of a probe column in a time range; there is at least one."""
        values = [row[column] for row in self.table(path) if first <= row["time"] <= last]
        self.assertTrue(values)
        return values

    def test_plane_wave_1d_converges_with_order_four(self):
        coarse = self.relative_error("plane_wave_1d")
        fine = self.relative_error("plane_wave_1d", "--set", "domain.cells=[64]", out="fine")
        self.assertAlmostEqual(coarse, 3.5e-6, delta=0.2e-6)
        self.assertGreater(math.log2(coarse / fine), 3.8)

    def test_plane_waves_2d_converge_with_order_four(self):
        coarse = self.relative_error("plane_waves_2d", "--set", "domain.cells=[4,4]", out="coarse")
        fine = self.relative_error("plane_waves_2d")
        self.assertAlmostEqual(fine, 2.1e-4, delta=0.1e-4)
        self.assertGreater(math.log2(coarse / fine), 3.7)

    def test_plane_waves_3d_gain_a_factor_with_each_degree(self):
        for degree, expected in ((2, 5.8e-2), (3, 8.8e-3)):
            error = self.relative_error("plane_waves_3d", "--set", f"discretization.degree={degree}", out=f"r{degree}")
            self.assertAlmostEqual(error, expected, delta=0.05 * expected)

    def test_thesis_bar_carries_rho_c_v_and_doubles_it_at_the_centre(self):
        self.run_example("thesis_bar")
        modulus = 260e9 * (1 - 0.21) / ((1 + 0.21) * (1 - 2 * 0.21))
        stress = math.sqrt(3690 * modulus) * 6.1
        self.assertAlmostEqual(stress, 200.5e6, delta=0.1e6)
        for value in self.between("r/probe_quarter.csv", "sxx", 4.0e-8, 7.0e-8):
            self.assertAlmostEqual(value, stress, delta=0.03 * stress)
        for value in self.between("r/probe_mid.csv", "sxx", 7.0e-8, 1.0e-7):
            self.assertAlmostEqual(value, 2 * stress, delta=0.02 * 2 * stress)
        # Nothing but an oscillation ahead of the front arrives at the centre before 0.5 mm / c_p = 56.1 ns.
        arrival = 0.5e-3 / math.sqrt(modulus / 3690)
        for value in self.between("r/probe_mid.csv", "sxx", 0, arrival - 5e-9):
            self.assertLess(abs(value), 0.1 * stress)

    def test_spall_bar_nucleates_only_after_the_waves_have_met(self):
        # One wave of 200.5 MPa breaks nothing (weakest defect 220 MPa); at 56.1 ns they meet and the stress doubles.
        before = self.run_example("spall_bar", "--set", "time.end=5.5e-8", "--set", "output.snapshots=1")
        self.assertEqual(before["fracture"]["nucleations"], 0)
        after = self.run_example("spall_bar", "--set", "time.end=6.1e-8", "--set", "output.snapshots=1", out="after")
        self.assertGreater(after["fracture"]["nucleations"], 0)
        self.assertLess(after["counts"]["rejected"], 0.15 * after["counts"]["patches"])

    def test_spall_plate_takes_the_work_of_waves_from_four_edges(self):
        # rho c_p v^2 on four edges of 1 mm; the ramp of 2 ns counts as 2 ns times the mean of its square, 13/35.
        energy = self.run_example("spall_plate", "--set", "time.end=5e-9", "--set", "domain.cells=[10,10]", "--set",
                                  "output.snapshots=1")["energy"]
        speed = math.sqrt(260e9 / (1 - 0.21**2) / 3690)
        work = 4e-3 * 3690 * speed * 6.1**2 / 2 * (3e-9 + 2e-9 * 13 / 35)
        self.assertAlmostEqual(energy["external_work"], work, delta=0.05 * work)

    def test_crack_under_step_wave_has_freunds_stress_intensity(self):
        self.run_example("crack_under_step_wave", "--set", "adaptivity.error_tolerance=1e-6", "--set",
                         "adaptivity.min_size=0.03", "--set", "output.times=[4.01]", balance=3e-12)
        with h5py.File(self.folder / "r/cracks_0000.vtkhdf") as cracks:
            distance = -cracks["VTKHDF/Points"][:, 0]
            opening = cracks["VTKHDF/PointData/opening"][:]
        near = (distance > 0.06) & (distance < 0.4)
        apparent = opening[near] * 0.8333333333333334 / (8 * (1 - 0.25**2)) / numpy.sqrt(distance[near] / (2 * math.pi))
        intensity = numpy.polyfit(distance[near], apparent, 1)[1]
        exact = 2 * math.sqrt(2.0 * (1 - 2 * 0.25) / math.pi) / (1 - 0.25)
        self.assertAlmostEqual(intensity, exact, delta=0.06 * exact)

    def test_two_material_reflection_gives_the_impedance_coefficients(self):
        self.run_example("two_material_reflection")
        soft = self.between("r/probe_soft.csv", "sxx", 0.0, 0.5)
        reflected = self.between("r/probe_soft.csv", "sxx", 0.5, 1.0)
        transmitted = self.between("r/probe_stiff.csv", "sxx", 0.0, 1.0)
        self.assertAlmostEqual(max(soft), 1.0, delta=0.005)
        self.assertAlmostEqual(max(reflected), 0.6, delta=0.005)
        self.assertAlmostEqual(max(transmitted), 1.6, delta=0.005)

    def test_box_3d_moves_at_pressure_over_impedance(self):
        self.run_example("box_3d")
        modulus = 210e9 * 0.7 / (1.3 * 0.4)
        velocity = 100e6 / math.sqrt(7850 * modulus)
        for value in self.between("r/probe_mid.csv", "vx", 1.8e-5, 2.5e-5):
            self.assertAlmostEqual(value, velocity, delta=0.01 * velocity)
        for value in self.between("r/probe_mid.csv", "sxx", 1.8e-5, 2.5e-5):
            self.assertAlmostEqual(value, -100e6, delta=1e6)

    def test_smooth_wave_bar_has_the_error_that_it_names(self):
        if subprocess.run(["/usr/bin/python3", "-c", "import h5py"], capture_output=True).returncode != 0:
            self.skipTest("the system's Python has no h5py")
        self.run_example("smooth_wave_bar")
        result = subprocess.run(["/usr/bin/python3", "-B", SOURCE / "scripts/smooth_wave_error.py", self.folder / "r"],
                                capture_output=True, text=True, check=True)
        self.assertAlmostEqual(float(result.stdout), 1.2e-4, delta=0.05e-4)

    def test_every_example_is_tested_here(self):
        tested = {name for name in dir(self) if name.startswith("test_")}
        for example in (SOURCE / "examples").glob("*.toml"):
            self.assertTrue(any(name.startswith("test_" + example.stem) for name in tested), example.name)


if __name__ == "__main__":
    main()
