"""plot_result.py WRITER SOURCE: scripts/plot.py draws every kind of picture, from geometry with known measures."""
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import h5py  # noqa: F401
    import matplotlib.image
    import numpy as np
except ImportError as error:
    print(f"skipped: {error}; install python3-numpy, python3-matplotlib and python3-h5py")
    sys.exit(77)

WRITER, SOURCE = sys.argv[1], Path(sys.argv[2])
sys.path.insert(0, str(SOURCE / "scripts"))
from plotting.cracks import Cracks, faces  # noqa: E402
from plotting.history import accounted, supplied  # noqa: E402
from plotting.line import element_polylines  # noqa: E402
from plotting.sequence import choose, page_columns  # noqa: E402
from plotting.snapshot import element_edges, read_snapshot, series, smooth_small_jumps  # noqa: E402
from plotting.space import cut_polygons, surface_faces  # noqa: E402
from plotting.spacetime import band_limits  # noqa: E402
from plotting.style import crack_style, si_scale  # noqa: E402
from plotting.tables import read_table  # noqa: E402

SIDE = 1e-3  # edge of the sample box [m]


def polygon_area(points):
    """Area of one planar polygon [corners, 3]."""
    return 0.5 * np.linalg.norm(sum(np.cross(a, b) for a, b in zip(points - points[0], np.roll(points - points[0], -1, 0))))


def check_close(name, value, expected):
    assert abs(value / expected - 1) < 1e-9, f"{name}: {value}, not {expected}"


def check_line(snapshot):
    path = element_polylines(snapshot)
    lengths = [np.ptp(snapshot.points[part[part >= 0], 0]) for part in np.split(path, np.flatnonzero(path < 0))]
    check_close("length of all elements", sum(lengths), SIDE)


def check_plane(snapshot):
    """Element borders enclose areas that add up: every inner edge is drawn twice, every outer one once."""
    corners = snapshot.points[snapshot.simplices()]
    check_close("area", sum(polygon_area(triangle) for triangle in corners), SIDE**2)
    edges = snapshot.points[element_edges(snapshot.cells)]
    outer = np.any((np.abs(edges[:, 0, :2] - edges[:, 1, :2]) < 1e-12) &
                   ((edges[:, 0, :2] < 1e-12) | (edges[:, 0, :2] > SIDE - 1e-12)), axis=1)
    check_close("outer edges", np.sum(np.linalg.norm(edges[outer, 0] - edges[outer, 1], axis=1)), 4 * SIDE)


def check_space(snapshot):
    area = sum(polygon_area(snapshot.points[face]) for faces in surface_faces(snapshot) for face in faces)
    check_close("surface of the cube", area, 6 * SIDE**2)
    polygons, values = cut_polygons(snapshot, 2, 0.47e-3, snapshot.fields["strain_energy_density"])
    check_close("cut of the cube", sum(polygon_area(polygon) for polygon in polygons), SIDE**2)
    assert len(values) == len(polygons) and np.all(values >= 0)


def check_helpers():
    points = np.array([[0, 0, 0], [0, 0, 0], [1, 0, 0], [1, 0, 0]], dtype=float)
    assert np.allclose(smooth_small_jumps(points, np.array([1.0, 1.2, 3.0, 9.0]), 0.5), [1.1, 1.1, 3, 9])
    assert si_scale([2.5e8], "Pa") == (1e-6, "MPa") and si_scale([0.0], "m") == (1.0, "m")


def check_faces_of_a_crack():
    """Two unit squares side by side, cut along x = 1: both borders on the crack are its faces, the others are not."""
    points = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [1, 0], [2, 0], [2, 1], [1, 1]], dtype=float)
    edges = np.array([[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]])
    chain = np.array([[1, 0, 0], [1, 0.25, 0], [1, 0.75, 0], [1, 1, 0], [3, 0, 0], [3, 1, 0]], dtype=float)
    lines, edge = np.array([[0, 1], [1, 2], [2, 3], [4, 5]]), np.array([0, 0, 0, 1])
    cracks = Cracks(chain, np.array([0.2, 0.2, 0.6, 0.6, 1, 1]), np.zeros(6), lines, edge)
    pairs, damage, without = faces(points, edges, cracks)
    assert sorted(map(tuple, np.sort(pairs, axis=1))) == [(1, 2), (4, 7)] and np.allclose(damage, 0.4)
    assert [list(chain) for chain in without] == [[4, 5]], "the chain outside has no face"


def check_page():
    assert choose(list(range(21)), 5) == [4, 8, 12, 16, 20] and choose([7, 8], 6) == [7, 8]
    assert page_columns(6, 0.2) == 2 and page_columns(6, 1.0) == 3 and page_columns(1, 1.0) == 1
    low, high = band_limits(np.array([0.0, 2.0, 3.0]))
    assert list(low) == [0, 1, 2.5] and list(high) == [1, 2.5, 3]


def check_crack_style():
    colours, widths = crack_style(np.array([0.0, 0.5, 0.9989, 0.999, 1.0]))
    black = np.all(colours[:, :3] == 0, axis=1)
    assert list(black) == [False, False, False, True, True] and np.all(np.diff(widths) > 0)


def check_cracked_plane(snapshot):
    """Both faces of the path between the regions are found over the whole width of the bar."""
    pairs, damage, without = faces(snapshot.points[:, :2], element_edges(snapshot.cells), snapshot.cracks)
    assert not without and np.all((damage > 0.99) & (damage <= 1))
    lines = snapshot.cracks.points[snapshot.cracks.lines]
    check_close("length of both faces", np.sum(np.linalg.norm(np.diff(snapshot.points[pairs], axis=1), axis=-1)),
                2 * np.sum(np.linalg.norm(np.diff(lines, axis=1), axis=-1)))


def check_picture(path):
    picture = matplotlib.image.imread(path)[..., :3]
    assert picture.std() > 0.02, f"{path.name} is blank"


def draw_cracked(dimension):
    """Pictures of a made-up crack; the history of the waves before it closes its balance."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        subprocess.run([WRITER, name, str(dimension), "2", "crack", "1"], check=True)
        last = read_snapshot(series(folder)[-1][0])
        assert len(last.cracks) > 0 and len(read_snapshot(series(folder)[2][0]).cracks) == 0
        if dimension == 2:
            check_cracked_plane(last)
        table = read_table(folder / "history.csv")
        error = np.abs(supplied(table) - accounted(table)) / supplied(table)[-1]
        assert np.max(error[table["time"] < 5.5e-8]) < 3e-3, np.max(error)
        arguments = ["--no-mesh", "--height", "none", "--sequence", "4"] if dimension == 2 else []
        subprocess.run([sys.executable, str(SOURCE / "scripts" / "plot.py"), name] + arguments, check=True)
        for picture in ("snapshot_0011.png", "history.png", "sequence.png" if dimension == 2 else "spacetime.png"):
            check_picture(folder / picture)


def main():
    check_helpers()
    check_faces_of_a_crack()
    check_page()
    check_crack_style()
    for dimension in (1, 2):
        draw_cracked(dimension)
    checks = {1: check_line, 2: check_plane, 3: check_space}
    for dimension in (1, 2, 3):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            subprocess.run([WRITER, name, str(dimension), "2", "quadratic", "1"], check=True)
            checks[dimension](read_snapshot(series(folder)[2][0]))
            extra = ["--animate"] if dimension == 1 else ["--time", "4e-8"]
            if dimension == 2:
                extra += ["--deformation", "100", "--height", "vx"]
            subprocess.run([sys.executable, str(SOURCE / "scripts" / "plot.py"), name] + extra, check=True)
            expected = ["history.png", "probe_middle.png", "probe_corner.png",
                        "snapshot_0005.png" if dimension == 1 else "snapshot_0002.png"]
            for picture in expected:
                check_picture(folder / picture)
            assert (folder / "animation.gif").exists() == (dimension == 1)


if __name__ == "__main__":
    main()
