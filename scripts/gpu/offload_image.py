"""Finds the device images inside a program that clang linked with -fopenmp-targets.

The linker packs every image into an `offload binary` (LLVM, Object/OffloadBinary.h), which lies in the program as it is:
    header  magic 10 ff 10 ad, version u32, size u64, offset of the entry u64, size of the entry u64
    entry   kind of image u16, kind of offloading u16, flags u32, offset of the texts u64, their number u64,
            offset of the image u64, its size u64
    texts   pairs (offset of the key u64, offset of the value u64): "triple", "arch"
"""
import struct
from typing import NamedTuple

MAGIC = b"\x10\xff\x10\xad"
NVPTX = "nvptx64-nvidia-cuda"


class Image(NamedTuple):
    triple: str
    arch: str
    content: bytes


def _text(binary, offset):
    return binary[offset:binary.index(b"\0", offset)].decode()


def _unpack(binary):
    _, _, _, entry, _ = struct.unpack_from("<4sIQQQ", binary)
    _, _, _, texts, num_texts, start, size = struct.unpack_from("<HHIQQQQ", binary, entry)
    pairs = [struct.unpack_from("<QQ", binary, texts + 16 * i) for i in range(num_texts)]
    properties = {_text(binary, key): _text(binary, value) for key, value in pairs}
    return Image(properties.get("triple", ""), properties.get("arch", ""), binary[start:start + size])


def images(program):
    """All device images in the bytes of a program, in their order."""
    found, position = [], program.find(MAGIC)
    while position >= 0:
        version, size = struct.unpack_from("<IQ", program, position + 4) if position + 16 <= len(program) else (0, 0)
        # The magic number is also in the code that looks for it.
        if version == 1 and 40 <= size <= len(program) - position:
            found.append(_unpack(program[position:position + size]))
            position += size - len(MAGIC)
        position = program.find(MAGIC, position + len(MAGIC))
    return found
