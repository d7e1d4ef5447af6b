// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Finds file and line of machine code.
#ifndef OROFORGE_DEPLOYER_SOURCE_LINES_HPP
#define OROFORGE_DEPLOYER_SOURCE_LINES_HPP

#include <diag/diagnostic.hpp>

#include <map>
#include <string>

namespace OCL::deploy {

/** Looks up places in libraries by the program addr2line, if it is installed and they have debug information. */
class SourceLines {
public:
    struct Place {
        std::string function;
        oroforge::diag::Location where;  // without a line if unknown
    };

    /** Adds the place at `offset` in a library or program to those that find() looks up. */
    void want(const std::string& file, unsigned long offset) { files_[file][offset]; }
    /** Looks up all places that were added, many by one call of addr2line. */
    void find();
    /** A place that was added and looked up. For inlined functions it is that of the function around them. */
    const Place& at(const std::string& file, unsigned long offset) const { return files_.at(file).at(offset); }

private:
    typedef std::map<unsigned long, Place> Places;
    static void ask(const std::string& file, Places& places);

    std::map<std::string, Places> files_;
};

}  // namespace OCL::deploy

#endif
