"""Reads what the compiler left in a linked nvptx image: an ELF file, in NVIDIA's words a cubin.

NVIDIA documents none of this. The sections that are read here:
    .nv.info            records [format u8][attribute u8][size u16][payload]; format 4 has a payload, (symbol u32, value u32)
                        for the attributes below
    .nv.callgraph       pairs (caller u32, callee u32) of symbols. (0, 2^32 - n) begins part n: 1 calls, 2 functions whose address is
                        taken, 3 calls through pointers with their signature, 4 the functions that these may reach
    .rela.text.F        relocations of function F: one of type R_CALL for every place that calls another function
    .nv.shared.K        shared memory of kernel K
    K_kernel_environment    its byte 2 is the execution mode of an OpenMP kernel (LLVM, OMPDeviceConstants.h)
docs/gpu.md says how what is read here was checked against what the compiler prints.
"""
import struct
from collections import Counter
from typing import NamedTuple, Optional

CUDA_MACHINE = 190
REGISTERS, FRAME, STACK = 0x2F, 0x11, 0x12
R_CALL = 0x4B
UNKNOWN = 0xFFFFFFFF
# Functions that take memory from the heap of the GPU or give it back. What they call in turn is not counted again.
HEAP = {"malloc", "free", "__kmpc_alloc_shared", "__kmpc_free_shared", "__kmpc_alloc_aggregate_arg", "omp_alloc", "omp_free", "_Znwm",
        "_ZdlPv", "_ZdlPvm"}
MODES = {1: "generic", 2: "SPMD", 3: "generic-SPMD"}


class Kernel(NamedTuple):
    symbol: str
    registers: int
    stack: Optional[int]  # [B] of a lane, over all calls; None where it depends on the run (recursion, calls through pointers)
    shared: int           # [B] of a team
    mode: str
    heap_calls: dict      # places that call a function of HEAP, by (caller, function)


class Section(NamedTuple):
    name: str
    type: int
    offset: int
    size: int
    link: int


class Symbol(NamedTuple):
    name: str
    section: int
    value: int
    size: int


class Cubin:
    """A linked image. ValueError says what a file is instead."""

    def __init__(self, content):
        if content[:5] != b"\x7fELF\x02" or len(content) < 64:
            raise ValueError("it is no 64-bit ELF file")
        kind, machine = struct.unpack_from("<HH", content, 16)
        if machine != CUDA_MACHINE:
            raise ValueError(f"it is code of machine {machine}, not of an NVIDIA GPU ({CUDA_MACHINE})")
        if kind != 2:
            raise ValueError("it is an object that nvlink has not linked yet, so stacks and calls are not complete")
        self._content = content
        try:
            self._sections = self._read_sections()
            self._symbols = self._read_symbols()
            self._attributes = self._read_attributes()
            self._callees = self._read_callgraph()
            self._heap_calls = self._count_heap_calls()
        except (struct.error, StopIteration, IndexError) as error:
            raise ValueError(f"its sections are damaged ({type(error).__name__}: {error})") from error

    def kernels(self):
        """All kernels, in the order of their symbols."""
        environments = {symbol.name: symbol for symbol in self._symbols}
        return [self._kernel(symbol.name, environments.get(symbol.name + "_kernel_environment"))
                for symbol in self._symbols if STACK in self._attributes.get(symbol.name, {})]

    def _kernel(self, name, environment):
        attributes = self._attributes[name]
        stack = attributes[STACK]
        reachable = self._reachable(name)
        return Kernel(name, attributes.get(REGISTERS, 0), None if stack == UNKNOWN else stack, self._shared(name),
                      self._mode(environment), {call: count for call, count in self._heap_calls.items() if call[0] in reachable})

    def _text(self, table, offset):
        start = table.offset + offset
        return self._content[start:self._content.index(b"\0", start)].decode()

    def _read_sections(self):
        (headers,), (size, count, names) = (struct.unpack_from("<Q", self._content, 0x28),
                                            struct.unpack_from("<HHH", self._content, 0x3A))
        rows = [struct.unpack_from("<IIQQQQIIQQ", self._content, headers + size * i) for i in range(count)]
        table = Section("", rows[names][1], rows[names][4], rows[names][5], 0)
        return [Section(self._text(table, row[0]), row[1], row[4], row[5], row[6]) for row in rows]

    def _section(self, name):
        return next(section for section in self._sections if section.name == name)

    def _read_symbols(self):
        table = self._section(".symtab")
        symbols = []
        for offset in range(table.offset, table.offset + table.size, 24):
            name, _, _, section, value, size = struct.unpack_from("<IBBHQQ", self._content, offset)
            symbols.append(Symbol(self._text(self._sections[table.link], name), section, value, size))
        return symbols

    def _read_attributes(self):
        """{function: {attribute: value}} of the image's own .nv.info; those of single kernels hold their arguments only."""
        info = self._section(".nv.info")
        attributes, position = {}, info.offset
        while position < info.offset + info.size:
            form, attribute, size = struct.unpack_from("<BBH", self._content, position)
            position += 4
            if form != 4:
                continue
            if size == 8:
                symbol, value = struct.unpack_from("<II", self._content, position)
                attributes.setdefault(self._symbols[symbol].name, {})[attribute] = value
            position += size
        return attributes

    def _read_callgraph(self):
        graph = self._section(".nv.callgraph")
        callees, part = {}, 0
        for offset in range(graph.offset, graph.offset + graph.size, 8):
            caller, callee = struct.unpack_from("<II", self._content, offset)
            if caller == 0 and callee > UNKNOWN - 16:
                part = UNKNOWN + 1 - callee
            elif part in (1, 4):
                callees.setdefault(self._symbols[caller].name, set()).add(self._symbols[callee].name)
        return callees

    def _count_heap_calls(self):
        calls = Counter()
        for section in self._sections:
            if section.type == 4 and section.name.startswith(".rela.text."):
                caller = section.name[len(".rela.text."):]
                for offset in range(section.offset, section.offset + section.size, 24):
                    _, info = struct.unpack_from("<QQ", self._content, offset)
                    callee = self._symbols[info >> 32].name
                    if callee in HEAP and info & UNKNOWN == R_CALL:
                        calls[caller, callee] += 1
        # A call without a relocation of the known type must not pass unseen.
        for caller, callees in self._callees.items():
            for callee in callees & HEAP:
                calls.setdefault((caller, callee), 1)
        return calls

    def _reachable(self, kernel):
        found, open_ends = {kernel}, [kernel]
        while open_ends:
            for callee in self._callees.get(open_ends.pop(), set()) - found - HEAP:
                found.add(callee)
                open_ends.append(callee)
        return found

    def _shared(self, kernel):
        return sum(section.size for section in self._sections if section.name == ".nv.shared." + kernel)

    def _mode(self, environment):
        if environment is None:
            return "not OpenMP"
        mode = self._content[self._sections[environment.section].offset + environment.value + 2]
        return MODES.get(mode, f"unknown ({mode})")
