#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Copyright Oroforge contributors
# A package that finds rtt_ros and nothing else has the macros orocos_component() and so on: as a component of catkin, without
# catkin, and as rosbuild built packages. Programs import what was built by the name of the package. So does roslaunch what
# orocreate-catkin-pkg makes.
source "$(dirname "$0")/package_test.sh"
[ -d "$prefix/share/rtt_ros" ] || { echo "this toolchain was built without ROS"; exit 77; }
python3=/usr/bin/python3
"$python3" -c 'import catkin_pkg' || { echo "catkin is not installed"; exit 77; }
cd "$work"
mkdir -p ws/src/robot_arm
cd ws/src/robot_arm
cat > package.xml << 'TXT'
<package format="2">
  <name>robot_arm</name><version>1.0.0</version><description>arm</description>
  <maintainer email="someone@example.org">someone</maintainer><license>none</license>
  <buildtool_depend>catkin</buildtool_depend><depend>rtt_ros</depend>
  <export><rtt_ros><plugin_depend>rtt_rospack</plugin_depend></rtt_ros></export>
</package>
TXT
cat > arm.cpp << 'TXT'
#include <rtt/Component.hpp>
#include <rtt_ros/rtt_ros.h>
struct Arm : RTT::TaskContext {
    explicit Arm(const std::string& name) : TaskContext(name) {}
    bool configureHook() override { return rtt_ros::import("rtt_rospack"); }
};
ORO_CREATE_COMPONENT(Arm)
TXT
cat > CMakeLists.txt << 'TXT'
cmake_minimum_required(VERSION 3.5)
project(robot_arm)
if(WITHOUT_CATKIN)
  find_package(rtt_ros REQUIRED)
else()
  find_package(catkin REQUIRED COMPONENTS rtt_ros)
endif()
include_directories(${catkin_INCLUDE_DIRS} ${rtt_ros_INCLUDE_DIRS})
orocos_component(arm arm.cpp)
target_link_libraries(arm ${rtt_ros_LIBRARIES} ${catkin_LIBRARIES})
find_package(rtt_ros REQUIRED)  # again does no harm
orocos_generate_package()
message(STATUS "output ${ORO_COMPONENT_OUTPUT_DIRECTORY}")
TXT
cd "$work"
build() { # folder option…
  local folder=$1
  shift
  rm -rf "$folder"
  cmake -S ws/src/robot_arm -B "$folder" -Wno-dev -Wno-deprecated -DPYTHON_EXECUTABLE="$python3" \
    -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_INSTALL_PREFIX="$work/inst" "$@" > b.log 2>&1 && cmake --build "$folder" > build.log 2>&1 ||
    { cat b.log build.log; fail "$folder"; }
}
cat > app.ops << 'TXT'
import("rtt_ros")
loadService("Deployer", "print")
ros.import("robot_arm")
loadComponent("one", "Arm")
if one.configure() then print.ln("found in " + ros.find("robot_arm"))
TXT
run() { # what
  timeout 60 rttscript -s app.ops > run.log 2>&1 || { cat run.log; fail "$1"; }
  expect_text run.log "found in $work"
}
export ROS_PACKAGE_PATH=$work/ws/src

build b_catkin
expect_file b_catkin/devel/lib/orocos/gnulinux/robot_arm/libarm-gnulinux.so
CMAKE_PREFIX_PATH=$work/b_catkin/devel:$prefix run "the devel space of catkin"

build b_plain -DWITHOUT_CATKIN=ON
cmake --install b_plain > b.log
expect_file inst/lib/orocos/gnulinux/robot_arm/libarm-gnulinux.so
CMAKE_PREFIX_PATH=$work/inst:$prefix run "an installed package"

rm -r ws/src/robot_arm/package.xml
echo '<package><export><rtt_ros><plugin_depend>rtt_rospack</plugin_depend></rtt_ros></export></package>' > ws/src/robot_arm/manifest.xml
build b_rosbuild -DWITHOUT_CATKIN=ON -DORO_USE_ROSBUILD=ON
expect_file ws/src/robot_arm/lib/orocos/gnulinux/robot_arm/libarm-gnulinux.so
CMAKE_PREFIX_PATH=$prefix run "a rosbuild package"

# A package with topics: its tests, its launch file, and its topics for the tools of ROS.
rm -r ws/src/robot_arm
(cd ws/src && orocreate-catkin-pkg my-leg topics --namespace robots > "$work/b.log")
build_leg() { # folder testing option…
  local folder=$1 testing=$2
  shift 2
  cmake -S ws/src/my-leg -B "$folder" -G Ninja -Wno-dev -Wno-deprecated -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_INSTALL_PREFIX="$work/leg" \
    -DCMAKE_CXX_FLAGS='-O0 -Wall -Wextra -Wconversion -Werror' "$@" -DBUILD_TESTING=$testing > b.log 2>&1 &&
    cmake --build "$folder" > build.log 2>&1 || { cat b.log build.log; fail "a package with topics: $folder"; }
}
build_leg b_leg_catkin OFF -DCATKIN_DEVEL_PREFIX="$work/b_leg_catkin/devel"  # as catkin_make and the like have it
build_leg b_leg_plain ON
ctest --test-dir b_leg_plain > b.log || { cat b.log; fail "the test of the package with topics"; }
expect_text b.log 'my-leg-topics-test.My_legTopics.AnswersEachCommand'
cmake --install b_leg_plain > b.log
command -v roslaunch > /dev/null || { echo "roslaunch is not installed"; exit 77; }
port=$("$python3" -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
export PATH=/usr/bin:$PATH ROS_MASTER_URI=http://127.0.0.1:$port ROS_IP=127.0.0.1 ROS_HOME=$work
launched() { # folder of the package, folder of its libraries
  ROS_PACKAGE_PATH=$1:$prefix/share CMAKE_PREFIX_PATH=$2:$prefix timeout -s INT 60 roslaunch my-leg my-leg.launch > launch.log 2>&1 &
  local pid=$!
  for _ in $(seq 600); do
    rostopic info /my_leg/state > info.log 2>&1 && break
    kill -0 $pid || { cat launch.log; fail "roslaunch of $1"; }
    sleep 0.1
  done
  timeout 60 rostopic pub -1 /my_leg/command std_msgs/Float64 2.5 > pub.log &
  timeout 60 rostopic echo -n 1 /my_leg/state > echo.log || { cat launch.log; fail "no message from $1"; }
  expect_text echo.log 'data: 2.5'
  wait $!
  kill -INT $pid
  wait $pid || { cat launch.log; fail "roslaunch ended with $?"; }
}
launched "$work/ws/src" "$work/b_leg_catkin/devel"
launched "$work/leg/share" "$work/leg"
