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
# What an optimised build installs is hardened (docs/design/building.md), and looks for libraries in its own prefix and the
# system's folders only.
readelf=$(command -v readelf) || exit 0
! grep -q '^OROFORGE_HARDENED:BOOL=ON' "$1/CMakeCache.txt" || ! grep -qE '^CMAKE_BUILD_TYPE:[A-Z]*=Rel' "$1/CMakeCache.txt" || hardened=yes
while read -r file; do
  dynamic=$("$readelf" -dW "$file" 2> /dev/null) || continue
  [[ $dynamic == *NEEDED* ]] || continue
  lacking=
  ! grep -E 'R(UN)?PATH' <<< "$dynamic" | sed 's/.*\[\(.*\)\]/\1/' | tr : '\n' | grep -v '^$ORIGIN' || lacking+=" a run path below \$ORIGIN,"
  if [ -n "${hardened:-}" ]; then
    [[ $dynamic == *BIND_NOW* ]] || lacking+=" BIND_NOW,"
    [[ $("$readelf" -lW "$file") == *GNU_RELRO* ]] || lacking+=" RELRO,"
    symbols=$("$readelf" --dyn-syms -W "$file")
    [[ $symbols == *__stack_chk_fail* ]] || lacking+=" a stack protector,"
    # Not all have calls to check; snprintf() is one that these have.
    [[ $file != */@(deployer|rttscript)-* ]] || [[ $symbols == *__snprintf_chk* ]] || lacking+=" _FORTIFY_SOURCE,"
    if [[ $(uname -m) == x86_64 && $file == */deployer-* ]]; then
      objdump -d --disassemble=main "$file" | grep -q endbr64 || lacking+=" marks for jumps,"
    fi
  fi
  [ -z "$lacking" ] || { echo "$file lacks${lacking%,}"; failed=yes; }
done < <(find "$2/bin" "$2/lib" -type f)
[ -z "${failed:-}" ]
