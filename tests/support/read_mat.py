"""Reads a MAT-file of version 5 with nothing but Python's standard library, and prints it as JSON.

A reader that shares no code with the writer. Source: "MAT-File Format", MathWorks: chapter 1, level 5. Structures of columns
of doubles, of texts and of such structures; real numbers only.
"""

import json
import math
import struct
import sys
import zlib

NUMBERS = {1: "b", 2: "B", 3: "h", 4: "H", 5: "i", 6: "I", 7: "f", 9: "d", 12: "q", 13: "Q"}
MATRIX, COMPRESSED, UTF8, UTF16 = 14, 15, 16, 17
STRUCT, CHAR, DOUBLE = 2, 4, 6


def element(data, at):
    """Type, content and the place behind the element at `at`."""
    kind, size = struct.unpack_from("<II", data, at)
    if kind >> 16:  # small: four bytes of content in the tag
        return kind & 0xFFFF, data[at + 4 : at + 4 + (kind >> 16)], at + 8
    end = at + 8 + size
    padded = end if kind == COMPRESSED else end + (-size) % 8
    return kind, data[at + 8 : end], padded


def numbers(kind, content):
    if kind in (UTF8, UTF16):
        return content.decode("utf-8" if kind == UTF8 else "utf-16-le")
    code = NUMBERS[kind]
    return list(struct.unpack(f"<{len(content) // struct.calcsize(code)}{code}", content))


def matrix(content):
    """Name and value."""
    kind, flags, at = element(content, 0)
    assert kind == 6
    array_class = flags[0]
    kind, raw, at = element(content, at)
    shape = numbers(kind, raw)
    kind, raw, at = element(content, at)
    name = raw.decode("ascii")
    if array_class == STRUCT:
        kind, raw, at = element(content, at)
        length = numbers(kind, raw)[0]
        kind, raw, at = element(content, at)
        fields = [raw[i : i + length].split(b"\0")[0].decode("ascii") for i in range(0, len(raw), length)]
        value = {}
        for field in fields:
            kind, raw, at = element(content, at)
            assert kind == MATRIX
            value[field] = matrix(raw)[1]
        return name, value
    kind, raw, at = element(content, at)
    value = numbers(kind, raw)
    if array_class == CHAR:
        return name, value if isinstance(value, str) else "".join(map(chr, value))
    assert array_class == DOUBLE and len(value) == math.prod(shape) and shape[1:] == [1], (array_class, shape)
    return name, [None if math.isnan(x) else x for x in value]


def read(path):
    with open(path, "rb") as file:
        data = file.read()
    assert data[124:128] == b"\x00\x01IM", "no MAT-file of version 5 of this byte order"
    at, variables = 128, {}
    while at < len(data):
        kind, content, at = element(data, at)
        if kind == COMPRESSED:
            kind, content, _ = element(zlib.decompress(content), 0)
        assert kind == MATRIX
        name, value = matrix(content)
        variables[name] = value
    return variables


if __name__ == "__main__":
    json.dump(read(sys.argv[1]), sys.stdout)
