#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# debian_packages.sh BUILD: the Debian packages of this build are installed by apt into a bare system, and there an ordinary
# user takes the first steps, as docs/getting_started.md tells them: scaffold, generate, build, test, deploy. Needs root,
# debootstrap and a mirror of Debian.
set -euo pipefail
build=$1
source=$(cd "$(dirname "$0")/../.." && pwd)
skip() { echo "SKIPPED: $*"; exit 77; }
fail() { echo "FAILED: $*" >&2; exit 1; }
mirror=${DEBIAN_MIRROR:-http://deb.debian.org/debian}
[ "$(id -u)" = 0 ] || skip "debootstrap needs root"
command -v debootstrap > /dev/null || skip "no debootstrap (./dev stress installs it)"
if [ "${OWN_MOUNTS:-}" != yes ]; then
  # What is mounted below is gone when the script ends, however it ends.
  OWN_MOUNTS=yes exec unshare --mount --propagation private "$0" "$@"
fi
root=$(mktemp -d)
chmod 755 "$root"
trap 'umount -l "$root/proc" "$root/dev" 2> /dev/null; rm -rf --one-file-system "$root"' EXIT

echo "== the packages"
rm -rf "$build/packages"
(cd "$build" && cpack > packages.log 2>&1) || { cat "$build/packages.log"; fail "cpack"; }
parts=(runtime dev tools)
for part in netcdf ros; do  # of a build with their libraries
  for file in "$build"/packages/oroforge-"$part"_*.deb; do
    [ ! -f "$file" ] || parts+=("$part")
  done
done
for part in "${parts[@]}"; do
  file=$(echo "$build"/packages/oroforge-"$part"_*.deb)
  [ -f "$file" ] || fail "no package oroforge-$part"
  dpkg-deb --field "$file" Package Version Depends Installed-Size
  [ -z "$(dpkg-deb --contents "$file" | awk '$6 !~ /^\.\/(usr\/.*|etc\/(profile\.d\/(oroforge\.sh)?)?)?$/')" ] ||
    fail "oroforge-$part has files outside of /usr"
done
contents() { dpkg-deb --contents "$(echo "$build"/packages/oroforge-"$1"_*.deb)"; }
expect_packaged() { # part file
  [[ $(contents "$1") == *" .$2"$'\n'* ]] || fail "no $2 in oroforge-$1"
}
expect_packaged runtime /usr/bin/deployer-gnulinux
expect_packaged runtime /usr/bin/oro
expect_packaged runtime /usr/share/man/man1/oro.1.gz
expect_packaged runtime /usr/share/bash-completion/completions/oro
expect_packaged runtime /etc/profile.d/oroforge.sh
expect_packaged tools /usr/bin/typegen
expect_packaged dev /usr/include/rtt/TaskContext.hpp
# Together they are all of an installation, but for env.sh.
for part in "${parts[@]}"; do contents "$part"; done | awk '$6 ~ /[^\/]$/ && $6 !~ /share\/doc|^\.\/etc\// { print substr($6, 7) }' | sort > "$root/packaged"
cmake --install "$build" --prefix "$root/all" > /dev/null
(cd "$root/all" && find . -not -type d -not -name env.sh | sed 's|^\./||' | sort) | diff - "$root/packaged" || fail "the packages are not what is installed"
rm -r "$root/all" "$root/packaged"
if command -v lintian > /dev/null; then
  # Names of libraries and of packages differ on purpose: they are those of the original, or all of a kind in one package.
  lintian --no-cfg --allow-root --fail-on error --suppress-tags "$(echo dir-or-file-in-opt custom-library-search-path shared-library-lacks-prerequisites \
    package-name-doesnt-match-sonames copyright-without-copyright-notice | tr ' ' ',')" "$build"/packages/*.deb || fail "lintian"
fi

echo "== a bare system"
debootstrap --variant=minbase "$(. /etc/os-release && echo "$VERSION_CODENAME")" "$root" "$mirror" > "$build/debootstrap.log" 2>&1 || {
  tail -n 5 "$build/debootstrap.log"
  grep -qiE 'couldn.t (download|resolve)|failed getting|invalid release' "$build/debootstrap.log" "$root/debootstrap/debootstrap.log" 2> /dev/null &&
    skip "the mirror $mirror does not answer"
  fail "debootstrap"
}
mount -t proc proc "$root/proc"
mount --bind /dev "$root/dev"
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
mkdir "$root/packages"
cp "$build"/packages/*.deb "$root/packages"
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 "$@"; }
inside apt-get update -q > /dev/null
# With what they recommend of each other, but not with all that compilers recommend.
inside sh -c 'apt-get install -y -q --no-install-recommends /packages/*.deb make python3' > "$build/apt.log" 2>&1 || { tail -n 40 "$build/apt.log"; fail "apt-get install"; }
[ -z "$(inside dpkg --audit)" ] || fail "dpkg finds the installation incomplete"

echo "== a user's first steps"
cp "$source/tests/docs/run_guide.py" "$source/docs/getting_started.md" "$root/packages"
cat > "$root/packages/steps" << 'TXT'
#!/bin/sh
set -e
cd "$HOME"
python3 /packages/run_guide.py /usr /packages/getting_started.md
# Nothing has to be set: programs, CMake and pkg-config find what lies in /usr, and a login shell knows the target.
orocreate-pkg mypkg component typekit
cmake -S mypkg -B build -DCMAKE_INSTALL_PREFIX="$HOME/inst" -DBUILD_TESTING=OFF
cmake --build build --target install
pkg-config --exists --print-errors orocos-rtt-gnulinux ocl-gnulinux
cat > app.ops << 'OPS'
import("mypkg")
loadComponent("one", "Mypkg")
one.configure()
one.start()
OPS
sleep 3 | RTT_COMPONENT_PATH=$HOME/inst/lib/orocos timeout 60 deployer -linfo -s app.ops > deploy.out 2>&1
grep Mypkg deploy.out
TXT
chmod 755 "$root/packages/steps"
inside useradd --create-home robot
# Other shells are told what to type.
status=0
inside deployer --help > "$root/refused" 2>&1 || status=$?
[ "$status" = 1 ] || fail "the wrapper ended with $status without a target"
grep -q 'export OROCOS_TARGET=gnulinux' "$root/refused" || fail "the wrapper does not say what to type"
inside su - robot -c /packages/steps > "$build/steps.log" 2>&1 || { cat "$build/steps.log"; fail "the first steps"; }

echo "== and away again"
inside sh -c 'apt-get purge -y -q "oroforge-*"' > "$build/apt.log" 2>&1 || { cat "$build/apt.log"; fail "apt-get purge"; }
[ ! -e "$root/etc/profile.d/oroforge.sh" ] || fail "the settings of shells stay behind"
[ -z "$(find "$root/usr" -name '*orocos*' -o -name typegen)" ] || fail "files stay behind"
