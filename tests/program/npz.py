"""npz.py FILE [CSV]: prints name, shape and all numbers of each array of an .npz file, read by its published formats alone (zip's by the
standard library, NEP 1's here), not by the code that wrote it; with numpy, where that is installed, the same is read by numpy.load."""
import ast
import struct
import sys
import zipfile


def arrays(path):
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None
        for name in archive.namelist():
            data = archive.read(name)
            assert data[:8] == b"\x93NUMPY\x01\x00", name
            (length,) = struct.unpack("<H", data[8:10])
            assert (10 + length) % 64 == 0 and data[9 + length] == ord("\n"), name
            head = ast.literal_eval(data[10 : 10 + length].decode("latin1"))
            assert head["descr"] == "<f8" and head["fortran_order"] is False, head
            count = 1
            for n in head["shape"]:
                count *= n
            assert len(data) == 10 + length + 8 * count, name
            yield name.removesuffix(".npy"), head["shape"], struct.unpack(f"<{count}d", data[10 + length :])


found = {name: (shape, values) for name, shape, values in arrays(sys.argv[1])}
try:
    import numpy
except ImportError:
    numpy = None
if numpy is not None:
    loaded = numpy.load(sys.argv[1])
    assert set(loaded) == set(found)
    for name, (shape, values) in found.items():
        assert loaded[name].shape == shape and tuple(loaded[name].ravel()) == values, name
for name, (shape, values) in found.items():
    print(name, "x".join(map(str, shape)), *map(repr, values))
