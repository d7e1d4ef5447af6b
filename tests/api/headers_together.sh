#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# headers_together.sh COMPILER STANDARD CONFIG_DIR ROOT:FOLDER…
# One file may include all public headers.
set -euo pipefail
compiler=$1 standard=$2 config=$3
shift 3
flags=(-std="$standard" -fsyntax-only -Wall -Wextra -Werror -DOROCOS_TARGET=gnulinux -I"$config")
for pair in "$@"; do flags+=(-I"${pair%%:*}"); done
for pair in "$@"; do
  (cd "${pair%%:*}" && find "${pair#*:}" \( -name '*.hpp' -o -name '*.h' \) -not -path '*/detail/*' | sort)
done | sed 's/.*/#include <&>/' | "$compiler" "${flags[@]}" -x c++ -
