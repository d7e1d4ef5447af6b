#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# A package that logs by categories, with CMake macros and by pkg-config alone; a program of its own that installs the
# factory; an appender of its own.
source "$(dirname "$0")/package_test.sh"
export ORO_LOGFILE=/dev/null
mkdir "$work/pkg"
cat > "$work/pkg/CMakeLists.txt" << 'TXT'
cmake_minimum_required(VERSION 3.5)
project(logs CXX)
find_package(OROCOS-RTT REQUIRED)
include(${OROCOS-RTT_USE_FILE_PATH}/UseOROCOS-RTT.cmake)
orocos_use_package(ocl-logging REQUIRED)
orocos_component(logs own.cpp)
orocos_executable(logs-main main.cpp)
orocos_generate_package()
TXT
cat > "$work/pkg/own.cpp" << 'TXT'
#include <log4cpp/OstreamAppender.hh>
#include <ocl/Appender.hpp>
#include <rtt/Component.hpp>
#include <iostream>

struct Own : OCL::logging::Appender {
    explicit Own(std::string name) : Appender(name) {}
    ~Own() override {
        stopForGood();
        delete appender;
    }
    bool configureHook() override {
        delete appender;
        appender = new log4cpp::OstreamAppender(getName(), &std::cout);
        return configureLayout();
    }
    void updateHook() override { processEvents(0); }
};
ORO_CREATE_COMPONENT(Own)
TXT
cat > "$work/pkg/main.cpp" << 'TXT'
#include <ocl/Category.hpp>
#include <ocl/LoggingService.hpp>
#include <ocl/OstreamAppender.hpp>
#include <rtt/os/main.h>
#include <iostream>

int ORO_main(int, char**) {
    if (!OCL::logging::Category::installFactory()) return 1;
    auto* const category = dynamic_cast<OCL::logging::Category*>(&log4cpp::Category::getInstance("a.b"));
    if (!category) return 2;
    OCL::logging::OstreamAppender out("out");
    OCL::logging::LoggingService service("service");
    service.addPeer(&out);
    RTT::PropertyBag& appenders = dynamic_cast<RTT::Property<RTT::PropertyBag>*>(service.getProperty("Appenders"))->value();
    appenders.ownProperty(new RTT::Property<std::string>("a", "", "out"));
    if (!service.configure() || !out.configure() || !out.start()) return 3;
    category->info("hello from a program");
    out.stop();
    return 0;
}
TXT
build_package "$work/pkg" "$work/b" "$work/inst" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Woverloaded-virtual -Werror"
"$work/inst/bin/logs-main-gnulinux" > "$work/out"
expect_text "$work/out" 'a.b : hello from a program'
rm "$work/out"

cat > "$work/app.xml" << 'TXT'
<properties>
  <simple name="Import" type="string"><value>ocl</value></simple>
  <simple name="Import" type="string"><value>logs</value></simple>
  <struct name="own" type="Own">
    <simple name="AutoConf" type="boolean"><value>1</value></simple>
    <simple name="AutoStart" type="boolean"><value>1</value></simple>
  </struct>
</properties>
TXT
RTT_COMPONENT_PATH=$work/inst/lib/orocos:$prefix/lib/orocos rttscript -s "$work/app.xml" > "$work/out" 2>&1 || { cat "$work/out"; fail "an appender of its own"; }
expect_text "$work/out" '# countMaxPopped=0'
rm "$work/out"

# By hand.
export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
# shellcheck disable=SC2046
"${CXX:-c++}" -std=c++17 "$work/pkg/main.cpp" -o "$work/by_hand" $(pkg-config --cflags --libs ocl-logging-gnulinux) \
  -Wl,-rpath,"$prefix/lib" -Wl,-rpath,"$prefix/lib/orocos/gnulinux/ocl" || fail "pkg-config ocl-logging-gnulinux"
"$work/by_hand" > "$work/out"
expect_text "$work/out" 'a.b : hello from a program'
