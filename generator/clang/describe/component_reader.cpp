// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "component_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include <clang/base/diagnostic_bridge.hpp>
#include <clang/base/parse_files.hpp>
#include <clang/base/resource_dir.hpp>
#include <clang/base/toolchain_flags.hpp>

#include "describe_component.hpp"

namespace fs = std::filesystem;

namespace oroforge::cxx {

namespace {

using Files = std::vector<std::string>;

constexpr const char* kProgram = "orocreate-pkg";

bool isSource(const fs::path& file) {
    static const std::set<std::string> known = {".cpp", ".cc", ".cxx", ".c++", ".C"};
    return known.count(file.extension().string()) != 0;
}

bool isFile(const fs::path& file) {
    std::error_code ignored;
    return fs::is_regular_file(file, ignored);
}

bool contains(const Files& files, const fs::path& file) {
    return std::any_of(files.begin(), files.end(), [&](const std::string& one) {
        std::error_code ignored;
        return one == file.string() || fs::equivalent(one, file, ignored);
    });
}

/// Returns the source with a header's functions, in the usual places of packages; empty if there is none.
fs::path sourceOf(const fs::path& header) {
    if (isSource(header)) return {};
    Files folders = {"", "../src", "../../src", "src"};
    for (const std::string& folder : folders) {
        for (const char* extension : {".cpp", ".cc", ".cxx"}) {
            const fs::path file =
                (header.parent_path() / folder / (header.stem().string() + extension)).lexically_normal();
            if (isFile(file)) return file;
        }
    }
    return {};
}

void addSources(const Files& headers, Files& files) {
    for (const std::string& header : headers) {
        const fs::path source = sourceOf(header);
        if (!source.empty() && !contains(files, source)) files.push_back(source.string());
    }
}

/// Returns the folders that a package's own build searches: those of the files, and the package's include/ folder.
Files ownFolders(const Files& files) {
    Files flags;
    const auto add = [&](const fs::path& folder) {
        const std::string name = folder.empty() ? "." : folder.string();
        std::error_code ignored;
        if (fs::is_directory(name, ignored) && std::find(flags.begin(), flags.end(), name) == flags.end())
            flags.insert(flags.end(), {"-I", name});
    };
    for (const std::string& file : files) {
        const fs::path folder = fs::path(file).parent_path();
        add(folder);
        add((folder / "../include").lexically_normal());
        for (fs::path above = folder; above.has_relative_path(); above = above.parent_path()) {
            if (above.filename() == "include") add(above);
        }
    }
    return flags;
}

struct Reading {
    model::Package package;
    diag::Sink errors;
    diag::Sink remarks;
    std::set<std::string> incomplete;
};

class Reader {
public:
    Reader(const ComponentFiles& request, std::string resourceDir)
        : request_(request), resourceDir_(std::move(resourceDir)) {}

    /// Reads the files as one text. A header that a source includes is not included twice.
    Reading read(const Files& files, const Files& shown) const {
        Reading reading;
        std::vector<model::Header> listed;
        for (const std::string& file : shown) listed.push_back({file, file});
        const SourcePlaces places(listed, kProgram);
        DiagnosticBridge bridge(places, reading.errors, files.back());
        bridge.hintAtMissingFile(request_.missingHint);
        Parse parse;
        parse.mainFile = kMainFile;
        parse.files[kMainFile] = mainText(files);
        parse.flags = flagsFor(shown);
        parse.resourceDir = resourceDir_;
        parse.messages = &bridge;
        parse.skipsBody = isLibrary;
        parse.end = [&](clang::Sema& sema) {
            if (!reading.errors.hadErrors()) describe(sema, places, reading);
        };
        const bool started = parseFiles(parse);
        if (!started && !reading.errors.hadErrors())
            reading.errors.error({kProgram}, "OC027", "the compiler could not be started on these files");
        return reading;
    }

private:
    static std::string mainText(const Files& files) {
        std::string text;
        for (const std::string& file : files) {
            const fs::path source = sourceOf(file);
            if (source.empty() || !contains(files, source)) text += "#include \"" + file + "\"\n";
        }
        return text;
    }

    Files flagsFor(const Files& files) const {
        Files flags = {"-D", "OROCOS_TARGET=" + request_.target};
        flags.insert(flags.end(), request_.flags.begin(), request_.flags.end());
        // The user's folders are not libraries, not even if they are the toolchain's own.
        const Files own = ownFolders(files), toolchain = toolchainFlagsBesides(request_.flags);
        flags.insert(flags.end(), own.begin(), own.end());
        flags.insert(flags.end(), toolchain.begin(), toolchain.end());
        // Without these macros several sources can be one text, and registrations always make the same objects.
        flags.insert(flags.end(), {"-U", "RTT_COMPONENT", "-U", "OCL_DLL_EXPORT"});
        return flags;
    }

    void describe(clang::Sema& sema, const SourcePlaces& places, Reading& reading) const {
        const FoundClasses found = findComponents(sema, places, reading.remarks);
        ComponentDescriber describer(sema, places, request_.root, reading.remarks);
        for (const FoundClass& one : found.components)
            reading.package.components.push_back(describer.component(*one.type));
        for (const FoundClass& one : found.services) reading.package.services.push_back(describer.service(one));
        for (const clang::CXXRecordDecl* one : found.unregistered) {
            reading.remarks.warning(
                places.locate(sema.getSourceManager(), one->getLocation()), "OC026",
                "component '" + classNameOf(*one) + "' is left out: it is not registered, and others are");
        }
        reading.package.plugins = found.plugins;
        reading.package.typekitHeaders = describer.typekitHeaders();
        reading.incomplete = describer.incomplete();
    }

    const ComponentFiles& request_;
    std::string resourceDir_;
};

void addNew(model::Package& into, model::Package from) {
    const auto add = [](auto& all, auto&& more, const auto& nameOf) {
        for (auto& one : more) {
            const bool known = std::any_of(all.begin(), all.end(),
                                           [&](const auto& other) { return nameOf(other).value == nameOf(one).value; });
            if (!known) all.push_back(std::move(one));
        }
    };
    const auto className = [](const auto& one) { return one.className; };
    add(into.components, from.components, className);
    add(into.services, from.services, className);
    add(into.plugins, from.plugins, [](const model::Plugin& one) { return one.name; });
    add(into.typekitHeaders, from.typekitHeaders, [](const model::Text& one) { return one; });
}

/// Reads sources one by one if they cannot be one text, because of equal function names or two plugins.
Reading readEach(const Reader& reader, const Files& files) {
    Reading all;
    for (const std::string& file : files) {
        const fs::path source = sourceOf(file);
        if (!source.empty() && contains(files, source)) continue;
        Reading one = reader.read({file}, files);
        for (const diag::Diagnostic& error : one.errors.all()) all.errors.add(error);
        for (const diag::Diagnostic& remark : one.remarks.all()) all.remarks.add(remark);
        addNew(all.package, std::move(one.package));
    }
    return all;
}

bool checkFiles(const ComponentFiles& request, diag::Sink& sink) {
    for (const std::string& file : request.files) {
        if (!isFile(file)) sink.error({file}, "OC027", "no such file, expected a header or a source");
    }
    return !sink.hadErrors();
}

}  // namespace

std::optional<model::Package> readComponents(const ComponentFiles& request, diag::Sink& sink) {
    if (!checkFiles(request, sink)) return std::nullopt;
    const auto resourceDir = findResourceDir(request.resourceDir, sink);
    if (!resourceDir) return std::nullopt;
    const Reader reader(request, *resourceDir);
    Files files = request.files;
    addSources(request.files, files);
    Reading reading = reader.read(files, files);
    // A base class may be in an unlisted header with a source beside it, and that source may lead to others.
    for (int round = 0; round < 4 && !reading.errors.hadErrors() && !reading.incomplete.empty(); ++round) {
        const std::size_t before = files.size();
        addSources({reading.incomplete.begin(), reading.incomplete.end()}, files);
        if (files.size() == before) break;
        reading = reader.read(files, files);
    }
    if (reading.errors.hadErrors() && files.size() > 1) {
        Reading each = readEach(reader, files);
        if (!each.errors.hadErrors()) reading = std::move(each);
    }
    for (const diag::Diagnostic& remark : reading.remarks.all()) sink.add(remark);
    for (const diag::Diagnostic& error : reading.errors.all()) sink.add(error);
    if (sink.hadErrors()) return std::nullopt;
    if (reading.package.components.empty() && reading.package.services.empty() && reading.package.plugins.empty()) {
        sink.error(
            {request.files.front()}, "OC020",
            "no component class found, expected a class derived from RTT::TaskContext that is defined here, or a "
            "plugin");
        return std::nullopt;
    }
    return std::move(reading.package);
}

}  // namespace oroforge::cxx
