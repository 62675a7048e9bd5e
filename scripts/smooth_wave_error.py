#!/usr/bin/python3
"""Relative L2 error of the displacement at the last snapshot of examples/smooth_wave_bar.toml.

usage: scripts/smooth_wave_error.py RESULT_FOLDER

Exact solution until the waves meet (56 ns): u_x = -V R(t - x/c) + V R(t - (L - x)/c), R the integral of the quintic ramp.
"""
import glob
import math
import sys

import h5py
import numpy as np

DENSITY, MODULUS, POISSON, SPEED, RAMP, LENGTH = 3690.0, 260e9, 0.21, 6.1, 20e-9, 1e-3


def ramp_integral(s):
    q = np.clip(s / RAMP, 0, 1)
    return RAMP * (q**6 - 3 * q**5 + 2.5 * q**4) + np.maximum(s - RAMP, 0)


def exact(x, time):
    lam = MODULUS * POISSON / ((1 + POISSON) * (1 - 2 * POISSON))
    wave = math.sqrt((lam + MODULUS / (1 + POISSON)) / DENSITY)
    return SPEED * (ramp_integral(time - (LENGTH - x) / wave) - ramp_integral(time - x / wave))


def main():
    files = sorted(glob.glob(sys.argv[1] + "/snapshot_*.vtkhdf"))
    if not files:
        sys.exit(f"{sys.argv[1]} holds no snapshot")
    grid = h5py.File(files[-1], "r")["VTKHDF"]
    points, found = grid["Points"][:], grid["PointData/displacement"][:]
    time = float(np.ravel(grid["FieldData/time"][:])[0])
    wanted = np.zeros_like(found)
    wanted[:, 0] = exact(points[:, 0], time)
    difference, size = ((found - wanted) ** 2).sum(1), (wanted**2).sum(1)
    connectivity, offsets = grid["Connectivity"][:], grid["Offsets"][:]
    above = below = 0.0
    for first, last in zip(offsets[:-1], offsets[1:]):
        corners = connectivity[first:last]
        x, y = points[corners, 0], points[corners, 1]
        area = 0.5 * abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1)))
        above += area * difference[corners].mean()
        below += area * size[corners].mean()
    print(f"{math.sqrt(above / below):.3e}")


main()
