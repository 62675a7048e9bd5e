"""Writes a linked nvptx image of CUDA 13 in the layout of CUDA 12, which LLVM's offload runtime before 22 can read.

CUDA 13 moved figures in the ELF file of an image (a cubin): the architecture from the low byte of the header's flags to the second
one, the mark of 64-bit addresses from bit 10 to elsewhere, and the number of barriers of a kernel from bits 20 and up of the flags
of its section .text to an attribute (0x4C) in .nv.info.KERNEL. Older runtimes look at the old places, take the image for one with
32-bit addresses and pass over the GPU (LLVM issue 159088). NVIDIA documents none of this; docs/gpu.md says how it was found and checked.
"""
import struct

NEW, OLD = (0x41, 8), (0x33, 7)  # EI_OSABI, EI_ABIVERSION
OLD_VERSION = 0x81               # the last toolkit of the old layout, 12.9
ADDRESSES_64, TEXTURES_UNIFIED = 0x400, 0x100
NUM_BARRIERS, BARRIER_BIT = 0x4C, 20
LAST_OLD_ARCHITECTURE = 90       # later ones have no old layout
SECTION_HEADER = "<IIQQQQIIQQ"


def architecture(content):
    """Of an image in the new layout; None of any other file."""
    if content[:5] != b"\x7fELF\x02" or len(content) < 64 or (content[7], content[8]) != NEW:
        return None
    return struct.unpack_from("<I", content, 48)[0] >> 8 & 0xFF


def _sections(content):
    """[(place of the header, name, header)]"""
    (headers,), (size, count, names) = struct.unpack_from("<Q", content, 40), struct.unpack_from("<HHH", content, 58)
    places = [headers + size * i for i in range(count)]
    rows = [struct.unpack_from(SECTION_HEADER, content, place) for place in places]
    texts = rows[names][4]

    def name(row):
        return bytes(content[texts + row[0]:content.index(b"\0", texts + row[0])]).decode()

    return [(place, name(row), row) for place, row in zip(places, rows)]


def _num_barriers(records):
    """Of the records [format u8][attribute u8][value or size u16] of a kernel; only format 4 has a payload."""
    position = 0
    while position + 4 <= len(records):
        form, attribute, value = struct.unpack_from("<BBH", records, position)
        if attribute == NUM_BARRIERS:
            return value & 0xFF
        position += 4 + (value if form == 4 else 0)
    return 0


def in_earlier_layout(content):
    """The image in the old layout; any other file, and an image for a later architecture, as it is."""
    number = architecture(content)
    if number is None or number > LAST_OLD_ARCHITECTURE:
        return content
    result = bytearray(content)
    sections = _sections(content)
    barriers = {name.removeprefix(".nv.info."): _num_barriers(content[row[4]:row[4] + row[5]])
                for _, name, row in sections if name.startswith(".nv.info.")}
    for place, name, row in sections:
        if name.startswith(".text."):
            struct.pack_into("<Q", result, place + 8, row[2] | barriers.get(name.removeprefix(".text."), 0) << BARRIER_BIT)
    result[7], result[8] = OLD
    struct.pack_into("<I", result, 20, OLD_VERSION)
    struct.pack_into("<I", result, 48, number << 16 | ADDRESSES_64 | TEXTURES_UNIFIED | number)
    return bytes(result)
