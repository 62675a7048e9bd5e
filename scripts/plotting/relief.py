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


def paint(axes, view, polygon_groups, line_groups):
    """Draws groups of (polygons [n, corners, 3], RGBA [n, 4]) and of (lines [m, 2, 3], RGBA [m, 4], widths [m] or one), the
    nearest last. A line lies in front of the polygons it borders, and lines of a later group in front of an earlier one.
    """
    num_corners = max(polygons.shape[1] for polygons, _ in polygon_groups)
    outlines, depths, faces, edges, widths = [], [], [], [], []

    def add(shapes, lift, face_colours, edge_colours, line_widths):
        flat, depth = view.project(shapes)
        # The last corner is repeated, so that all outlines fit into one array.
        outlines.append(flat[:, np.minimum(np.arange(num_corners), shapes.shape[1] - 1)])
        depths.append(depth.mean(axis=1) + lift)
        faces.append(face_colours)
        edges.append(edge_colours)
        widths.append(np.broadcast_to(line_widths, len(shapes)))

    for polygons, colours in polygon_groups:
        # The polygon's own colour on its outline closes the hairlines between antialiased neighbours.
        add(polygons, 0, colours, colours, 0.25)
    nudge = 0.01 * (np.ptp(np.concatenate(depths)) + 1e-300)
    for level, (lines, colours, line_widths) in enumerate(line_groups, start=1):
        add(lines, level * nudge, np.zeros((len(lines), 4)), colours, line_widths)
    order = np.argsort(np.concatenate(depths), kind="stable")
    collection = PolyCollection(np.concatenate(outlines)[order], closed=True, facecolors=np.concatenate(faces)[order],
                                edgecolors=np.concatenate(edges)[order], linewidths=np.concatenate(widths)[order])
    collection.set_joinstyle("round")
    axes.add_collection(collection)
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.set_axis_off()
