# SPDX-License-Identifier: Apache-2.0
"""Enlarges arrays of pixels by data-dependent triangulation.

    import oiio_ddt
    large = oiio_ddt.enlarge(image, scale=4, light="sRGB")

The result has the bits that OpenImageIO's filter `ddt` makes of the same pixels, for any number of
threads and on any device. OpenImageIO is not needed. Functions may be called from several threads
at once; they release the interpreter's lock while they work. Ctrl-C cancels.
"""

from __future__ import annotations

import math
import operator
from typing import Any, Callable, Optional, Sequence, Tuple, Union

import numpy as np

from . import _ddt
from ._ddt import Cancelled, __version__

__all__ = ["Cancelled", "__version__", "enlarge", "mesh"]

# What the numbers of a dtype are to the core; integers of 32 bits and more are copied.
_SAMPLES = {
    "uint8": "uint8", "int8": "int8", "uint16": "uint16", "int16": "int16",
    "float16": "half", "float32": "float32", "float64": "float64",
    "uint32": "id32", "int32": "id32", "uint64": "id32", "int64": "id32", "bool": "id32",
}


def enlarge(
    array: Any,
    scale: Union[None, float, Sequence[float]] = None,
    *,
    size: Optional[Tuple[int, int]] = None,
    filter: str = "ddt",
    roi: Optional[Tuple[int, int, int, int]] = None,
    light: Optional[str] = None,
    alpha: str = "associated",
    threads: int = 0,
    progress: Optional[Callable[[float], Optional[bool]]] = None,
) -> np.ndarray:
    """Enlarge an image.

    array     Height x width, or height x width x channels; any strides. Channels are grey; grey,
              alpha; red, green, blue; the same and alpha; further ones are quantities of their
              own. uint8 and uint16 stand for 0 to 1, int8 and int16 for -1 to 1, floats for
              themselves, worked in 32 bits, beyond whose range float64 comes out infinite; bool and
              integers of 32 and 64 bits are object IDs: copied from the nearest pixel,
              never blended. A masked array must have nothing masked: give NaN there, and
              filter="ddt,holes=fill".
    scale     A factor, or one for x and one for y: at least 1. Sizes are rounded to whole pixels.
    size      Instead of a scale: (width, height) of the result.
    filter    "ddt", "ddt-linear" or "ddt-sharp", with options: "ddt,cost=scf".
    roi       (x0, y0, x1, y1) in pixels of the result: only these are made, with the same bits.
    light     What the numbers of colour mean. "linear": linear light, as in an EXR. "encoded": an
              encoding, blended as it is. "sRGB", "Rec709", "Gamma1.8", "Gamma2.2", "Gamma2.4":
              encoded so, and blended in linear light. None: "linear" of floats, "encoded" of
              integers, as the filter does for an image whose colour space nobody says. Where the
              filter has an option light=, that counts. (The filter's light=encoded in OpenImageIO
              blends floats that nobody calls an encoding in the same way, but seeks edges in them
              as in linear light; "linear" has its bits then.)
    alpha     "associated": colour is multiplied by alpha already. "unassociated": it is not, as
              in a PNG; colour where alpha is 0 does not show.
    threads   How many to use; 0 or less: as many as there are processors that the process may run
              on, or fewer where a container's quota says so.
    progress  Called now and then, on the thread of the call, with the share done, 0 to 1; if it
              returns False, or what is false and not None, the work ends with Cancelled, if it
              raises, with that exception. Never called for a copy, as by scale=1 without
              holes=fill.

    Returns a new C-contiguous array of the same dtype and number of dimensions. Raises ValueError
    or TypeError for what is not allowed, MemoryError, RuntimeError for a device that cannot be
    had, KeyboardInterrupt, Cancelled.
    """
    pixels, dtype, sample = _as_pixels(array)
    _check_texts(filter=filter, light=light)
    _check_progress(progress)
    height, width = pixels.shape[:2]
    full = _full_size(width, height, scale, size)
    x0, y0, x1, y1 = _checked_roi(roi, full)
    associated = _is_associated(alpha)
    result = np.empty((y1 - y0, x1 - x0, pixels.shape[2]), pixels.dtype)
    _ddt.enlarge(pixels, result, sample, full, (x0, y0), filter, _light_of(dtype, light),
                 associated, _thread_count(threads), progress)
    result = _as_dtype(result, dtype)
    return result[..., 0] if np.ndim(array) == 2 else result


def mesh(
    array: Any,
    *,
    filter: str = "ddt",
    light: Optional[str] = None,
    alpha: str = "associated",
    progress: Optional[Callable[[float], Optional[bool]]] = None,
) -> np.ndarray:
    """Triangulate an image, of at least 2 x 2 pixels, at once.

    Returns int32 numbers of vertices, 3 a triangle: vertex y * width + x is pixel (x, y), at
    (x, y). There are 2 (width - 1) (height - 1) triangles, each of area 1/2 and running from x
    towards y. Arguments and errors are those of enlarge(); object IDs, which have no
    edges to follow, are a TypeError. It is made on the CPU, whatever device the filter names; with
    its holes=fill missing pixels are filled first, as by enlarge() with scale 1. Takes about 80
    bytes a pixel meanwhile, after what filling takes.
    """
    pixels, dtype, sample = _as_pixels(array)
    if sample == "id32":
        raise TypeError(f"ddt: dtype {dtype} is not allowed for a mesh, as of object IDs; "
                        "allowed are floats and integers of 8 and 16 bits")
    _check_texts(filter=filter, light=light)
    _check_progress(progress)
    return _ddt.mesh(pixels, sample, filter, _light_of(dtype, light), _is_associated(alpha),
                     progress)


def _as_pixels(array: Any) -> Tuple[np.ndarray, np.dtype, str]:
    """The array as height x width x channels of what the core knows, its dtype, and what its
    numbers are."""
    if np.ma.is_masked(array):
        raise TypeError("ddt: an array with masked pixels is not allowed; allowed are NaN there, "
                        'which filter="ddt,holes=fill" fills')
    pixels = np.asarray(array)
    dtype = pixels.dtype
    sample = _SAMPLES.get(dtype.name)
    if sample is None:
        raise TypeError(f"ddt: dtype {dtype} is not allowed; allowed are {', '.join(_SAMPLES)}")
    if pixels.ndim == 2:
        pixels = pixels[..., np.newaxis]
    if pixels.ndim != 3 or 0 in pixels.shape:
        raise ValueError(f"ddt: an array of shape {np.shape(array)} is no image; allowed are "
                         "height x width and height x width x channels")
    if max(pixels.shape) > 2**29:
        raise ValueError(f"ddt: an array of shape {np.shape(array)} is not allowed; allowed are "
                         "sides and channels up to 2**29")
    if not dtype.isnative:
        pixels = pixels.astype(dtype.newbyteorder("="))
    if dtype == bool:
        pixels = pixels.astype(np.uint32)
    elif dtype.itemsize == 8 and dtype.kind in "iu":
        pixels = np.ascontiguousarray(pixels).view(np.uint32)
    return pixels, dtype, sample


def _as_dtype(result: np.ndarray, dtype: np.dtype) -> np.ndarray:
    if dtype.itemsize == 8 and dtype.kind in "iu":
        return result.view(dtype.newbyteorder("=")).astype(dtype, copy=False)
    return result.astype(dtype, copy=False)


def _shown(value: Any) -> str:
    """For a message: in one line, and not too long."""
    try:
        return " ".join(repr(value).split())[:60]
    except ValueError:  # of a whole number with thousands of digits
        return f"of {type(value).__name__}"


def _check_texts(filter: Any, light: Any) -> None:
    for name, text in (("filter", filter), ("light", light)):
        if not (isinstance(text, str) or text is None and name == "light"):
            raise TypeError(f"ddt: {name} {_shown(text)} is not allowed; allowed are texts")
        try:
            (text or "").encode()
        except UnicodeEncodeError:
            raise ValueError(f"ddt: {name} {_shown(text)} is not allowed; allowed are texts that "
                             "UTF-8 can hold") from None


def _check_progress(progress: Any) -> None:
    if not (progress is None or callable(progress)):
        raise TypeError(f"ddt: progress {_shown(progress)} is not allowed; allowed are functions")


def _whole_numbers(name: str, numbers: Any, allowed: str) -> Tuple[int, ...]:
    """As many as names are in `allowed`."""
    try:
        whole = tuple(operator.index(n) for n in numbers)
    except TypeError:
        whole = ()
    if len(whole) != allowed.count(",") + 1:
        raise TypeError(f"ddt: {name} {_shown(numbers)} is not allowed; allowed are whole numbers, "
                        f"{allowed}")
    return whole


def _thread_count(threads: Any) -> int:
    try:
        count = operator.index(threads)
    except TypeError:
        raise TypeError(f"ddt: threads must be a whole number, not {_shown(threads)}") from None
    return max(-1, min(count, 2**31 - 1))


def _light_of(dtype: np.dtype, light: Optional[str]) -> str:
    if light is None:
        return "linear" if dtype.kind == "f" else "encoded"
    return light


def _is_associated(alpha: str) -> bool:
    if not isinstance(alpha, str) or alpha not in ("associated", "unassociated"):
        raise ValueError(f"ddt: alpha {_shown(alpha)} is not allowed; allowed are associated, "
                         "unassociated")
    return alpha == "associated"


def _full_size(width: int, height: int, scale: Any, size: Any) -> Tuple[int, int]:
    if (scale is None) == (size is None):
        raise ValueError("ddt: give either a scale or a size")
    if size is not None:
        full_width, full_height = _whole_numbers("size", size, "(width, height)")
        if not (width <= full_width <= 2**29 and height <= full_height <= 2**29):
            raise ValueError(f"ddt: size {_shown(size)} is not allowed; it must not be smaller than "
                             f"the image, {width} x {height}, nor larger than 2**29")
        return full_width, full_height
    try:
        x, y = (float(n * 1.0) for n in ((scale, scale) if np.ndim(scale) == 0 else scale))
    except OverflowError:  # of a whole number
        x = y = math.inf
    except (TypeError, ValueError):
        raise TypeError(f"ddt: scale {_shown(scale)} is not allowed; allowed are a number, or one "
                        "for x and one for y") from None
    if not (1 <= x < 1e6 and 1 <= y < 1e6):
        raise ValueError(f"ddt: scale {_shown(scale)} is not allowed; allowed are numbers from 1 to "
                         "below 1000000")
    full_width, full_height = int(width * x + 0.5), int(height * y + 0.5)
    if max(full_width, full_height) > 2**29:
        raise ValueError(f"ddt: scale {_shown(scale)} is not allowed; it makes {full_width} x "
                         f"{full_height} pixels of the image, and allowed are sides up to 2**29")
    return full_width, full_height


def _checked_roi(roi: Any, full: Tuple[int, int]) -> Tuple[int, int, int, int]:
    x0, y0, x1, y1 = ((0, 0, *full) if roi is None else
                      _whole_numbers("roi", roi, "(x0, y0, x1, y1)"))
    if not (0 <= x0 < x1 <= full[0] and 0 <= y0 < y1 <= full[1]):
        raise ValueError(f"ddt: roi {_shown(roi)} is not allowed; allowed are (x0, y0, x1, y1) within "
                         f"the result of {full[0]} x {full[1]} pixels")
    return x0, y0, x1, y1
