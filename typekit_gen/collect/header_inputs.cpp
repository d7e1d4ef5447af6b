// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <collect/header_inputs.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

namespace fs = std::filesystem;

namespace oroforge::typekit {

namespace {

bool isHeader(const fs::path& file) {
    const std::string extension = file.extension().string();
    const bool known = extension == ".h" || extension == ".hh" || extension == ".hpp" || extension == ".hxx";
    return known && file.filename().string().find("Typekit") == std::string::npos;
}

/// Hidden folders (.git) and build trees: headers in a build tree are copies of those that are read, or made from them.
bool isLeftOut(const fs::path& folder) {
    std::error_code ignored;
    return folder.filename().string()[0] == '.' || fs::exists(folder / "CMakeCache.txt", ignored);
}

std::vector<std::string> headersBelow(const fs::path& folder) {
    std::vector<std::string> found;
    std::error_code error;
    const auto end = fs::recursive_directory_iterator();
    auto it = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, error);
    for (; !error && it != end; it.increment(error)) {
        std::error_code ignored;
        if (it->is_directory(ignored)) {
            if (isLeftOut(it->path())) it.disable_recursion_pending();
        } else if (it->is_regular_file(ignored) && isHeader(it->path())) {
            found.push_back(it->path().generic_string());
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

fs::path resolved(const fs::path& path) {
    std::error_code error;
    const fs::path real = fs::weakly_canonical(path, error);
    return error ? fs::absolute(path) : real;
}

/// Returns "demo/types.hpp" if `header` is below `folder`.
std::optional<std::string> below(const fs::path& header, const fs::path& folder) {
    const fs::path relative = header.lexically_relative(folder);
    if (relative.empty() || *relative.begin() == ".." || relative == ".") return std::nullopt;
    return relative.generic_string();
}

/// A header may be listed twice: by its own name, and by its folder.
std::vector<std::string> withoutRepeated(const std::vector<std::string>& headers) {
    std::vector<std::string> once;
    std::set<fs::path> seen;
    for (const std::string& header : headers)
        if (seen.insert(fs::absolute(header).lexically_normal()).second) once.push_back(header);
    return once;
}

bool beginsWith(const std::string& text, const std::string& start) { return text.compare(0, start.size(), start) == 0; }

}  // namespace

std::vector<std::string> expandInputs(const std::vector<std::string>& inputs, diag::Sink& sink) {
    std::vector<std::string> headers;
    for (const std::string& input : inputs) {
        std::error_code ignored;
        if (fs::is_directory(input, ignored)) {
            const auto found = headersBelow(input);
            if (found.empty()) sink.error({input}, "TK002", "no headers (*.h, *.hh, *.hpp, *.hxx) in this folder");
            headers.insert(headers.end(), found.begin(), found.end());
        } else if (fs::exists(input, ignored)) {
            headers.push_back(input);
        } else {
            sink.error({input}, "TK001", "no such header, expected a file or a folder of headers");
            headers.push_back(input);
        }
    }
    return withoutRepeated(headers);
}

std::vector<std::string> includeDirsOf(const std::vector<std::string>& flags) {
    std::vector<std::string> dirs;
    for (std::size_t i = 0; i < flags.size(); ++i) {
        for (const std::string option : {"-isystem", "-I"}) {
            if (!beginsWith(flags[i], option)) continue;
            std::string dir = flags[i].substr(option.size());
            if (dir.empty() && i + 1 < flags.size()) dir = flags[++i];
            if (!dir.empty()) dirs.push_back(dir);
            break;
        }
    }
    return dirs;
}

std::string includeSpelling(const std::string& header, const std::vector<std::string>& includeDirs,
                            const std::string& package) {
    std::vector<std::string> spellings;
    // The paths are compared as written first: code includes a symlinked tree by the names that the user sees.
    for (const std::string& dir : includeDirs) {
        auto spelling = below(fs::absolute(header).lexically_normal(), fs::absolute(dir).lexically_normal());
        if (!spelling) spelling = below(resolved(header), resolved(dir));
        if (!spelling) continue;
        if (beginsWith(*spelling, package + "/")) return *spelling;
        spellings.push_back(*spelling);
    }
    const std::string full = fs::absolute(header).lexically_normal().generic_string();
    const std::size_t ownFolder = full.rfind("/include/" + package + "/");
    if (ownFolder != std::string::npos) return full.substr(ownFolder + 9);
    if (!spellings.empty()) return spellings.front();
    const std::size_t folder = full.rfind("/include/");
    if (folder != std::string::npos) return full.substr(folder + 9);
    return below(full, fs::current_path()).value_or(fs::path(full).filename().string());
}

std::vector<model::Header> findHeaders(const std::vector<std::string>& inputs, const std::vector<std::string>& flags,
                                       const std::string& package, diag::Sink& sink) {
    std::vector<model::Header> headers;
    const auto dirs = includeDirsOf(flags);
    for (const std::string& path : expandInputs(inputs, sink)) {
        headers.push_back({path, includeSpelling(path, dirs, package)});
    }
    return headers;
}

}  // namespace oroforge::typekit
