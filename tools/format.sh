#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# clang-format over all sources of the tree; with --check nothing is written and a difference is an error.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
options=(-i)
case ${1:-} in
  "") ;;
  --check) options=(--dry-run --Werror) ;;
  *) echo "format.sh: error: unknown argument '$1', expected --check or nothing" >&2; exit 2 ;;
esac
# Goldens are byte for byte what the tools write; packages under tests/build and examples are what users write.
find runtime deployer generator typekit_gen tests bench \( -path tests/golden -o -path tests/build \) -prune \
  -o \( -name '*.[ch]pp' -o -name '*.inl' \) -print0 | xargs -0 -r clang-format "${options[@]}"
