# SPDX-License-Identifier: GPL-3.0-or-later
"""Windows' linker finds all that modules ask for, in stubs of Python's libraries which have every name that CPython
declares, and no other."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from command.standalone import build, checks, interface, toolchain

WINDOWS = toolchain.PLATFORMS["windows-x64"]
LOADER = Path(__file__).with_name("load.cpp")


def compiled(target, source, result, *words):
    compiler = target.work / "compilers" / WINDOWS.name / "c++"
    subprocess.run([compiler, "-O1", "-s", source, "-o", result, *words], check=True)


@pytest.fixture(scope="session")
def load(target, run, tmp_path_factory):
    """load(python, names, name="PyInit__native", **): what the loader says of the module for a Python, in whose library
    are these names: {name: whether it is data}."""

    def start(python, names, name=checks.ENTRY, **expected):
        folder = tmp_path_factory.mktemp("loaded")
        stub = folder / f"python{python.replace('.', '')}.cpp"
        kinds = ("__declspec(dllexport) void {}() {{ __builtin_trap(); }}", "__declspec(dllexport) char {}[4096];")
        rows = "\n".join(kinds[is_data].format(each) for each, is_data in names.items())
        stub.write_text(f'extern "C" {{\n{rows}\n}}\n')
        compiled(target, stub, stub.with_suffix(".dll"), "-shared", "-nostartfiles", "-w")
        compiled(target, LOADER, folder / "load.exe", "-Wall", "-Wextra", "-Werror")
        module = build.module_place(target.cache, WINDOWS, python)
        shutil.copy2(module, folder)
        return run(folder / "load.exe", module.name, name, **expected)

    return start


@pytest.mark.parametrize("python", toolchain.PYTHONS)
def test_a_module_is_loaded_and_has_its_entry(load, target, python):
    imports = interface.read(build.module_place(target.cache, WINDOWS, python)).imports
    said = load(python, build.names_of_python(target, WINDOWS, python))
    assert said == f"{len(imports)} imports\n" and len(imports) > 200


def test_a_name_that_python_does_not_have_is_found(load, target):
    names = build.names_of_python(target, WINDOWS, "3.11")
    del names["PyList_New"], names["PyExc_ValueError"]
    said = load("3.11", names, status=1).splitlines()[:-1]
    assert sorted(said) == ["python311.dll has no PyExc_ValueError", "python311.dll has no PyList_New"]


def test_an_entry_that_is_not_there_is_found(load, target):
    names = build.names_of_python(target, WINDOWS, "3.13")
    assert re.match(r"it has no PyInit_native\n", load("3.13", names, name="PyInit_native", status=1))
