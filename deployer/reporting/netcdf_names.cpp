// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "netcdf_names.hpp"

#include <cstddef>

namespace OCL::reporting {
namespace {

/** Of the 256 characters that NetCDF allows, some are for a number, and for what the name of a dimension adds. */
constexpr std::size_t kLongest = 230;

bool isLetterOrDigit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

std::string allowed(const std::string& wanted) {
    std::string name = wanted.substr(0, kLongest);
    // UTF-8 is allowed, but only in a normal form, which nothing here could make. Blanks are allowed, but programs
    // that read NetCDF have commands in which names cannot have them.
    for (char& c : name)
        if (c <= ' ' || c >= '\x7f' || c == '/') c = '_';
    if (name.empty() || (!isLetterOrDigit(name.front()) && name.front() != '_')) name.insert(0, 1, '_');
    return name;
}

}  // namespace

std::string NetcdfNames::take(const std::string& wanted) {
    const std::string base = allowed(wanted);
    std::string name = base;
    for (int number = 2; !taken_.insert(name).second; ++number) name = base + '_' + std::to_string(number);
    return name;
}

}  // namespace OCL::reporting
