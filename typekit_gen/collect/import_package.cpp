// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <collect/import_package.hpp>

#include <cctype>
#include <cstdio>
#include <optional>

#include <flags/flags_file.hpp>

namespace oroforge::typekit {

namespace {

/// Accepts only the characters of pkg-config module names: the name becomes part of a shell command.
bool isModuleName(const std::string& name) {
    for (const char c : name) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && std::string("._+-").find(c) == std::string::npos) {
            return false;
        }
    }
    return !name.empty() && name[0] != '-';
}

std::optional<std::string> askPkgConfig(const std::string& module) {
    std::FILE* pipe = ::popen(("pkg-config --cflags-only-I " + module + " 2>/dev/null").c_str(), "r");
    if (pipe == nullptr) return std::nullopt;
    std::string text;
    for (int c; (c = std::fgetc(pipe)) != EOF;) text += static_cast<char>(c);
    if (::pclose(pipe) != 0) return std::nullopt;
    return text;
}

}  // namespace

std::vector<std::string> importFlags(const std::string& package, const std::string& target, diag::Sink& sink) {
    const std::vector<std::string> modules = {package + "-typekit-" + target, package + "-" + target, package};
    if (isModuleName(package)) {
        for (const std::string& module : modules) {
            if (const auto text = askPkgConfig(module)) return flags::splitFlags(*text);
        }
    }
    sink.error({"typegen"}, "TK004",
               "no package '" + package + "' to import: pkg-config knows none of '" + modules[0] + "', '" + modules[1] +
                   "' and '" + modules[2] + "'")
        .hint("install the package, or add its folder of .pc files to PKG_CONFIG_PATH");
    return {};
}

}  // namespace oroforge::typekit
