# SPDX-License-Identifier: Apache-2.0
# The compiled part; see __init__.py, which checks what it is given.
from typing import Callable, Optional, Tuple

import numpy as np

__version__: str

class Cancelled(Exception): ...

def enlarge(
    pixels: np.ndarray,
    result: np.ndarray,
    sample: str,
    full: Tuple[int, int],
    origin: Tuple[int, int],
    filter: str,
    light: str,
    associated: bool,
    threads: int,
    progress: Optional[Callable[[float], Optional[bool]]],
) -> None: ...
def mesh(
    pixels: np.ndarray,
    sample: str,
    filter: str,
    light: str,
    associated: bool,
    progress: Optional[Callable[[float], Optional[bool]]],
) -> np.ndarray: ...
