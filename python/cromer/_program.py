"""`cromer`: the program that the wheel carries."""

from __future__ import annotations

import os
import pathlib
import subprocess
import sys
from typing import List, NoReturn, Optional


def program() -> pathlib.Path:
    """The program beside this file, or the one that CROMER_PROGRAM names."""
    named = os.environ.get("CROMER_PROGRAM")
    return pathlib.Path(named) if named else pathlib.Path(__file__).parent / "bin" / (
        "cromer.exe" if sys.platform == "win32" else "cromer")


def main(arguments: Optional[List[str]] = None) -> NoReturn:
    words = sys.argv[1:] if arguments is None else arguments
    path = program()
    if not path.exists():
        sys.exit("cromer: this package was installed without the program; name one in CROMER_PROGRAM")
    if sys.platform == "win32":
        sys.exit(subprocess.call([str(path), *words]))
    os.execv(path, ["cromer", *words])


if __name__ == "__main__":
    main()
