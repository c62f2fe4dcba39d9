# SPDX-FileCopyrightText: Copyright (c) Laplacian Mesh Optimization developers
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the wheel for "pip install .": a build backend (PEP 517) that calls CMake and needs nothing else.

Settings, as in pip install . --config-settings build-dir=build:
  build-dir   a build folder to package, instead of a new build
  cmake-args  arguments for CMake, separated by spaces
"""
import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parent.parent
NAME = "laplacianmesh"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    settings = config_settings or {}
    with tempfile.TemporaryDirectory() as temporary:
        build = settings.get("build-dir") or _build(temporary, settings.get("cmake-args", "").split())
        prefix = pathlib.Path(temporary, "prefix")
        _run("cmake", "--install", build, "--prefix", prefix)
        files = _package_files(prefix)
        _check_import(files, temporary)
        return _write_wheel(pathlib.Path(wheel_directory), files)


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    info = pathlib.Path(metadata_directory, _info())
    info.mkdir()
    (info / "METADATA").write_bytes(_metadata())
    return info.name


def build_sdist(sdist_directory, config_settings=None):
    raise RuntimeError("There is no source archive: use the repository.")


def _build(folder, arguments):
    """Against VTK alone if it can be built against, otherwise against ParaView and its VTK."""
    common = [
        "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF", "-DLMO_USE_PETSC=OFF",
        "-DPython3_EXECUTABLE=" + sys.executable, *arguments,
    ]
    messages = []
    for paraview in ("OFF", "ON"):
        build = pathlib.Path(folder, "paraview-" + paraview)
        result = subprocess.run(
            ["cmake", "-S", SOURCE, "-B", build, "-DLMO_PARAVIEW=" + paraview, *common],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        )
        if result.returncode == 0:
            _run("cmake", "--build", build, "--parallel")
            return build
        messages.append(result.stdout)
    raise RuntimeError(
        "CMake found neither VTK's development files (libvtk9-dev) nor ParaView's (paraview-dev):\n"
        + "\n".join(messages)
    )


def _run(*command):
    subprocess.run(command, check=True)


def _package_files(prefix):
    """The files of the package by their names: libraries stand beside the modules, which look there."""
    files = {}
    for file in [*prefix.glob(f"**/{NAME}/*.py"), *prefix.glob(f"**/{NAME}/*.so")]:
        files[file.name] = file
    for file in prefix.glob("**/libvtkFiltersLaplacianMesh*.so.*"):
        if file.name.rpartition(".so.")[2].isdigit():  # the name that others load it by
            files[file.name] = file.resolve()
    if "__init__.py" not in files:
        raise RuntimeError("The build has no Python package: LMO_WRAP_PYTHON is off.")
    return files


def _check_import(files, temporary):
    """A package for another VTK than Python's would crash or fail only when it is used."""
    root = pathlib.Path(temporary, "import")
    package = root / NAME
    package.mkdir(parents=True)
    for name, file in files.items():
        (package / name).write_bytes(file.read_bytes())
    python = getattr(sys, "_base_executable", None) or sys.executable
    # pip hides the system's packages from builds that it isolates, by folders in this variable.
    paths = os.environ.get("PYTHONPATH", "").split(os.pathsep)
    paths = [root, *(path for path in paths if path and "pip-build-env" not in path)]
    result = subprocess.run(
        [python, "-c", f"import {NAME}"],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(map(str, paths))},
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
    )
    if result.returncode != 0:
        raise RuntimeError(f"{python} cannot import what was built for it:\n{result.stdout}")


def _version():
    text = (SOURCE / "CMakeLists.txt").read_text()
    return re.search(r"^  VERSION ([0-9.]+)$", text, re.MULTILINE).group(1)


def _info():
    return f"{NAME}-{_version()}.dist-info"


def _metadata():
    return (
        f"Metadata-Version: 2.1\nName: {NAME}\nVersion: {_version()}\n"
        "Summary: Laplacian mesh optimization for VTK and ParaView\nLicense: BSD-3-Clause\n"
    ).encode()


def _write_wheel(folder, files):
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = "-".join([python, python, re.sub("[-.]", "_", sysconfig.get_platform())])
    info = _info()
    contents = {f"{NAME}/{name}": file.read_bytes() for name, file in sorted(files.items())}
    contents[f"{info}/METADATA"] = _metadata()
    contents[f"{info}/WHEEL"] = (
        f"Wheel-Version: 1.0\nGenerator: {NAME}\nRoot-Is-Purelib: false\nTag: {tag}\n"
    ).encode()
    contents[f"{info}/LICENSE"] = (SOURCE / "LICENSE").read_bytes()
    record = f"{info}/RECORD"
    lines = [f"{name},{_hash(content)},{len(content)}" for name, content in contents.items()]
    contents[record] = ("\n".join([*lines, f"{record},,"]) + "\n").encode()
    wheel = f"{NAME}-{_version()}-{tag}.whl"
    with zipfile.ZipFile(folder / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in contents.items():
            archive.writestr(name, content)
    return wheel


def _hash(content):
    digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest())
    return "sha256=" + digest.rstrip(b"=").decode()
