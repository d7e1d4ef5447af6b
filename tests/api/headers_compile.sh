#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# headers_compile.sh COMPILER STANDARD CONFIG_DIR alone|together ROOT:FOLDER…
# alone: every public header compiles by itself, so nobody has to know what to include before it.
# together: one file may include all of them.
set -euo pipefail
compiler=$1 standard=$2 config=$3 how=$4
shift 4
flags=(-std="$standard" -fsyntax-only -Wall -Wextra -Werror -DOROCOS_TARGET=gnulinux -I"$config")
for pair in "$@"; do flags+=(-I"${pair%%:*}"); done
export compiler
headers() {
  for pair in "$@"; do
    (cd "${pair%%:*}" && find "${pair#*:}" \( -name '*.hpp' -o -name '*.h' \) -not -path '*/detail/*' | sort)
  done
}
check() {
  # Compiled through a file that includes it, so that `#pragma once` is no warning.
  echo "#include <$1>" | "$compiler" "${@:2}" -x c++ - || { echo "FAILED: <$1> does not compile alone"; return 1; }
}
export -f check
if [ "$how" = alone ]; then
  headers "$@" | xargs -P 2 -I{} bash -c 'check "$@"' _ {} "${flags[@]}"
else
  headers "$@" | sed 's/.*/#include <&>/' | "$compiler" "${flags[@]}" -x c++ -
fi
