// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "resource_dir.hpp"

#include <cstdlib>
#include <filesystem>

namespace fs = std::filesystem;

namespace oroforge::cxx {

namespace {

bool holdsBuiltinHeaders(const fs::path& dir) {
    std::error_code ignored;
    return fs::exists(dir / "include/stddef.h", ignored);
}

}  // namespace

std::optional<std::string> findResourceDir(const std::string& wanted, diag::Sink& sink) {
    const char* set = std::getenv("TYPEGEN_RESOURCE_DIR");
    const std::string choice = !wanted.empty() ? wanted : set != nullptr ? set : "";
    for (const std::string& dir : {choice, std::string(OROFORGE_CLANG_RESOURCE_DIR)}) {
        if (!dir.empty() && holdsBuiltinHeaders(dir)) return dir;
        if (!choice.empty()) break;  // the user's choice is wrong: do not silently take another
    }
    const std::string missing = choice.empty() ? OROFORGE_CLANG_RESOURCE_DIR : choice;
    sink.error({"typegen"}, "TK005", "no compiler headers (include/stddef.h) in " + missing)
        .hint(
            "install the package libclang-common-19-dev, or set TYPEGEN_RESOURCE_DIR to what "
            "'clang-19 -print-resource-dir' prints");
    return std::nullopt;
}

}  // namespace oroforge::cxx
