"""sbom.py VERSION SOURCES: what is inside a release, as CycloneDX 1.5 (JSON) on standard output.

Versions are read where they are decided: Debian's packages, the sources beside, the page's package-lock.json, the
requirements of this folder.
"""

import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Debian's package, name, licence (SPDX).
LINKED = [
    ("libfmt-dev", "fmt", "MIT"), ("libeigen3-dev", "Eigen", "MPL-2.0"), ("libboost1.74-dev", "Boost", "BSL-1.0"),
    ("nlohmann-json3-dev", "nlohmann-json", "MIT"), ("libtomlplusplus-dev", "toml++", "MIT"),
    ("libcli11-dev", "CLI11", "BSD-3-Clause"), ("libfast-float-dev", "fast_float", "Apache-2.0"),
    ("libxsimd-dev", "xsimd", "BSD-3-Clause"),
]
COMPILED = [("onetbb", "oneTBB", "Apache-2.0"), ("zlib", "zlib", "Zlib")]
IN_PAGE = {"svelte": "MIT", "uqr": "MIT", "js-lzma": "MIT"}


def component(name, version, licence, purl):
    return {"type": "library", "name": name, "version": version, "licenses": [{"expression": licence}], "purl": purl,
            "bom-ref": purl}


def debian(package, name, licence, version):
    return component(name, version, licence, f"pkg:deb/debian/{package}@{version}")


def main(version, sources):
    parts = []
    for package, name, licence in LINKED:
        installed = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package], check=True, capture_output=True, text=True).stdout
        parts.append(debian(package, name, licence, installed))
    for package, name, licence in COMPILED:
        description = next(pathlib.Path(sources).glob(f"{package}_*.dsc")).read_text()
        parts.append(debian(package, name, licence, re.search(r"^Version: (.*)$", description, re.M).group(1)))
    locked = json.loads((ROOT / "apps/web/package-lock.json").read_text())["packages"]
    for name, licence in IN_PAGE.items():
        found = locked[f"node_modules/{name}"]["version"]
        parts.append(component(name, found, licence, f"pkg:npm/{name}@{found}"))
    zig = re.search(r"^ziglang==(.*)$", (ROOT / "packaging/requirements.txt").read_text(), re.M).group(1)
    parts.append(component("libc++ and compiler-rt of zig", zig, "Apache-2.0 WITH LLVM-exception", f"pkg:pypi/ziglang@{zig}"))
    document = {
        "bomFormat": "CycloneDX", "specVersion": "1.5", "version": 1,
        "metadata": {"component": {"type": "application", "name": "cromer", "version": version, "bom-ref": "cromer"}},
        "components": parts,
        "dependencies": [{"ref": "cromer", "dependsOn": [part["bom-ref"] for part in parts]}],
    }
    print(json.dumps(document, indent=2))


if __name__ == "__main__":
    main(*sys.argv[1:])
