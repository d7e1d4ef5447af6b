// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Records what the last run read and wrote, so that a run that would do the same again need not parse anything.
#ifndef OROFORGE_TYPEKIT_GEN_DRIVER_RUN_RECORD_HPP
#define OROFORGE_TYPEKIT_GEN_DRIVER_RUN_RECORD_HPP

#include <cstdint>
#include <string>
#include <vector>

#include <clang/types/type_reader.hpp>

#include "options.hpp"

namespace oroforge::typekit {

/// A record is a small file for each output folder and typekit, in the folder TYPEGEN_CACHE, else in the user's cache
/// ($XDG_CACHE_HOME or ~/.cache)/oroforge/typegen; never among the outputs, because it has names and times of this
/// machine. TYPEGEN_CACHE= (empty) turns it off, and so does a depfile: then a build system knows when to run. A file
/// counts as unchanged while its time and size are the same. Records not renewed for a month are removed.
class RunRecord {
public:
    RunRecord(const Options& options, const cxx::ParseRequest& request);

    /// True if the last run had the same request, and neither inputs nor outputs have changed since.
    bool isCurrent() const;
    /// `inputs` are all files that were read. Does nothing if there is no folder for records.
    void keep(const std::vector<std::string>& inputs) const;
    void forget() const;

private:
    std::vector<std::string> outputs_;
    std::string request_;  ///< the whole request as one text
    std::string file_;     ///< empty if there is no record
    std::int64_t began_;   ///< ns since the epoch
};

}  // namespace oroforge::typekit

#endif
