#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# headers_compile.sh COMPILER STANDARD CONFIG_DIR ROOT:FOLDER…
# Every public header compiles alone: nobody has to know what to include before it.
set -euo pipefail
compiler=$1 standard=$2 config=$3
shift 3
flags=(-std="$standard" -fsyntax-only -Wall -Wextra -Werror -DOROCOS_TARGET=gnulinux -I"$config")
for pair in "$@"; do flags+=(-I"${pair%%:*}"); done
export compiler
check() {
  # Compiled through a file that includes it, so that `#pragma once` is no warning.
  echo "#include <$1>" | "$compiler" "${@:2}" -x c++ - || { echo "FAILED: <$1> does not compile alone"; return 1; }
}
export -f check
for pair in "$@"; do
  (cd "${pair%%:*}" && find "${pair#*:}" \( -name '*.hpp' -o -name '*.h' \) -not -path '*/detail/*' | sort)
done | xargs -P 2 -I{} bash -c 'check "$@"' _ {} "${flags[@]}"
