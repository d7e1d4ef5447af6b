#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# shared_variables.sh <library> <list> <program>
# The linker's list of variables that programs may copy is that of the variables that the library shows, and a program
# that copies them works.
set -euo pipefail
library=$1 list=$2 program=$3
shown=$(nm -DC --defined-only "$library" | awk '$2 ~ /^[BD]$/' | cut -d' ' -f3- | grep -vE '^(vtable|typeinfo|VTT) ' | sort)
listed=$(sed -n 's/^ *"\(.*\)";$/\1/p' "$list" | sort)
if [ "$shown" != "$listed" ]; then
  echo "error: $library shows other variables than $list names:" >&2
  diff <(echo "$listed") <(echo "$shown") >&2 || true
  exit 1
fi
copies=$(readelf -rWC "$program" | grep R_X86_64_COPY || true)
if [[ $copies != *RTT::internal::Reclaimer::epoch_* ]]; then
  echo "error: $program copies no variable of the library, so it tests nothing" >&2
  exit 1
fi
"$program"
