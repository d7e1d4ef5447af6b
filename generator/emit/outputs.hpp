// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Files a generator wants to exist.
#ifndef OROFORGE_GENERATOR_EMIT_OUTPUTS_HPP
#define OROFORGE_GENERATOR_EMIT_OUTPUTS_HPP

#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include <diag/sink.hpp>

namespace oroforge::emit {

/// Path relative to the output directory → text. Sorted, so that output never depends on hash or pointer order.
using Outputs = std::map<std::string, std::string>;

struct Written {
    std::vector<std::string> changed;    ///< written, new or different
    std::vector<std::string> unchanged;  ///< left alone: their time stamps stay, so nothing is rebuilt
};

/// Writes all files below `directory`, or none: every text is first written beside its place and only then renamed.
/// False, with an error EMIT001 in the sink, if something could not be written; then all is as before.
bool write(const Outputs& outputs, const std::filesystem::path& directory, diag::Sink& sink,
           Written* written = nullptr);

/// The same for files that begin with a banner (see banner.hpp): one that stands there without a banner is somebody's
/// own, an error EMIT002, and nothing is written.
bool writeGenerated(const Outputs& outputs, const std::filesystem::path& directory, diag::Sink& sink,
                    Written* written = nullptr);

/// What cannot be looked at (a name that is too long, a folder that is closed) counts as missing: writing there says why.
bool exists(const std::filesystem::path& path);
bool isFile(const std::filesystem::path& path);

/// The bytes of a file; nothing if there is none.
std::string textOf(const std::filesystem::path& file);

struct Difference {
    std::string name;
    unsigned line = 0;    ///< the first one that differs; 0 if the file is missing or too long
    std::string message;  ///< "stale: typegen now writes 'x' here"
};

/// What write() would change, without doing it; `tool` is who would write.
std::vector<Difference> compare(const Outputs& outputs, const std::filesystem::path& directory,
                                const std::string& tool);

/// One path per line, `directory` in front.
void listOutputs(std::ostream& out, const Outputs& outputs, const std::filesystem::path& directory);
void listOutputs(std::ostream& out, const std::vector<std::string>& outputs, const std::filesystem::path& directory);

}  // namespace oroforge::emit

#endif
