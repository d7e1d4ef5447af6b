// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// File and line of machine code.
#ifndef OROFORGE_DEPLOYER_SOURCE_LINES_HPP
#define OROFORGE_DEPLOYER_SOURCE_LINES_HPP

#include <diag/diagnostic.hpp>

#include <map>
#include <string>

namespace OCL::deploy {

/** What the program addr2line tells of places in libraries, as far as it is there and they have debug information. */
class SourceLines {
public:
    struct Place {
        std::string function;
        oroforge::diag::Location where;  // without a line: not known
    };

    /** Asks for the place at `offset` in a library or program. */
    void want(const std::string& file, unsigned long offset) { files_[file][offset]; }
    /** Finds all that were asked for, with one call of addr2line for many. */
    void find();
    /** Of a place that was asked for, and found. Where functions were inlined it is that of the one they were inlined into. */
    const Place& at(const std::string& file, unsigned long offset) const { return files_.at(file).at(offset); }

private:
    typedef std::map<unsigned long, Place> Places;
    static void ask(const std::string& file, Places& places);

    std::map<std::string, Places> files_;
};

}  // namespace OCL::deploy

#endif
