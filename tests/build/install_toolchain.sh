#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# install_toolchain.sh BUILD PREFIX: installs the build tree and moves the result to PREFIX.
set -euo pipefail
rm -rf "$2" "$2.staging"
cmake --install "$1" --prefix "$2.staging" > /dev/null
mv "$2.staging" "$2"
# The rest of a user's first steps: every program answers.
for program in typegen orocreate-pkg deployer-gnulinux helloworld-gnulinux; do
  [ ! -e "$2/bin/$program" ] || "$2/bin/$program" --help > /dev/null || { echo "$program --help failed"; exit 1; }
done
# No file that is meant to be read by others names the place it was built or first installed in.
if grep -rIl -e "$1" -e "$2.staging" "$2/include" "$2/lib/cmake" "$2/lib/pkgconfig"; then
  echo "the files above name the build tree or the first prefix"
  exit 1
fi
