"""Orthographic projection of coloured polygons and lines, painted from back to front.

matplotlib's 3-D axes order whole collections, so mesh lines would shine through hills; here polygons and lines are sorted
together.
"""
import numpy as np
from matplotlib.collections import PolyCollection

LIGHT = np.array([-0.35, -0.45, 0.82])


class View:
    """Camera directions for an azimuth and an elevation in degrees."""

    def __init__(self, azimuth=-62, elevation=34):
        a, e = np.radians(azimuth), np.radians(elevation)
        towards = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
        right = np.array([-np.sin(a), np.cos(a), 0])
        self.axes = np.stack([right, np.cross(towards, right), towards])

    def project(self, points):
        """Picture coordinates [.., 2] and depth [..] (larger is nearer) of points [.., 3]."""
        seen = points @ self.axes.T
        return seen[..., :2], seen[..., 2]


def shade(colours, polygons):
    """Darkens RGBA colours [n, 4] of polygons [n, 3 or 4, 3] that face away from the light."""
    normal = np.cross(polygons[:, 1] - polygons[:, 0], polygons[:, 2] - polygons[:, 0])
    length = np.linalg.norm(normal, axis=1, keepdims=True)
    normal = np.divide(normal, length, out=np.zeros_like(normal), where=length > 0)
    brightness = 0.9 + 0.12 * np.abs(normal @ (LIGHT / np.linalg.norm(LIGHT)))
    shaded = colours.copy()
    shaded[:, :3] = np.clip(shaded[:, :3] * brightness[:, None], 0, 1)
    return shaded


def paint(axes, view, polygon_groups, lines, line_colours, line_width):
    """Draws groups of (polygons [n, corners, 3], RGBA [n, 4]) and lines [m, 2, 3] with RGBA [m, 4], nearest last."""
    outlines, depths, faces, edges, widths = [], [], [], [], []
    for polygons, colours in polygon_groups:
        flat, depth = view.project(polygons)
        outlines.extend(flat)
        depths.append(depth.mean(axis=1))
        # The polygon's own colour on its outline closes the hairlines between antialiased neighbours.
        faces.extend(colours)
        edges.extend(colours)
        widths.extend([0.25] * len(polygons))
    flat, depth = view.project(lines)
    outlines.extend(flat)
    nudge = 0.01 * (np.ptp(np.concatenate(depths)) + 1e-300)  # a line lies in front of the polygons it borders
    depths.append(depth.mean(axis=1) + nudge)
    faces.extend([(0, 0, 0, 0)] * len(lines))
    edges.extend(line_colours)
    widths.extend([line_width] * len(lines))
    order = np.argsort(np.concatenate(depths), kind="stable")
    collection = PolyCollection([outlines[i] for i in order], closed=True, facecolors=[faces[i] for i in order],
                                edgecolors=[edges[i] for i in order], linewidths=[widths[i] for i in order])
    collection.set_joinstyle("round")
    axes.add_collection(collection)
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.set_axis_off()
