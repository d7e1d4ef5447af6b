// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Logging by categories, in the programs.
#ifndef OROFORGE_CATEGORIES_HPP
#define OROFORGE_CATEGORIES_HPP

#include <string>

namespace OCL::deploy {

/** Lets log4cpp make the categories that real-time threads log to, and configures it by this property file, unless its
    name is empty. The reason if that fails. With `checkOnly` it only looks whether the file can be read. Call it before
    there are components. */
std::string prepareCategories(const std::string& file, bool checkOnly);

}  // namespace OCL::deploy

#endif
