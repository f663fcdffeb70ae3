# SPDX-License-Identifier: Apache-2.0
"""What the end-to-end tests share: running programs, test images, comparing images."""

import functools
import os
import shutil
import subprocess
import tempfile
import unittest

import OpenImageIO as oiio
from OpenImageIO import ImageBufAlgo as iba

BUILD = os.environ["DDT_BUILD"]
PLUGINS = os.path.join(BUILD, "plugins")
DDT = os.path.join(BUILD, "bin", "ddt")
WRAPPER = os.path.join(BUILD, "bin", "ddt-oiiotool")

# Variables that would change what is tested.
FOREIGN = ("OIIO_LIBRARY_PATH", "OPENIMAGEIO_PLUGIN_PATH", "LD_PRELOAD", "OCIO",
           "OPENIMAGEIO_OPTIONS", "DDT_DEVICE", "DDT_EGL_DEVICE", "DDT_VERBOSE")


def environment(plugin):
    """The environment of a program, with the plugin's folder on OIIO's path or not."""
    env = {k: v for k, v in os.environ.items() if k not in FOREIGN}
    if plugin:
        env["OIIO_LIBRARY_PATH"] = PLUGINS
        env["OPENIMAGEIO_PLUGIN_PATH"] = PLUGINS
    return env


@functools.lru_cache(maxsize=None)
def is_symbolic():
    """Whether OpenImageIO's own calls cannot be redirected, as `ddt info` says then."""
    told = subprocess.run((DDT, "info"), env=environment(True),
                          capture_output=True, text=True, timeout=120, check=True).stdout
    return "maketx cannot use these filters" in told


class Case(unittest.TestCase):
    """A test in a folder of its own, which holds the images that IMAGES names."""

    # Name: oiiotool's arguments before -o. Small: every pixel is looked at many times.
    IMAGES = {
        "photo.png": "--pattern fill:topleft=0.1,0.2,0.3:topright=0.9,0.4,0.1:bottomleft=0,0.8,"
                     "0.2:bottomright=0.7,0.7,0.9 40x32 3 --line:color=1,1,1 3,2,36,28 "
                     "--box:color=0,0.1,0.9:fill=1 22,4,30,13 -d uint8",
        "photo.tif": "photo.png --ch R,G,B,A=0.5 --box:color=0.2,0,0,0.3:fill=1 4,18,12,28 "
                     "-d uint16",
        "scene.exr": "photo.png --iscolorspace Linear --mulc 3.7 --box:color=900,800,0.5:fill=1 "
                     "8,8,9,9 --attrib oiio:ColorSpace Linear -d half",
        # A data window that neither starts nor ends where the display window does.
        "window.exr": "photo.png --origin -5+3 --fullsize 36x40+2-1 -d float",
    }

    @classmethod
    def setUpClass(cls):
        cls.made = tempfile.mkdtemp(prefix="ddt-e2e-")
        cls.addClassCleanup(shutil.rmtree, cls.made)
        # All by one program, since to start it takes longer than to make them; what one recipe
        # says of its file holds for those that follow, unless they say otherwise.
        command = ["oiiotool"]
        for name, recipe in cls.IMAGES.items():
            command += ["--scanline", *recipe.split(), "-o", name]
        done = subprocess.run(command, cwd=cls.made, env=environment(False), capture_output=True,
                              text=True)
        if done.returncode or done.stderr:
            raise RuntimeError(f"{command}: {done.stdout}{done.stderr}")

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="ddt-e2e-")
        self.addCleanup(shutil.rmtree, self.folder)
        for name in os.listdir(self.made):
            shutil.copy(os.path.join(self.made, name), self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def attempt(self, *command, plugin=True, **variables):
        """Run a program; what it did is for the caller to judge."""
        return subprocess.run(command, cwd=self.folder, env={**environment(plugin), **variables},
                              capture_output=True, text=True, timeout=120)

    def most_threads(self, *command, **variables):
        """Run a program that must succeed; return how many threads it was seen with at most."""
        most = 0
        with subprocess.Popen(command, cwd=self.folder, env={**environment(True), **variables},
                              stdout=subprocess.DEVNULL) as running:
            while running.poll() is None:
                try:
                    most = max(most, len(os.listdir(f"/proc/{running.pid}/task")))
                except OSError:
                    pass  # it has just ended
        self.assertEqual(running.returncode, 0, " ".join(command))
        return most

    def succeed(self, *command, **how):
        """Run a program that must succeed without a complaint; return its output."""
        done = self.attempt(*command, **how)
        self.assertEqual((done.returncode, done.stderr), (0, ""), " ".join(command))
        return done.stdout

    def release(self):
        """OpenImageIO's, such as (2, 5)."""
        version = self.succeed("oiiotool", "--version").split(".")
        return int(version[0]), int(version[1])

    def fail_with(self, *command, says, out=None, **how):
        """Run a program that must fail with all of `says` in one line and not write `out`."""
        done = self.attempt(*command, **how)
        self.assertGreater(done.returncode, 0, f"{command}: {done}")
        text = done.stdout + done.stderr
        self.assertTrue(any(all(word in line for word in says) for line in text.splitlines()),
                        f"no line with {says} in:\n{text}")
        if out:
            self.assertFalse(os.path.exists(self.path(out)), f"{out} was written")

    def load(self, name, subimage=0):
        """The image in a file. In this process: starting a program for it takes long."""
        # Names are written again and again.
        oiio.ImageCache(True).invalidate_all(True)
        image = oiio.ImageBuf(self.path(name), subimage, 0)
        self.assertTrue(image.initialized and not image.has_error, f"{name}: {image.geterror()}")
        return image

    def hashes(self, name):
        """The hashes of the pixels' bytes, of all subimages."""
        file = oiio.ImageInput.open(self.path(name))
        self.assertTrue(file, f"{name}: {oiio.geterror()}")
        count = 1  # ImageBuf does not know it of every format
        while file.seek_subimage(count, 0):
            count += 1
        return [iba.computePixelHashSHA1(self.load(name, i)) for i in range(count)]

    def size(self, name):
        """(width, height) of the pixels in a file."""
        spec = self.load(name).spec()
        return spec.width, spec.height

    def extrema(self, name):
        """(smallest, largest) value of each channel."""
        stats = iba.computePixelStats(self.load(name))
        return list(zip(stats.min, stats.max))

    def assert_same(self, a, b):
        self.assertEqual(self.hashes(a), self.hashes(b), f"{a} and {b}")

    def assert_different(self, a, b):
        self.assertNotEqual(self.hashes(a), self.hashes(b), f"{a} and {b}")
