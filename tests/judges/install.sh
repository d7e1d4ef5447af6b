#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Installs the libraries that judge recordings and the live window into FOLDER, or with `studio` Foxglove Studio; exit status
# 77, with the reason, if npm or its registry is absent.
set -euo pipefail
{ [ $# = 1 ] || [ "$*" = "$1 studio" ]; } || { echo "usage: install.sh FOLDER [studio]" >&2; exit 2; }
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
lists=$here/${2-.}
for program in node npm; do
  command -v $program > /dev/null || { echo "left out: others do not judge what we write, because $program is not installed"; exit 77; }
done
mkdir -p "$1"
cd "$1"
if [ -d node_modules ] && cmp -s "$lists/package-lock.json" package-lock.json; then exit 0; fi
if ! timeout 60 npm ping > ping.log 2>&1; then
  echo "left out: others do not judge what we write, because npm does not reach its registry:"
  tail -n 3 ping.log
  exit 77
fi
rm -rf node_modules package-lock.json
cp "$lists/package.json" "$here/.npmrc" .
cp "$lists/package-lock.json" package-lock.json
npm ci --ignore-scripts || { rm -f package-lock.json; exit 1; }
