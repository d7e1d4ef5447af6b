#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""incremental_edits.py PREFIX: thirty edits of a package with a typekit, and after each the files that its build compiles,
with Ninja and with make. No edit needs a target to be named, and CMake runs only where CMakeLists.txt or a folder changed.

Compilers are replaced by one that only finds out what is included: a build is to be counted, not waited for. At the end
the package is compiled in earnest."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

COMPILER = """#!/bin/bash
# Notes the source; writes the dependencies and an empty object.
words=()
while [ $# -gt 0 ]; do
  case $1 in
    -o) object=$2; shift 2 ;;
    -c) source=$2; shift 2 ;;
    *) words+=("$1"); shift ;;
  esac
done
echo "${source##*/}" >> "%(log)s"
"${words[@]}" -E "$source" -o /dev/null && : > "$object"
"""

LINKER = """#!/bin/bash
while [ $# -gt 0 ]; do
  [ "$1" != -o ] || : > "$2"
  shift
done
"""

FILES = {
    "CMakeLists.txt": """cmake_minimum_required(VERSION 3.16)
project(edits LANGUAGES CXX)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
orocos_typegen_headers(include/edits/arm.hpp include/edits/tool.hpp include/edits/pose.hpp src/listed)
orocos_component(edits src/one.cpp src/two.cpp src/three.cpp)
""",
    # Not listed: known to the typekit because others have it as a member.
    "include/edits/base.hpp": "#pragma once\nnamespace edits { struct Base { int id; }; }\n",
    "include/edits/arm.hpp": """#pragma once
#include <edits/base.hpp>
namespace edits { struct Arm { Base base; double length; }; }
""",
    "include/edits/tool.hpp": """#pragma once
#include "base.hpp"
namespace edits { struct Tool { Base base; double mass; }; }
""",
    "include/edits/pose.hpp": "#pragma once\nnamespace edits { struct Pose { double x; double y; }; }\n",
    "include/edits/alone.hpp": "#pragma once\nnamespace edits { struct Alone { int a; }; }\n",
    "include/edits/user.hpp": """#pragma once
#include <edits/typekit/Types.hpp>
#include <rtt/TaskContext.hpp>
struct User : RTT::TaskContext { using TaskContext::TaskContext; RTT::InputPort<edits::Arm> in; };
""",
    "src/listed/extra.hpp": "#pragma once\nnamespace edits { struct Extra { int e; }; }\n",
    "src/one.cpp": "#include <edits/arm.hpp>\nint one(edits::Arm arm) { return arm.base.id; }\n",
    "src/two.cpp": """#include <edits/user.hpp>
#include <rtt/Component.hpp>
ORO_CREATE_COMPONENT_LIBRARY()
ORO_LIST_COMPONENT_TYPE(User)
""",
    "src/three.cpp": "int three() { return 3; }\n",
}



# The listed header that a type belongs to. Base comes with the first that includes it.
HEADER_OF = {"Arm": "arm", "Base": "arm", "Tool": "tool", "Pose": "pose", "Extra": "extra", "Late": "late", "Alone": "alone"}


def file_of(name):
    """The generated source with this type of the package."""
    return f"types_{HEADER_OF[name]}.cpp"


def files_of(*names):
    return sorted({file_of(name) for name in names})


# What sees all headers of the typekit is who includes <edits/typekit/Types.hpp>; its own files see what their types need.
POSE = files_of("Pose") + ["two.cpp"]
TOOL = files_of("Tool") + ["two.cpp"]
EXTRA = files_of("Extra") + ["two.cpp"]
ARM = files_of("Base", "Arm") + ["two.cpp"]
BASE = files_of("Base", "Arm", "Tool") + ["two.cpp"]
# A header that comes or goes: the plugin calls what its source has.
LATE = files_of("Late") + ["Plugin.cpp", "two.cpp"]
ALONE = files_of("Alone") + ["Plugin.cpp", "two.cpp"]
GONE = ["Plugin.cpp", "two.cpp"]
# The vector of poses that becomes a member of Tool is a type of its own, and comes with the header that has it.
WAY = files_of("Tool") + ["two.cpp"]
WAY_POSE = files_of("Pose", "Tool") + ["two.cpp"]
EVERYTHING = files_of("Arm", "Tool", "Pose", "Extra") + ["Plugin.cpp", "one.cpp", "two.cpp", "three.cpp"]


class Failure(Exception):
    pass


class Package:
    """The package, its build folder, and what a build of it did."""

    def __init__(self, work, prefix, generator):
        self.generator = generator
        # Names that have to be escaped in files of make and ninja.
        self.source = work / "edits in München"
        self.build = work / "gebaut für uns"
        self.log = work / "compiled"
        self.prefix = prefix
        shutil.rmtree(self.source, ignore_errors=True)
        shutil.rmtree(self.build, ignore_errors=True)
        for name, text in FILES.items():
            self.write(name, text)
        for name, text in {"compiler": COMPILER, "linker": LINKER}.items():
            (work / name).write_text(text % {"log": self.log})
            (work / name).chmod(0o755)
        self.configure(self.build, f"-DCMAKE_CXX_COMPILER_LAUNCHER={work}/compiler",
                       f"-DCMAKE_CXX_LINKER_LAUNCHER={work}/linker")

    def configure(self, build, *options):
        run(["cmake", "-G", self.generator, "-S", self.source, "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}",
             "-DCMAKE_BUILD_TYPE=Debug", *options])

    def write(self, name, text):
        time.sleep(0.02)  # time stamps of files count in steps of some ms
        path = self.source / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def replace(self, name, old, new):
        text = (self.source / name).read_text()
        if old not in text:
            raise Failure(f"the test is wrong: no '{old}' in {name}")
        self.write(name, text.replace(old, new))

    def touch(self, path):
        time.sleep(0.02)
        os.utime(path)

    def run_build(self):
        """Names of compiled files, and whether typegen and CMake ran."""
        self.log.write_text("")
        output = run(["cmake", "--build", self.build, "--parallel", "2"])
        return {
            "compiled": sorted(self.log.read_text().split()),
            "typegen": "Generating typekit" in output,
            "cmake": "Configuring done" in output,
        }

    def expect(self, title, compiled, typegen, cmake=False):
        found = self.run_build()
        expected = {"compiled": sorted(compiled), "typegen": typegen, "cmake": cmake}
        if found != expected:
            raise Failure(f"{self.generator}: {title}:\n  expected {expected}\n  found    {found}")
        again = self.run_build()
        if again != {"compiled": [], "typegen": False, "cmake": False}:
            raise Failure(f"{self.generator}: the build after '{title}' was not the end of it: {again}")

    def expect_in_typekit(self, word, there=True):
        found = any(f'"{word}"' in path.read_text() for path in (self.build / "typekit").glob("types_*.cpp"))
        if found != there:
            raise Failure(f"{self.generator}: '{word}' is {'not ' if there else ''}in the typekit")


def run(command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise Failure(f"{' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def edit_headers(package):
    header = "include/edits/pose.hpp"
    package.touch(package.source / header)
    package.expect("a listed header touched", POSE, typegen=True)
    package.replace(header, "struct Pose", "/* x and y */ struct Pose")
    package.expect("a comment in a listed header", POSE, typegen=True)
    package.replace(header, "double y;", "double y; double yaw;")
    package.expect("a field added", POSE, typegen=True)
    package.expect_in_typekit("yaw")
    package.replace(header, "yaw", "heading")
    package.expect("a field renamed", POSE, typegen=True)
    package.expect_in_typekit("yaw", there=False)

    package.replace("include/edits/base.hpp", "#pragma once\n", "#pragma once\n// What all have.\n")
    package.expect("a comment in a header that listed ones include", BASE + ["one.cpp"], typegen=True)
    package.replace("include/edits/base.hpp", "int id;", "int id; int revision;")
    package.expect("a field added in a header that listed ones include", BASE + ["one.cpp"], typegen=True)
    package.expect_in_typekit("revision")

    package.replace("include/edits/tool.hpp", "double mass;", "double mass; double wear;")
    package.expect("a field added in a second header", TOOL, typegen=True)
    package.replace("include/edits/arm.hpp", "double length;", "double length; double reach;")
    package.expect("a field added in a third header", ARM + ["one.cpp"], typegen=True)
    package.touch(package.source / "src/listed/extra.hpp")
    package.expect("a header in a listed folder touched", EXTRA, typegen=True)
    package.replace("include/edits/tool.hpp", "Base base;", "Base base; std::vector<Pose> way;")
    package.replace("include/edits/tool.hpp", "#pragma once\n", "#pragma once\n#include <edits/pose.hpp>\n#include <vector>\n")
    package.expect("a vector of what another header has", WAY, typegen=True)
    package.touch(package.source / "include/edits/pose.hpp")
    package.expect("a header touched that another one includes", WAY_POSE, typegen=True)
    package.replace("include/edits/tool.hpp", "std::vector<Pose> way;", "")
    package.replace("include/edits/tool.hpp", "#include <edits/pose.hpp>\n", "")
    package.expect("the vector removed", WAY, typegen=True)


def edit_others(package):
    package.touch(package.source / "include/edits/alone.hpp")
    package.expect("a header touched that nobody includes", [], typegen=False)
    package.replace("include/edits/alone.hpp", "int a;", "int b;")
    package.expect("a header changed that nobody includes", [], typegen=False)
    package.replace("src/one.cpp", "return", "return 1 +")
    package.expect("a source changed", ["one.cpp"], typegen=False)
    package.touch(package.source / "src/three.cpp")
    package.expect("a source touched", ["three.cpp"], typegen=False)
    package.replace("include/edits/user.hpp", "edits::Arm", "edits::Tool")
    package.expect("a header that uses the typekit", ["two.cpp"], typegen=False)


def edit_what_is_included(package):
    package.replace("include/edits/pose.hpp", "#pragma once\n", "#pragma once\n#include <edits/alone.hpp>\n")
    package.expect("an include added", POSE, typegen=True)
    package.replace("include/edits/alone.hpp", "int b;", "int c;")
    package.expect("a field renamed in what is included since", POSE, typegen=True)
    package.replace("include/edits/pose.hpp", "#include <edits/alone.hpp>\n", "")
    package.expect("the include removed", POSE, typegen=True)
    package.touch(package.source / "include/edits/alone.hpp")
    package.expect("a header touched that nobody includes any more", [], typegen=False)


def edit_the_list(package):
    # The first line of a generated file names the headers that its types need.
    package.write("src/listed/late.hpp", "#pragma once\nnamespace edits { struct Late { int late; }; }\n")
    package.expect("a header added to a listed folder", LATE, typegen=True, cmake=True)
    package.expect_in_typekit("late")
    (package.source / "src/listed/late.hpp").unlink()
    package.expect("the header removed from the folder", GONE, typegen=True, cmake=True)
    package.expect_in_typekit("late", there=False)
    package.replace("CMakeLists.txt", "pose.hpp", "pose.hpp include/edits/alone.hpp")
    package.expect("an old header added to the list", ALONE, typegen=True, cmake=True)
    package.expect_in_typekit("c")
    package.replace("CMakeLists.txt", " include/edits/alone.hpp", "")
    package.expect("a header removed from the list", GONE, typegen=True, cmake=True)
    package.expect_in_typekit("c", there=False)


def edit_the_build(package):
    package.replace("CMakeLists.txt", "headers(", "headers(-DFOR_TYPEGEN=1 ")
    package.expect("an option of typegen added", [], typegen=True, cmake=True)
    package.replace("CMakeLists.txt", "find_package", "add_definitions(-DFOR_ALL=1)\nfind_package")
    package.expect("an option of the compiler added", EVERYTHING, typegen=True,
                   cmake=True)
    package.touch(package.prefix / "bin/typegen")
    package.expect("another typegen that writes the same", [], typegen=True)
    (package.build / "typekit" / file_of("Pose")).unlink()
    package.expect("a generated file removed by hand", [file_of("Pose")], typegen=True)

    (package.build / "typekit/include/edits/listed/extra.hpp").unlink()
    package.expect("a header removed by hand that CMake made", EXTRA, typegen=False, cmake=True)

    package.replace("include/edits/pose.hpp", "double x;", "double* x;")
    try:
        package.run_build()
    except Failure:
        pass
    else:
        raise Failure(f"{package.generator}: a pointer was generated")
    package.replace("include/edits/pose.hpp", "double* x;", "double x;")
    package.expect("a mistake put right", POSE, typegen=True)


def edit_package(work, prefix, generator):
    package = Package(work, prefix, generator)
    package.expect("the first build", EVERYTHING, typegen=True)
    for edits in (edit_headers, edit_others, edit_what_is_included, edit_the_list, edit_the_build):
        edits(package)
    return package


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    os.environ.update(OROCOS_TARGET="gnulinux")
    for name in ("RTT_COMPONENT_PATH", "PKG_CONFIG_PATH", "CMAKE_PREFIX_PATH"):
        os.environ.pop(name, None)
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        # Of its own, because it is touched.
        prefix = work / "prefix"
        shutil.copytree(sys.argv[1], prefix, copy_function=os.link, symlinks=True)
        (prefix / "bin/typegen").unlink()
        shutil.copy2(pathlib.Path(sys.argv[1]) / "bin/typegen", prefix / "bin/typegen")
        try:
            for generator in sys.argv[2:] or ["Unix Makefiles", "Ninja"]:
                begun = time.monotonic()
                package = edit_package(work, prefix, generator)
                print(f"{generator}: {time.monotonic() - begun:.0f} s")
            package.configure(work / "earnest")
            run(["cmake", "--build", work / "earnest", "--parallel", "2"])
        except Failure as failure:
            sys.exit(f"FAILED: {failure}")


if __name__ == "__main__":
    main()
