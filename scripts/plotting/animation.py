"""Writes pictures of equal size one after the other as a film."""
import shutil
import subprocess

import numpy as np

from .style import plt
from .text import PlotError, printable

MOST_FRAMES = 2000  # a film of 400 s


def frame(figure):
    """The figure as RGB pixels [height, width, 3]; nothing is cropped, because the frames of a film have one size."""
    figure.set_dpi(110)
    figure.canvas.draw()
    pixels = np.asarray(figure.canvas.buffer_rgba())[..., :3].copy()
    plt.close(figure)
    return pixels


def write_gif(path, frames, seconds):
    from PIL import Image
    images = [Image.fromarray(pixels).quantize(256, dither=Image.Dither.NONE) for pixels in frames]
    images[0].save(path, save_all=True, append_images=images[1:], duration=int(1000 * seconds), loop=0)


def write_mp4(path, frames, seconds):
    """Through ffmpeg's standard input; H.264 wants even sizes."""
    encoder = None
    for pixels in frames:
        pixels = np.ascontiguousarray(pixels[:len(pixels) // 2 * 2, :pixels.shape[1] // 2 * 2])
        if encoder is None:
            command = ["ffmpeg", "-y", "-loglevel", "error", "-f", "rawvideo", "-pix_fmt", "rgb24", "-s",
                       f"{pixels.shape[1]}x{pixels.shape[0]}", "-r", f"{1 / seconds:g}", "-i", "-", "-pix_fmt", "yuv420p",
                       str(path)]
            encoder = subprocess.Popen(command, stdin=subprocess.PIPE)
        try:
            encoder.stdin.write(pixels.tobytes())
        except BrokenPipeError:
            break
    try:
        encoder.stdin.close()
    except BrokenPipeError:
        pass
    if encoder.wait() != 0:
        raise PlotError(f"{printable(path)}: ffmpeg could not write it; see its message above, or use --format gif")


def write_film(folder, kind, figures, seconds=0.2):
    """animation.gif or animation.mp4 from an iterable of figures, each shown for `seconds`."""
    if kind == "mp4" and not shutil.which("ffmpeg"):
        raise PlotError("--format mp4 needs the program ffmpeg, which is not installed; install it or use --format gif")
    path = folder / f"animation.{kind}"
    try:
        {"gif": write_gif, "mp4": write_mp4}[kind](path, (frame(figure) for figure in figures), seconds)
    except OSError as error:
        raise PlotError(f"{printable(path)}: the film cannot be written ({error.strerror}); check the free space and the "
                        "permissions of the folder") from error
    print(printable(path), flush=True)
