// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <iostream>

#include "typegen.hpp"

int main(int argc, char** argv) {
    return oroforge::typekit::run(std::vector<std::string>(argv + 1, argv + argc), std::cout, std::cerr);
}
