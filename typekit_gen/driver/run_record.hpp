// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What the last run read and wrote, so that a run that would do the same again need not parse anything.
#ifndef OROFORGE_TYPEKIT_GEN_DRIVER_RUN_RECORD_HPP
#define OROFORGE_TYPEKIT_GEN_DRIVER_RUN_RECORD_HPP

#include <cstdint>
#include <string>
#include <vector>

#include <clang/types/type_reader.hpp>

#include "options.hpp"

namespace oroforge::typekit {

/// Kept in the folder TYPEGEN_CACHE, else in the user's cache ($XDG_CACHE_HOME or ~/.cache)/oroforge/typegen, one small file for each
/// output folder and typekit; never among the outputs, for it has names and times of this machine. TYPEGEN_CACHE= (empty)
/// turns it off, and so does a dependency file: then a build system knows when to run. Files count as unchanged while
/// their time and size are the same. Records that nobody has renewed for a month are removed.
class RunRecord {
public:
    RunRecord(const Options& options, const cxx::ParseRequest& request);

    /// The same was asked for, and neither inputs nor outputs have changed since.
    bool isCurrent() const;
    /// `inputs`: all files that were read. Without a place to keep it, nothing happens.
    void keep(const std::vector<std::string>& inputs) const;
    void forget() const;

private:
    std::vector<std::string> outputs_;
    std::string request_;  ///< all that was asked for, as one text
    std::string file_;     ///< empty: there is no record
    std::int64_t began_;   ///< ns since the epoch
};

}  // namespace oroforge::typekit

#endif
