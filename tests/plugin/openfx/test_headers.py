# SPDX-License-Identifier: Apache-2.0
"""Every string of OpenFX that the effect or its test host writes is one of OpenFX's own headers, whose
folder is the first argument. The effect needs no headers: this is how it is known to agree."""

import glob
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
# Not values of the headers: the entry points, the prefix of actions, a name with the clip's at its
# end, an action that there is not.
OTHERS = {"OfxGetNumberOfPlugins", "OfxGetPlugin", "Ofx", "OfxImageClipPropRoI_Source",
          "OfxActionOfTheFuture"}


def strings_in(pattern):
    found = set()
    for path in glob.glob(pattern):
        with open(path, encoding="utf-8") as file:
            found |= set(re.findall(r'"(Ofx\w*)"', file.read()))
    return found


def main():
    allowed = strings_in(os.path.join(sys.argv[1], "*.h")) | OTHERS
    effect = os.path.join(HERE, "..", "..", "..", "plugin", "openfx")
    wrong = sorted(string for folder in (effect, HERE) for suffix in ("cpp", "h")
                   for string in strings_in(os.path.join(folder, "*." + suffix)) - allowed)
    for string in wrong:
        print(f"{string} is no string of OpenFX's headers")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
