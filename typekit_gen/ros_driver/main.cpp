// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <iostream>

#include "typegen_ros.hpp"

int main(int argc, char** argv) {
    return oroforge::messages::runTypegenRos(std::vector<std::string>(argv + 1, argv + argc), std::cout, std::cerr);
}
