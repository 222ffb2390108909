# SPDX-License-Identifier: MIT
"""Builds the module _boxreel by CMake for the interpreter that runs this. The rest is in pyproject.toml."""

import os
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        source = os.path.dirname(os.path.abspath(__file__))
        build = os.path.abspath(self.build_temp)
        target = os.path.abspath(self.get_ext_fullpath(extension.name))
        subprocess.run(["cmake", "-S", source, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DBOXREEL_PYTHON=ON", f"-DPython3_EXECUTABLE={sys.executable}"], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "boxreel_python"], check=True)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        self.copy_file(os.path.join(build, "python", os.path.basename(target)), target)


setup(ext_modules=[Extension("_boxreel", [])], cmdclass={"build_ext": CMakeBuild})
