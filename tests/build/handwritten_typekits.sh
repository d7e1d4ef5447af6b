#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# Typekits written by hand build as packages, with nothing but find_package(OROCOS-RTT), and are imported by a deployer.
source "$(dirname "$0")/package_test.sh"
here=$(cd "$(dirname "$0")" && pwd)

cat > "$work/app.xml" <<'EOF'
<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE properties SYSTEM "cpf.dtd">
<properties>
  <simple name="Import" type="string"><value>linear_typekit</value></simple>
  <simple name="Import" type="string"><value>kinematics_typekit</value></simple>
</properties>
EOF
for typekit in linear kinematics; do
  cp -r "$here/handwritten_typekit/$typekit" "$work"
  build_package "$work/$typekit" "$work/build_$typekit" "$work/inst"
  expect_file "$work/inst/lib/orocos/gnulinux/${typekit}_typekit/types/lib${typekit}_typekit-gnulinux.so"
  expect_file "$work/inst/include/orocos/${typekit}_typekit/$typekit.hpp"
done
export RTT_COMPONENT_PATH=$work/inst/lib/orocos
deploy_until "typekit 'KDL'" -linfo -s "$work/app.xml"
expect_text "$work/deploy.out" "typekit 'Linear'"
