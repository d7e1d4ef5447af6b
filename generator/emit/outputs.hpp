// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// The files that a generator writes.
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

/// Writes all files below `directory`, or none: every text is first written beside its place and only then renamed. If
/// a file cannot be written, returns false with an error EMIT001, and all files are as before.
bool write(const Outputs& outputs, const std::filesystem::path& directory, diag::Sink& sink,
           Written* written = nullptr);

/// Does the same for files that begin with a banner (see banner.hpp): an existing file without a banner belongs to the
/// user, so it is an error EMIT002, and nothing is written.
bool writeGenerated(const Outputs& outputs, const std::filesystem::path& directory, diag::Sink& sink,
                    Written* written = nullptr);

/// A path that cannot be examined (name too long, folder not readable) counts as missing: writing it reports why.
bool exists(const std::filesystem::path& path);
bool isFile(const std::filesystem::path& path);

/// Returns the bytes of a file; nothing if it does not exist.
std::string textOf(const std::filesystem::path& file);

struct Difference {
    std::string name;
    unsigned line = 0;    ///< first line that differs; 0 if the file is missing or too long
    std::string message;  ///< "stale: typegen now writes 'x' here"
};

/// Returns what write() would change; `tool` is the program's name in the messages.
std::vector<Difference> compare(const Outputs& outputs, const std::filesystem::path& directory,
                                const std::string& tool);

/// Prints one path per line, with `directory` in front.
void listOutputs(std::ostream& out, const Outputs& outputs, const std::filesystem::path& directory);
void listOutputs(std::ostream& out, const std::vector<std::string>& outputs, const std::filesystem::path& directory);

}  // namespace oroforge::emit

#endif
