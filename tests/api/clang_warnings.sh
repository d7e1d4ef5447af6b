#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# clang_warnings.sh CLANG CONFIG_DIR SOURCE_DIR
# Clang sees no warning in a file that includes all public headers. The build for ./dev asan compiles what users write with it.
set -euo pipefail
clang=$1 config=$2 source=$3
flags=(-fsyntax-only -Wall -Wextra -Wdeprecated -Werror -DOROCOS_TARGET=gnulinux -I"$config" -I"$source/runtime")
export clang
check() { "$clang" "$@" || { echo "FAILED: $clang ${*: -1}"; return 1; }; }
export -f check
all=$(mktemp --suffix=.cpp)
trap 'rm -f "$all"' EXIT
(cd "$source/runtime" && find rtt \( -name '*.hpp' -o -name '*.h' \) -not -path '*/detail/*' | sort) |
  sed 's/.*/#include <&>/' > "$all"
{
  printf -- '-std=c++17 %s\n' "$all"
  printf -- '-std=c++20 %s\n' "$all"
} | xargs -P 2 -L 1 bash -c 'check "$@"' _ "${flags[@]}"
