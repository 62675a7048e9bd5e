"""`check` refuses what `run` refuses before its first patch: same message, exit code 2, and nothing is written."""
import shutil

from program import SOURCE, ProgramTest, main

BAR = """[domain]
dimension = 1
min = [0.0]
max = [1.0]
cells = [20]
[material.all]
density = 1.0
youngs_modulus = 1.0
poisson_ratio = 0.0
[boundary.left]
traction = ["0"]
[boundary.right]
traction = ["0"]
[time]
end = 0.5
[discretization]
degree = 2
"""

# The unit square of tests/host/mesh.
SQUARE = """[domain]
dimension = 2
mesh = "square.msh"
[material.all]
density = 1.0
youngs_modulus = 1.0
poisson_ratio = 0.0
[boundary.left]
absorbing = true
[boundary.right]
absorbing = true
[boundary.bottom]
absorbing = true
[boundary.top]
absorbing = true
[time]
end = 0.5
[discretization]
degree = 2
"""

FRACTURE = """[fracture]
enabled = true
threshold = 1e9
strength = 2e9
relaxation_time = 1.0
process_zone_size = 1000.0
"""

DEFECTS = FRACTURE + """[fracture.nucleation]
model = "MODEL"
density = 1e24
minimum = 1e8
distribution = "weibull"
weibull_modulus = 3
weibull_scale = 1e9
"""

ADAPTIVITY = "[adaptivity]\nenabled = true\nerror_tolerance = 1e-3\nmin_size = 1e-14\n"


class Refusal(ProgramTest):
    def setUp(self):
        super().setUp()
        shutil.copy(SOURCE / "tests/host/mesh/square_41.msh", self.folder / "square.msh")

    def both_refuse(self, text, *arguments):
        """What both commands say."""
        (self.folder / "case.toml").write_text(text)
        message = self.refused("check", "case.toml", *arguments)
        self.assertEqual(self.refused("run", "case.toml", *arguments), message)
        return message

    def both_accept(self, text):
        (self.folder / "case.toml").write_text(text)
        self.tentpole("check", "case.toml")
        self.tentpole("run", "case.toml", "--quiet")

    def test_probe_outside_the_domain_of_a_mesh_file(self):
        probes = '[[output.probe]]\nname = "in"\npoint = [0.5, 0.5]\n[[output.probe]]\nname = "out"\npoint = [1.1, 0.5]\n'
        self.assertEqual(self.both_refuse(SQUARE + probes),
                         "case.toml:25: output.probe[2].point = [1.1, 0.5]: lies in no cell of the mesh. "
                         "Give a point inside the domain.\n")

    def test_probe_on_the_boundary_of_a_mesh_file_is_inside(self):
        self.both_accept(SQUARE + '[[output.probe]]\nname = "corner"\npoint = [1.0, 1.0]\n')

    def test_crack_outside_the_domain_of_a_mesh_file(self):
        message = self.both_refuse(SQUARE + FRACTURE + "[[fracture.crack]]\npoints = [[0.5, 0.5], [0.5, 1.5]]\ndamage = 1\n")
        self.assertIn("case.toml:27: fracture.crack[1].points = ", message)
        self.assertIn("crack 1 at (0.5, 1.5) m lies outside the domain", message)

    def test_expressions_that_are_not_finite_from_the_start(self):
        for section, key in (("initial", "velocity"), ("initial", "displacement"), ("body_force", "acceleration"),
                             ("exact", "displacement")):
            with self.subTest(section=section, key=key):
                message = self.both_refuse(BAR + f"[{section}]\n{key} = ['1/(x-x)']\n")
                self.assertRegex(message, rf"^case.toml:19: {section}.{key}\[1\] = \"1/\(x-x\)\": is inf at \(x, y, z\) = ")
        load = BAR.replace('[boundary.left]\ntraction = ["0"]', '[boundary.left]\ntraction = ["log10(-x-1)"]')
        self.assertIn("boundary.left.traction[1]", self.both_refuse(load))

    def test_expression_that_is_finite_inside_elements_only(self):
        self.both_accept(BAR.replace('[boundary.left]\ntraction = ["0"]', '[boundary.left]\ntraction = ["sin(t)/t"]'))

    def test_numbers_whose_products_are_none(self):
        for key, value in (("domain.max", "[1e-310]"), ("material.all.density", "1e-300"), ("time.end", "1e300"),
                           ("material.all.youngs_modulus", "1e308"), ("time.end", "1e-320")):
            message = self.both_refuse(BAR, "--set", f"{key}={value}")
            self.assertIn("must be 0 or of a size from 1e-100 to 1e100, and", message)

    def test_time_that_takes_more_tents_than_there_can_be(self):
        message = self.both_refuse(BAR, "--set", "time.end=1e90")
        self.assertRegex(message, r"time.end = 1e\+90: takes about 4.42105e\+92 tents, .* Give an earlier end")
        self.assertIn("front.causality is 1e-50", self.both_refuse(BAR, "--set", "front.causality=1e-50"))

    def test_more_defects_in_a_cell_than_can_be_searched(self):
        for model in ("field", "sampled"):
            message = self.both_refuse(BAR + DEFECTS.replace("MODEL", model))
            self.assertIn("fracture.nucleation.density = 1e+24: makes a search through about ", message)

    def test_cells_smaller_than_coordinates_can_tell(self):
        self.assertIn("adaptivity.min_size = 1e-14: is less than 1e-12 of the domain", self.both_refuse(BAR + ADAPTIVITY))

    def test_device_that_is_not_there(self):
        self.both_refuse(BAR, "--device", "999")


if __name__ == "__main__":
    main()
