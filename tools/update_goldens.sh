#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Rewrites the expected files of the golden tests from what the tools write now; argument: a filter on test names.
# Read the difference before committing it: `git diff tests/golden`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
if [ -n "${CI:-}" ]; then
  echo "update_goldens.sh: error: CI is set; goldens are never rewritten there" >&2
  exit 2
fi
./dev build tests-golden
UPDATE_GOLDENS=1 ctest --test-dir build/dev --output-on-failure --no-tests=error -L golden ${1:+-R "$1"}
git --no-pager diff --stat -- tests/golden
