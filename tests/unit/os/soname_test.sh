#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# soname_test.sh <library> <soname>: what is linked with a library asks for its minor version, not for the patch.
set -euo pipefail
found=$(readelf -d "$1" | sed -n 's/.*(SONAME).*\[\(.*\)\]/\1/p')
[ "$found" = "$2" ] || { echo "$1 has the SONAME '$found', expected '$2'"; exit 1; }
[ -e "$(dirname "$1")/$2" ] || { echo "there is no $2 beside $1"; exit 1; }
