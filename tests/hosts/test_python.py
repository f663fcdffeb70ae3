# SPDX-License-Identifier: Apache-2.0
"""The Python module oiio_ddt, against OpenImageIO's Python module with the plugin, and alone."""

import concurrent.futures
import os
import signal
import subprocess
import sys
import threading
import time
import tracemalloc

import numpy as np
import pytest

import oiio_ddt

INTEGERS = ("bool", "uint32", "int32", "uint64", "int64")
NUMBERS = ("uint8", "int8", "uint16", "int16", "float16", "float32", "float64")


def picture(width=70, height=50, channels=3, dtype="float32"):
    """Edges, a slope, and light beyond 1 in floats; colour times alpha where there is one."""
    y, x = np.mgrid[0:height, 0:width].astype(np.float32)
    disc = ((x - 30) ** 2 + (y - 25) ** 2 < 300) * 0.7 + x / width * 0.3
    image = np.stack([disc * (1 - 0.2 * c) for c in range(channels)], axis=2)
    if channels in (2, 4):
        image[..., -1] = np.clip(x / 40, 0, 1)
        image[..., :-1] *= image[..., -1:]
    if np.dtype(dtype).kind == "f":
        return (image * 3).astype(dtype)
    return (image * np.iinfo(dtype).max).astype(dtype)


def by_filter(image, size, spec, space=None):
    """What OpenImageIO's resize makes of it, with the plugin."""
    oiio = pytest.importorskip("OpenImageIO")
    height, width, channels = image.shape
    form = {"float16": "half", "float32": "float", "float64": "double"}.get(
        image.dtype.name, image.dtype.name)
    source = oiio.ImageBuf(oiio.ImageSpec(width, height, channels, form))
    # Whole numbers as they are: set_pixels converts.
    source.set_pixels(oiio.ROI(0, width, 0, height, 0, 1, 0, channels), image)
    if space:
        source.specmod().attribute("oiio:ColorSpace", space)
    oiio.get_string_attribute("format_list")
    large = oiio.ImageBufAlgo.resize(source, spec, roi=oiio.ROI(0, size[0], 0, size[1], 0, 1, 0,
                                                                channels))
    assert not large.has_error, large.geterror()
    return large.get_pixels(form)


@pytest.mark.parametrize("dtype", ["uint8", "uint16", "int16", "float16", "float32"])
@pytest.mark.parametrize("channels", [1, 3, 4])
def test_the_filters_bits(dtype, channels):
    image = picture(channels=channels, dtype=dtype)
    for light, spec, space in (("linear", "ddt,light=linear", None),
                               ("sRGB", "ddt,light=sRGB", None),
                               ("encoded", "ddt-sharp,light=encoded", "sRGB")):
        ours = oiio_ddt.enlarge(image, size=(161, 101), filter=spec.split(",")[0], light=light)
        theirs = by_filter(image, (161, 101), spec, space)
        assert ours.dtype == image.dtype
        assert ours.tobytes() == theirs.astype(dtype).tobytes(), light


def test_floats_are_linear_light_unless_they_are_said_not_to_be():
    floats = picture(channels=3, dtype="float32")
    ours = oiio_ddt.enlarge(floats, size=(161, 101))
    assert ours.tobytes() == by_filter(floats, (161, 101), "ddt").tobytes()
    assert ours.tobytes() == oiio_ddt.enlarge(floats, size=(161, 101), light="linear").tobytes()
    assert ours.tobytes() != oiio_ddt.enlarge(floats, size=(161, 101), light="encoded").tobytes()
    integers = picture(channels=3, dtype="uint8")
    ours = oiio_ddt.enlarge(integers, size=(161, 101))
    assert ours.tobytes() == oiio_ddt.enlarge(integers, size=(161, 101), light="encoded").tobytes()


def test_holes_are_filled_as_the_filter_fills_them():
    image = picture(channels=3, dtype="float32")
    image[20:31, 25:40] = np.nan
    image[5, 6, 0] = np.nan
    ours = oiio_ddt.enlarge(image, size=(161, 101), filter="ddt,holes=fill", light="linear")
    assert np.isfinite(ours).all()
    assert ours.tobytes() == by_filter(image, (161, 101), "ddt,light=linear,holes=fill").tobytes()


@pytest.mark.parametrize("dtype", ["float16", "float32", "float64"])
def test_holes_are_filled_where_the_size_stays(dtype):
    image = picture(channels=3, dtype=dtype)
    image[20:31, 25:40] = np.nan
    image[5, 6, 0] = np.nan
    missing = np.isnan(image)
    ours = oiio_ddt.enlarge(image, 1, filter="ddt,holes=fill")
    assert np.isfinite(ours).all()
    assert ours[~missing].tobytes() == image[~missing].tobytes()
    assert ours.tobytes() == by_filter(image, (70, 50), "ddt,holes=fill").tobytes()
    part = oiio_ddt.enlarge(image, 1, filter="ddt,holes=fill", roi=(30, 10, 45, 25))
    assert part.tobytes() == ours[10:25, 30:45].tobytes()
    kept = oiio_ddt.enlarge(image, 1)
    assert kept.tobytes() == image.tobytes()


@pytest.mark.parametrize("dtype", NUMBERS + INTEGERS)
def test_keeps_dtype_and_dimensions(dtype):
    image = (np.arange(12 * 9 * 2).reshape(9, 12, 2) % 100).astype(dtype)
    large = oiio_ddt.enlarge(image, 2)
    assert large.dtype == image.dtype and large.shape == (18, 24, 2)
    flat = oiio_ddt.enlarge(image[..., 0], (2, 3))
    assert flat.dtype == image.dtype and flat.shape == (27, 24)
    swapped = image.astype(image.dtype.newbyteorder())
    again = oiio_ddt.enlarge(swapped, 2)
    assert again.dtype == swapped.dtype and np.array_equal(again, large)


def test_tells_its_release():
    program = os.path.join(os.environ["DDT_BUILD"], "bin", "ddt")
    if not os.path.exists(program):
        pytest.skip("the tool is not built")
    told = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout
    assert told == f"ddt {oiio_ddt.__version__}\n"


@pytest.mark.parametrize("dtype", INTEGERS)
def test_numbers_of_objects_are_copied(dtype):
    values = [0, 1] if dtype == "bool" else [0, 3, np.iinfo(dtype).max, np.iinfo(dtype).max - 1]
    image = np.random.default_rng(1).choice(np.array(values, dtype), (20, 30))
    large = oiio_ddt.enlarge(image, 3)
    assert set(np.unique(large)) <= set(np.array(values, dtype))
    assert np.array_equal(large[1::3, 1::3], image)


def test_strides_of_any_kind():
    image = picture(60, 40, 4, "uint8")
    wanted = oiio_ddt.enlarge(np.ascontiguousarray(image[::-1, ::2, 2::-1]), 2, light="sRGB")
    assert np.array_equal(oiio_ddt.enlarge(image[::-1, ::2, 2::-1], 2, light="sRGB"), wanted)
    planes = np.ascontiguousarray(picture(30, 20, 3).transpose(2, 0, 1))
    assert np.array_equal(oiio_ddt.enlarge(planes.transpose(1, 2, 0), 2),
                          oiio_ddt.enlarge(np.ascontiguousarray(planes.transpose(1, 2, 0)), 2))


def test_a_part_is_a_crop_for_any_number_of_threads():
    image = picture(300, 280)
    whole = oiio_ddt.enlarge(image, 2.5, threads=2)
    for x0, y0, x1, y1 in ((0, 0, 40, 30), (600, 650, 750, 700), (637, 1, 638, 2)):
        part = oiio_ddt.enlarge(image, 2.5, roi=(x0, y0, x1, y1), threads=1)
        assert np.array_equal(part, whole[y0:y1, x0:x1])


def test_unassociated_alpha():
    image = picture(channels=4)
    straight = image.copy()
    alpha = image[..., 3:]
    straight[..., :3] = np.divide(image[..., :3], alpha, where=alpha > 0, out=np.zeros_like(image[..., :3]))
    straight[..., :3][alpha[..., 0] == 0] = 5  # does not show
    large = oiio_ddt.enlarge(straight, 2, light="linear", alpha="unassociated")
    product = straight.copy()
    product[..., :3] *= alpha
    wanted = oiio_ddt.enlarge(product, 2, light="linear")
    some = wanted[..., 3:] > 0
    wanted[..., :3] = np.divide(wanted[..., :3], wanted[..., 3:], where=some, out=wanted[..., :3].copy())
    assert np.array_equal(large, wanted)


@pytest.mark.parametrize("arguments, says", [
    (dict(), "either a scale or a size"),
    (dict(scale=2, size=(9, 9)), "either a scale or a size"),
    (dict(scale=0.5), "scale 0.5"),
    (dict(scale=float("nan")), "scale nan"),
    (dict(size=(5, 500)), "must not be smaller"),
    (dict(size=(0, 0)), "must not be smaller"),
    (dict(size=(2**31, 500)), "nor larger"),
    (dict(scale=2, filter="ddtx"), "unknown filter"),
    (dict(scale=2, filter="ddt,blur=9"), "blur=9"),
    (dict(scale=2, light="dim"), "allowed are linear, encoded, sRGB"),
    (dict(scale=2, alpha="some"), "associated"),
    (dict(scale=2, roi=(0, 0, 1000, 2)), "roi"),
    (dict(scale=10**400), "scale 10000"),
    (dict(scale=10**5000), "scale (of int|1000+) is not allowed; allowed are numbers from 1"),
    (dict(size=(10**5000, 9)), "size (of tuple|.1000+) is not allowed"),
    (dict(scale=2, light="x\ny"), 'light "x y" is not allowed'),
    (dict(scale=2, filter="ddt,light=x\ny"), 'light "x y" is not allowed'),
    (dict(scale=2, filter="ddt,light=sRGB", light="dim"), 'light "dim" is not allowed'),
    (dict(scale=2, filter="ddt,light=dim", light="sRGB"), 'light "dim" is not allowed'),
    (dict(scale=2, alpha="x\ny"), "alpha 'x.ny' is not allowed"),
    (dict(scale=2, filter="ddt\udc80"), "filter 'ddt.udc80' is not allowed; allowed are texts"),
    (dict(scale=2, light="\ud800"), "light"),
])
def test_errors_name_what_is_allowed(arguments, says):
    with pytest.raises(ValueError, match=says) as caught:
        oiio_ddt.enlarge(picture(), **arguments)
    assert str(caught.value).startswith("ddt: ") and "\n" not in str(caught.value)


@pytest.mark.parametrize("arguments, says", [
    (dict(scale="2"), "scale '2' is not allowed; allowed are a number, or one for x and one for y"),
    (dict(scale=(2,)), "scale"),
    (dict(scale=2j), "scale 2j is not allowed; allowed are a number, or one for x and one for y"),
    (dict(scale=np.ones((3, 3))), "scale"),
    (dict(size=5), "size 5 is not allowed; allowed are whole numbers, .width, height."),
    (dict(size=(400.5, 300)), "size"),
    (dict(size=("400", "300")), "size"),
    (dict(scale=2, roi=(0, 0, 1)), "roi"),
    (dict(scale=2, roi="0011"), "roi"),
    (dict(scale=2, threads=1.5), "^ddt: threads must be a whole number, not 1.5$"),
    (dict(scale=2, threads=None), "^ddt: threads must be a whole number, not None$"),
    (dict(scale=2, threads=(2,)), "^ddt: threads must be a whole number, not .2,.$"),
    (dict(scale=2, filter=None), "filter None is not allowed; allowed are texts"),
    (dict(scale=2, light=5), "light"),
    (dict(scale=2, progress=5), "^ddt: progress 5 is not allowed; allowed are functions$"),
    (dict(scale=1, progress=5), "^ddt: progress 5 is not allowed; allowed are functions$"),
])
def test_arguments_of_other_types_are_named(arguments, says):
    with pytest.raises(TypeError, match=says) as caught:
        oiio_ddt.enlarge(picture(), **arguments)
    assert str(caught.value).startswith("ddt: ") and "\n" not in str(caught.value)


def test_what_is_masked_is_not_shown():
    image = picture(channels=3, dtype="float32")
    masked = np.ma.array(image, mask=image > 0.5)
    for work in (oiio_ddt.mesh, lambda array: oiio_ddt.enlarge(array, 2)):
        with pytest.raises(TypeError, match="masked"):
            work(masked)
    ours = oiio_ddt.enlarge(np.ma.array(image), 2)
    assert ours.tobytes() == oiio_ddt.enlarge(image, 2).tobytes()


def test_what_is_too_large_is_told():
    with pytest.raises(ValueError, match="scale 900000"):
        oiio_ddt.enlarge(np.ones((9000, 2), np.uint8), 900000.0, roi=(0, 0, 2, 2))
    with pytest.raises(ValueError, match="is not allowed; allowed are sides"):
        oiio_ddt.enlarge(np.broadcast_to(np.uint8(3), (2**32 + 4, 4)), 2)


def test_a_mesh_of_too_many_pixels_is_refused_before_memory_is_taken():
    for shape, says in (((2**29, 2**29), "too large for one mesh"), ((1, 2**29), "2 x 2")):
        with pytest.raises(ValueError, match=says) as caught:
            oiio_ddt.mesh(np.broadcast_to(np.float32(0), shape))
        assert str(caught.value).startswith("ddt: ")


def test_numbers_of_objects_have_no_mesh():
    for dtype in (bool, np.int64, np.uint32):
        with pytest.raises(TypeError, match="is not allowed for a mesh"):
            oiio_ddt.mesh(np.eye(6, dtype=dtype))


def test_a_mesh_has_the_same_errors():
    with pytest.raises(ValueError, match="asociated"):
        oiio_ddt.mesh(picture(), alpha="asociated")
    with pytest.raises(TypeError, match="^ddt: progress 5 is not allowed"):
        oiio_ddt.mesh(picture(), progress=5)


def test_daemon_threads_at_the_end_of_the_process():
    program = ("import sys, threading, time, numpy, oiio_ddt\n"
               "image = numpy.random.default_rng(1).random((200, 200, 3), numpy.float32)\n"
               "def work():\n"
               "    while True:\n"
               "        oiio_ddt.enlarge(image, 3, threads=4, progress=lambda share: True)\n"
               "for _ in range(3):\n"
               "    threading.Thread(target=work, daemon=True).start()\n"
               "time.sleep(0.2 + float(sys.argv[1]))\n")
    for i in range(5):
        done = subprocess.run([sys.executable, "-c", program, f"0.0{i}"], capture_output=True,
                              check=False)
        assert (done.returncode, done.stderr) == (0, b"")


def test_arrays_that_are_no_image():
    with pytest.raises(TypeError, match="complex128"):
        oiio_ddt.enlarge(np.zeros((4, 4), complex), 2)
    for shape in ((4,), (0, 4), (2, 2, 2, 2)):
        with pytest.raises(ValueError, match="no image"):
            oiio_ddt.enlarge(np.zeros(shape), 2)


def test_progress_rises_and_cancels():
    image = picture(900, 600)
    shares = []
    oiio_ddt.enlarge(image, 2, threads=2, progress=shares.append)
    assert shares == sorted(shares) and shares[-1] == 1
    calls = []
    with pytest.raises(oiio_ddt.Cancelled):
        oiio_ddt.enlarge(image, 2, threads=2, progress=lambda share: calls.append(share) or False)
    assert len(calls) == 1
    with pytest.raises(oiio_ddt.Cancelled):
        oiio_ddt.enlarge(image, 2, threads=2, progress=lambda share: np.float32(share) < 0)
    with pytest.raises(ZeroDivisionError):
        oiio_ddt.enlarge(image, 2, threads=2, progress=lambda share: 1 / 0)


@pytest.mark.parametrize("threads", [0, 2, 8])
def test_progress_is_told_on_the_thread_that_called(threads):
    image = picture(900, 900)
    with_holes = image.copy()
    for y in range(0, 900, 60):
        with_holes[y:y + 30, y % 400:y % 400 + 40] = np.nan
    lock = threading.RLock()

    def told_by(work):
        told = []

        def tell(share):
            assert lock.acquire(timeout=10)
            told.append((share, threading.get_ident()))
            lock.release()

        with lock:
            work(tell)
        return told

    def check():
        for work in (
                lambda tell: oiio_ddt.enlarge(image, 2, threads=threads, progress=tell),
                lambda tell: oiio_ddt.enlarge(with_holes, 1, filter="ddt,holes=fill",
                                              threads=threads, progress=tell),
                lambda tell: oiio_ddt.mesh(with_holes, filter="ddt,holes=fill", progress=tell)):
            told = told_by(work)
            shares = [share for share, _ in told]
            assert {thread for _, thread in told} == {threading.get_ident()}
            assert shares == sorted(shares) and shares[-1] == 1

    check()
    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        pool.submit(check).result()


def test_no_progress_is_told_of_a_copy():
    shares = []
    oiio_ddt.enlarge(picture(), 1, progress=shares.append)
    assert not shares


def test_ctrl_c_cancels():
    calls = []

    def interrupt(share):
        calls.append(share)
        signal.raise_signal(signal.SIGINT)

    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in background jobs
    with pytest.raises(KeyboardInterrupt):
        oiio_ddt.enlarge(picture(900, 900), 2, threads=1, progress=interrupt)
    signal.signal(signal.SIGINT, before)
    assert len(calls) < 16


def test_calls_side_by_side_make_the_same_and_no_thread_stays():
    image = picture(700, 500)
    before = len(os.listdir("/proc/self/task"))
    wanted = oiio_ddt.enlarge(image, 2)
    results = [None] * 4

    def work(i):
        results[i] = oiio_ddt.enlarge(image, 2)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(result, wanted) for result in results)
    # A thread that was joined is listed for a moment yet.
    end = time.monotonic() + 10
    while len(os.listdir("/proc/self/task")) > before and time.monotonic() < end:
        time.sleep(0.01)
    assert len(os.listdir("/proc/self/task")) == before


def test_the_lock_is_released():
    """Without a function for progress, which would let others in."""
    image = picture(700, 500)
    gate, entered = threading.Lock(), threading.Event()

    def enter():
        with gate:
            entered.set()

    interval = sys.getswitchinterval()
    probe = threading.Thread(target=enter)
    gate.acquire()
    probe.start()
    # From here on nobody is made to give the lock away.
    sys.setswitchinterval(1000)
    try:
        gate.release()
        for _ in range(100):  # the probe may be slow to wake
            oiio_ddt.enlarge(image, 2, threads=1)
            if entered.is_set():
                break
        assert entered.is_set()
    finally:
        sys.setswitchinterval(interval)
    probe.join()


def test_a_mesh_covers_the_picture():
    image = picture(40, 30)
    triangles = oiio_ddt.mesh(image, light="linear")
    assert triangles.dtype == np.int32 and triangles.shape == (2 * 39 * 29, 3)
    x, y = triangles % 40, triangles // 40
    area = (x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0])
    assert np.all(area == 1)
    assert set(triangles.ravel()) == set(range(40 * 30))
    plain = oiio_ddt.mesh(image, filter="ddt,scheme=pixel,start=diagonal")
    assert not np.array_equal(plain, triangles)
    with pytest.raises(ValueError, match="2 x 2"):
        oiio_ddt.mesh(image[:1])


@pytest.mark.parametrize("dtype", ["float16", "float32", "float64"])
def test_a_mesh_is_that_of_the_filled_picture(dtype):
    image = picture(40, 30, 4, dtype)
    image[8:17, 10:25] = np.nan
    image[3, 30, 1] = np.nan
    with_holes = image.copy()
    for alpha in ("associated", "unassociated"):
        filled = oiio_ddt.enlarge(image, 1, filter="ddt,holes=fill", alpha=alpha)
        ours = oiio_ddt.mesh(image, filter="ddt,holes=fill", alpha=alpha)
        assert np.array_equal(ours, oiio_ddt.mesh(filled, alpha=alpha))
        assert not np.array_equal(ours, oiio_ddt.mesh(image, alpha=alpha))
    assert image.tobytes() == with_holes.tobytes()
    see_through = picture(40, 30, 4, "uint8")
    see_through[8:17, 10:25, 3] = 0
    filled = oiio_ddt.enlarge(see_through, 1, filter="ddt,holes=fill-alpha")
    assert np.array_equal(oiio_ddt.mesh(see_through, filter="ddt,holes=fill-alpha"),
                          oiio_ddt.mesh(filled))


def test_a_mesh_of_a_picture_with_holes_has_the_same_errors_and_progress():
    image = picture(40, 30)
    image[8:17, 10:25] = np.nan
    with pytest.raises(ValueError, match="no pixel is there to fill"):
        oiio_ddt.mesh(np.full((30, 40, 3), np.nan, "float32"), filter="ddt,holes=fill")
    shares = []
    oiio_ddt.mesh(image, filter="ddt,holes=fill", progress=shares.append)
    filling = shares[:shares.index(0.5)]
    assert filling and filling == sorted(filling) and min(shares[len(filling):]) == 0.5
    assert shares[-1] == 1
    # How many come on this thread is not the same each time.
    for stop in (0, 0.3, 0.7, 1):
        calls = []
        with pytest.raises(oiio_ddt.Cancelled):
            oiio_ddt.mesh(image, filter="ddt,holes=fill",
                          progress=lambda share: calls.append(share) or share < stop)
        assert [share >= stop for share in calls] == [False] * (len(calls) - 1) + [True]


def test_a_mesh_is_made_on_the_cpu_whatever_device_is_named():
    code = ("import numpy, oiio_ddt; image = numpy.eye(9, dtype=numpy.float32);"
            "image[3, 4] = numpy.nan;"
            "meshes = [oiio_ddt.mesh(image, filter='ddt,holes=fill,device=' + device)"
            "          for device in ('cpu', 'osmesa', 'egl')];"
            "assert all(numpy.array_equal(mesh, meshes[0]) for mesh in meshes);"
            "assert 'OSMesa' not in open('/proc/self/maps').read()")
    subprocess.run([sys.executable, "-c", code], check=True)


def test_no_memory_stays():
    image = picture(100, 100)
    oiio_ddt.enlarge(image, 2)
    tracemalloc.start()
    for _ in range(20):
        oiio_ddt.enlarge(image, 2)
    held, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert held < 100_000

    def resident():
        with open("/proc/self/statm", encoding="ascii") as numbers:
            return int(numbers.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    before = resident()
    for _ in range(200):
        oiio_ddt.enlarge(image, 2)
    assert resident() - before < 200 * 20_000 # a result is 480 000


def test_works_without_openimageio():
    code = ("import sys; sys.modules['OpenImageIO'] = None; import numpy, oiio_ddt;"
            "oiio_ddt.enlarge(numpy.zeros((4, 4)), 2);"
            "maps = open('/proc/self/maps').read();"
            "assert 'OpenImageIO' not in maps and 'libtbb' not in maps")
    subprocess.run([sys.executable, "-c", code], check=True)


def test_stubs_name_what_is_there():
    folder = os.path.dirname(oiio_ddt.__file__)
    assert os.path.exists(os.path.join(folder, "py.typed"))
    with open(os.path.join(folder, "_ddt.pyi"), encoding="utf-8") as stubs:
        text = stubs.read()
    for name in ("Cancelled", "enlarge", "mesh"):
        assert name in text and hasattr(oiio_ddt, name)
    assert oiio_ddt.enlarge.__doc__ and oiio_ddt.mesh.__doc__
