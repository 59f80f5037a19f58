"""Puts library, program and licence into the wheel of a platform: CROMER_LIBRARY and CROMER_PROGRAM name them, CROMER_PLATFORM is
the wheel's tag ("manylinux_2_28_x86_64"; this machine's if not given)."""

import os
import pathlib
import sysconfig

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

NAMES = {".so": "libcromer.so", ".dylib": "libcromer.dylib", ".dll": "cromer.dll"}


class CustomBuildHook(BuildHookInterface):
    def initialize(self, version, build_data):
        platform = os.environ.get("CROMER_PLATFORM") or sysconfig.get_platform().replace("-", "_").replace(".", "_")
        build_data["pure_python"] = False
        build_data["tag"] = f"py3-none-{platform}"
        carried = build_data["force_include"]
        carried[str(pathlib.Path(self.root).parent / "LICENSE")] = "cromer/LICENSE"
        library = pathlib.Path(os.environ["CROMER_LIBRARY"]).resolve()
        carried[str(library)] = "cromer/" + next(name for end, name in NAMES.items() if end in library.name)
        if program := os.environ.get("CROMER_PROGRAM"):
            carried[program] = f"cromer/bin/{pathlib.Path(program).name}"
