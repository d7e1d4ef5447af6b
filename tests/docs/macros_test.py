#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
"""docs/cmake.md has every macro that packages may call, and no other: macros_test.py ROOT."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
sources = [file.read_text() for file in sorted(root.glob("cmake/Oro*.cmake")) if not file.name.startswith("Oroforge")]
made = set(re.findall(r"^(?:function|macro)\((oro\w+)", "\n".join(sources), re.M))
page = (root / "docs" / "cmake.md").read_text()
told = set(re.findall(r"\b(oro(?:cos)?_[a-z_]+)\b", re.sub(r"^```.*?^```$", "", page, flags=re.M | re.S)))
for name in sorted(made - told):
    print(f"docs/cmake.md: nothing is said of {name}()")
for name in sorted(told - made):
    print(f"docs/cmake.md: there is no {name}()")
sys.exit(0 if made == told and made else 1)
