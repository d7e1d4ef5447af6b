#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# A package written for the original toolchain builds, installs, deploys, and is used by a second package.
source "$(dirname "$0")/package_test.sh"
here=$(cd "$(dirname "$0")" && pwd)

cp -r "$here/packages/classic" "$here/packages/user" "$work"
build_package "$work/classic" "$work/b1" "$work/inst"
lib=$work/inst/lib/orocos/gnulinux/classic
for file in libclassic-gnulinux.so libclassic-pair-gnulinux.so plugins/libclassic-service-gnulinux.so types/libclassic-typekit-gnulinux.so; do
  expect_file "$lib/$file"
done
expect_file "$work/inst/lib/libclassic-support-gnulinux.so"
expect_file "$work/inst/include/orocos/classic/classic-types.hpp"
expect_file "$work/inst/include/orocos/classic/typekit/Types.hpp"

pc=$work/inst/lib/pkgconfig/classic-gnulinux.pc
for library in classic classic-pair classic-service classic-typekit classic-support; do
  expect_text "$pc" "-l$library-gnulinux"
done
expect_text "$pc" 'Version: 1.0'

"$work/inst/bin/classic-main-gnulinux" > "$work/main.out"
expect_text "$work/main.out" 'main: 42'

export RTT_COMPONENT_PATH=$work/inst/lib/orocos
deploy_until 'second: spiral 41' -s "$work/classic/app.xml"

# The build tree is loadable as it is, without an installation.
RTT_COMPONENT_PATH=$work/b1/orocos deploy_until 'second: spiral 41' -s "$work/classic/app.xml"

# A second package, made against the first; both typekits describe the types they share.
PKG_CONFIG_PATH=$work/inst/lib/pkgconfig build_package "$work/user" "$work/b2" "$work/inst"
expect_text "$work/inst/lib/pkgconfig/user-gnulinux.pc" 'Version: 0.2'
expect_text "$work/inst/lib/pkgconfig/user-gnulinux.pc" 'classic-gnulinux'
sed 's|<value>classic</value>|<value>user</value></simple><simple name="Import" type="string"><value>classic</value>|' \
  "$work/classic/app.xml" > "$work/both.xml"
deploy_until 'second: spiral 41' -s "$work/both.xml"
! grep -i 'already in use' "$work/deploy.out" || fail "the two typekits quarrel about a type"
