# SPDX-License-Identifier: Apache-2.0
"""A copy of a shared library as if it were linked with -Bsymbolic-functions.

Calls of its own functions no longer go by a symbol: the relocations that would look it up become
relative ones, which lead to the library's own function whatever else is loaded. To be run with
LD_BIND_NOW=1, since lazy binding knows no relative slots.
"""

import struct

DT_PLTRELSZ, DT_STRTAB, DT_SYMTAB, DT_JMPREL, DT_RELA, DT_RELASZ = 2, 5, 6, 23, 7, 8
# (jump slot, data, relative) by ELF's number of the machine: x86-64, AArch64.
TYPES = {62: (7, 6, 8), 183: (1026, 1025, 1027)}


def bind(source, target):
    """Write the copy; return how many relocations were changed."""
    with open(source, "rb") as file:
        image = bytearray(file.read())
    machine, = struct.unpack_from("<H", image, 18)
    jump, data, relative = TYPES[machine]
    offset, = struct.unpack_from("<Q", image, 32)
    size, count = struct.unpack_from("<HH", image, 54)
    headers = [struct.unpack_from("<IIQQQQ", image, offset + i * size) for i in range(count)]

    def place(address):
        """Where in the file an address lies."""
        return next(address - at + begin for kind, _, begin, at, _, length in headers
                    if kind == 1 and at <= address < at + length)

    dynamic = {}
    begin, length = next((h[2], h[5]) for h in headers if h[0] == 2)
    for i in range(begin, begin + length, 16):
        tag, value = struct.unpack_from("<qQ", image, i)
        dynamic.setdefault(tag, value)
    symbols = place(dynamic[DT_SYMTAB])

    changed = 0
    for table, bytes_of in ((DT_JMPREL, DT_PLTRELSZ), (DT_RELA, DT_RELASZ)):
        begin = place(dynamic[table])
        for i in range(begin, begin + dynamic[bytes_of], 24):
            slot, info, _ = struct.unpack_from("<QQq", image, i)
            name, kind, _, section, value, _ = struct.unpack_from(
                "<IBBHQQ", image, symbols + 24 * (info >> 32))
            if info & 0xffffffff in (jump, data) and section and kind & 15 == 2:
                struct.pack_into("<QQq", image, i, slot, relative, value)
                changed += 1
    with open(target, "wb") as file:
        file.write(image)
    return changed
