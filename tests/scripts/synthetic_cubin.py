"""Small nvptx images in bytes, as far as scripts/gpu/cubin.py reads them, and programs that carry them."""
import struct

SECTION_HEADER = "<IIQQQQIIQQ"
R_CALL = 0x4B


class Image:
    """Kernels with their figures and calls; content() is the linked image."""

    def __init__(self):
        self.kernels, self.calls, self.pointer_calls, self.barriers = {}, [], [], {}

    def kernel(self, function, mode=2, registers=128, stack=1000, shared=0):
        symbol = f"__omp_offloading_fe00_a9a107_{function}_l5"
        self.kernels[symbol] = (mode, registers, stack, shared)
        return symbol

    def call(self, caller, callee, places=1):
        self.calls.append((caller, callee, places))

    def call_through_pointer(self, caller, callee):
        self.pointer_calls.append((caller, callee))

    def content(self):
        functions = list(self.kernels) + [name for call in self.calls for name in call[:2]]
        functions += [name for call in self.pointer_calls for name in call]
        names = [""] + list(dict.fromkeys(functions)) + [kernel + "_kernel_environment" for kernel in self.kernels]
        index = {name: number for number, name in enumerate(names)}
        environments = b"".join(bytes([0, 0, kernel[0]]) + bytes(45) for kernel in self.kernels.values())
        sections = {".nv.global.init": (1, environments), ".nv.info": (1, self._info(index)),
                    ".nv.callgraph": (1, self._callgraph(index))}
        for symbol, kernel in self.kernels.items():
            sections[".nv.shared." + symbol] = (8, kernel[3])
        for symbol, num_barriers in self.barriers.items():
            sections[".text." + symbol] = (1, bytes(16))
            sections[".nv.info." + symbol] = (1, struct.pack("<BBHI", 4, 0x37, 4, 0x82) + struct.pack("<BBH", 2, 0x4C, num_barriers))
        for caller, callee, places in self.calls:
            table = sections.get(".rela.text." + caller, (4, b""))[1]
            sections[".rela.text." + caller] = (4, table + places * struct.pack("<QQQ", 0, index[callee] << 32 | R_CALL, 0))
        return _elf(names, index, self.kernels, sections)

    def _info(self, index):
        records = bytes([2, 0x5F, 1, 0])  # a record of another format, without payload
        for symbol, (_, registers, stack, _) in self.kernels.items():
            for attribute, value in ((0x2F, registers), (0x11, 8), (0x12, 0xFFFFFFFF if stack is None else stack)):
                records += struct.pack("<BBHII", 4, attribute, 8, index[symbol], value)
        return records

    def _callgraph(self, index):
        parts = [[(index[caller], index[callee]) for caller, callee, _ in self.calls], [], [],
                 [(index[caller], index[callee]) for caller, callee in self.pointer_calls]]
        pairs = [pair for number, part in enumerate(parts, 1) for pair in [(0, 2**32 - number), *part]]
        return b"".join(struct.pack("<II", *pair) for pair in pairs)


def _elf(names, index, kernels, sections):
    """Section 1 holds all names, section 2 the symbols, the others follow; a section of type 8 has a size alone."""
    texts = b"\0".join(name.encode() for name in [*names, ".strtab", ".symtab", *sections]) + b"\0"
    symbols = b""
    environment_section = 3 + list(sections).index(".nv.global.init")
    for name in names:
        kernel = name.removesuffix("_kernel_environment")
        place = 48 * list(kernels).index(kernel) if name != kernel else 0
        symbols += struct.pack("<IBBHQQ", _offset(texts, name), 0, 0, environment_section if name != kernel else 0, place, 48)
    content, headers = bytes(64), struct.pack(SECTION_HEADER, *[0] * 10)
    for name, (kind, data) in {".strtab": (3, texts), ".symtab": (2, symbols), **sections}.items():
        size = data if kind == 8 else len(data)
        headers += struct.pack(SECTION_HEADER, _offset(texts, name), kind, 0, 0, len(content), size, 1, 0, 1, 0)
        content += b"" if kind == 8 else data
    head = struct.pack("<4sBBB9xHHIQQQIHHHHHH", b"\x7fELF", 2, 1, 65, 2, 190, 1, 0, 0, len(content), 0, 64, 0, 0, 64,
                       3 + len(sections), 1)
    return head + content[64:] + headers


def _offset(texts, name):
    return texts.index(b"\0") if not name else (b"\0" + texts).index(b"\0" + name.encode() + b"\0")


def program(image, triple="nvptx64-nvidia-cuda", arch="sm_90"):
    """A program as clang links it, with an image for the host's architecture first."""
    return b"\x7fELF some code \x10\xff\x10\xad more code " + _offload_binary(b"host", "x86_64-pc-linux-gnu", "") + bytes(
        13) + _offload_binary(image, triple, arch) + b" the rest"


def _offload_binary(image, triple, arch):
    texts = b"".join(text.encode() + b"\0" for text in ("triple", triple, "arch", arch))
    starts = [32 + 40 + 32 + sum(len(text) + 1 for text in ("triple", triple, "arch", arch)[:i]) for i in range(4)]
    image_start = 32 + 40 + 32 + len(texts)
    size = image_start + len(image)
    return (struct.pack("<4sIQQQ", b"\x10\xff\x10\xad", 1, size, 32, 40) +
            struct.pack("<HHIQQQQ", 1, 1, 0, 72, 2, image_start, len(image)) + struct.pack("<QQQQ", *starts) + texts + image)
