// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Lines of source files, read when they are first asked for.
#ifndef OROFORGE_DIAG_SOURCE_CACHE_HPP
#define OROFORGE_DIAG_SOURCE_CACHE_HPP

#include <map>
#include <string>
#include <vector>

namespace oroforge::diag {

class SourceCache {
public:
    /// Makes `text` the content of the file `name`, which need not be on disk.
    void add(const std::string& name, const std::string& text);

    /// Line `number` (from 1) without its line end; null if there is no such file or line. Valid as long as the cache,
    /// or until the file is added anew.
    const std::string* line(const std::string& file, unsigned number);

private:
    using Lines = std::vector<std::string>;
    const Lines& linesOf(const std::string& file);
    std::map<std::string, Lines> files_;
};

}  // namespace oroforge::diag

#endif
