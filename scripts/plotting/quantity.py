"""What the colours of a picture of two or three dimensions show: the strain energy density, or what is there instead."""
from dataclasses import dataclass
from typing import Callable

import numpy as np

XX, YY, ZZ, XY, YZ, XZ = range(6)  # components of the field stress
PAIRS = {XX: (0, 0), YY: (1, 1), ZZ: (2, 2), XY: (0, 1), YZ: (1, 2), XZ: (0, 2)}


@dataclass
class Quantity:
    label: str
    unit: str
    values: Callable  # snapshot -> [num_points], not negative, SI
    needs: tuple = ()  # fields


def strain(snapshot):
    """sym grad u at the points [num_points, 3, 3]: u is linear on each simplex, and its gradients are averaged by volume."""
    dimension, points = snapshot.dimension, snapshot.points
    simplices = snapshot.simplices()
    sides = points[simplices[:, 1:], :dimension] - points[simplices[:, :1], :dimension]
    changes = snapshot.fields["displacement"][simplices[:, 1:]] - snapshot.fields["displacement"][simplices[:, :1]]
    volume = np.abs(np.linalg.det(sides))
    # A slice may have parts without volume; they count nowhere.
    whole = volume > 1e-9 * np.max(volume)
    gradient = np.zeros((len(simplices), 3, 3))
    gradient[whole, :dimension] = np.linalg.solve(sides[whole], changes[whole])
    total, weight = np.zeros((len(points), 3, 3)), np.zeros(len(points))
    for corner in range(dimension + 1):
        np.add.at(total, simplices[whole, corner], volume[whole, None, None] * gradient[whole])
        np.add.at(weight, simplices[whole, corner], volume[whole])
    mean = total / np.where(weight > 0, weight, 1)[:, None, None]
    return 0.5 * (mean + np.swapaxes(mean, 1, 2))


def energy_of_stress_and_strain(snapshot):
    """1/2 sigma : E."""
    stress, e = snapshot.fields["stress"], strain(snapshot)
    work = sum((1 if i == j else 2) * stress[:, component] * e[:, i, j] for component, (i, j) in PAIRS.items())
    return np.maximum(0.5 * work, 0)


def equivalent_stress(snapshot):
    """Of von Mises."""
    s = snapshot.fields["stress"]
    normal = (s[:, XX] - s[:, YY])**2 + (s[:, YY] - s[:, ZZ])**2 + (s[:, ZZ] - s[:, XX])**2
    return np.sqrt(0.5 * normal + 3 * (s[:, XY]**2 + s[:, YZ]**2 + s[:, XZ]**2))


QUANTITIES = [
    Quantity("strain energy density", "J/m³", lambda s: s.fields["strain_energy_density"], ("strain_energy_density",)),
    Quantity("strain energy density", "J/m³", energy_of_stress_and_strain, ("displacement", "stress")),
    Quantity("equivalent stress", "Pa", equivalent_stress, ("stress",)),
    Quantity("speed", "m/s", lambda s: s.speed(), ("velocity",)),
    Quantity("displacement", "m", lambda s: np.linalg.norm(s.fields["displacement"], axis=1), ("displacement",)),
    Quantity("no field", "1", lambda s: np.zeros(len(s.points)))]


def choose_quantity(snapshot):
    """The first that the fields allow."""
    return next(quantity for quantity in QUANTITIES if all(name in snapshot.fields for name in quantity.needs))
