// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
//
//     words or manifest ─► model ─► checks ─► scaffold ─► directory ready? ─► write all or nothing
#include <driver/commands.hpp>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include <check/check.hpp>
#include <driver/kinds.hpp>
#include <driver/manifest_types.hpp>
#include <driver/package_files.hpp>
#include <driver/wanted_classes.hpp>
#include <manifest/reader.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

const diag::Location kHere{"orocreate-pkg", 0, 0};

bool isOnly(const Options& options, const char* kind) { return options.words.size() == 2 && options.words[1] == kind; }

/// Uses headers beside the manifest; if there are none, makes one with a struct per type.
void addTypekitHeaders(const model::Package& package, const fs::path& manifest, Scaffold& files, diag::Sink& sink) {
    const fs::path directory = manifest.parent_path();
    const auto stands = [&](const model::Text& header) { return emit::isFile(directory / header.value); };
    const auto& headers = package.typekitHeaders;
    if (std::none_of(headers.begin(), headers.end(), stands)) {
        if (headers.size() > 1) {
            sink.error(headers[1].where, "OC006",
                       "none of the typekit headers is beside the manifest; only one can be made");
        }
        return;
    }
    for (const model::Text& header : headers) {
        if (!stands(header)) sink.error(header.where, "OC006", "no file '" + header.value + "' beside the manifest");
        files.user[header.value] = emit::textOf(directory / header.value);
    }
}

/// Returns "CMakeLists.txt.old", or with a number if that exists: no version of a file is lost.
std::string backupName(const fs::path& directory, const std::string& name) {
    std::string backup = name + ".old";
    for (int i = 2; emit::exists(directory / backup); ++i) backup = name + ".old" + std::to_string(i);
    return backup;
}

/// Returns what to write into `directory`. Existing user files are left out and listed in `kept`; other files that
/// differ are also written under a backup name, as they are.
emit::Outputs writable(const Scaffold& files, const fs::path& directory, std::vector<std::string>& kept) {
    emit::Outputs outputs = files.shared;
    for (const auto& [name, text] : files.shared) {
        if (!emit::exists(directory / name)) continue;
        const std::string old = emit::textOf(directory / name);
        if (old != text) outputs[backupName(directory, name)] = old;
    }
    for (const auto& [name, text] : files.user) {
        if (emit::exists(directory / name)) {
            kept.push_back(name);
        } else {
            outputs[name] = text;
        }
    }
    return outputs;
}

void writePackage(const Scaffold& files, const std::string& name, const Options& options, std::ostream& out,
                  diag::Sink& sink) {
    if (emit::exists(name) && !options.force) {
        sink.error(kHere, "OC004", "'" + name + "' already exists; nothing was written. Use -f to write into it");
    }
    if (sink.hadErrors()) return;
    std::vector<std::string> kept;
    if (!writeOutputs(writable(files, name, kept), name, options.dryRun, out, sink)) return;
    for (const std::string& file : kept) out << "kept  " << name << "/" << file << '\n';
}

void createFromManifest(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink) {
    const auto package = manifest::readFile(options.from, sink);
    if (package) check::run(*package, sink);
    if (!sink.hadErrors()) checkTypes(*package, fs::path(options.from).parent_path(), options.flags, sink);
    if (sink.hadErrors()) return;
    const std::string& name = package->name.value;
    if (!options.words.empty() && options.words.front() != name) {
        sink.error(
            package->name.where, "OC005",
            "the manifest is of package '" + name + "', the command line asks for '" + options.words.front() + "'");
        return;
    }
    const std::string manifest = name + ".xml";
    Scaffold files = scaffold(*package, manifest, options.catkin, renderer);
    addTypekitHeaders(*package, options.from, files, sink);
    files.shared[manifest] = emit::textOf(options.from);
    // Existing sources were not written from this manifest.
    const std::string record = emit::exists(name) ? std::string() : firstRecord(*package, renderer);
    if (!record.empty()) files.shared[merge::kRecordFile] = record;
    writePackage(files, name, options, out, sink);
}

void createFromKinds(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink) {
    const model::Package package = packageOfKinds(options, sink);
    if (sink.hadErrors()) return;
    Scaffold files = scaffold(package, "", options.catkin, renderer);
    if (isOnly(options, "empty")) files = Scaffold{{{"package.xml", files.shared["package.xml"]}}, {}};
    writePackage(files, package.name.value, options, out, sink);
}

}  // namespace

void createPackage(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink) {
    if (options.from.empty()) {
        createFromKinds(options, renderer, out, sink);
    } else {
        createFromManifest(options, renderer, out, sink);
    }
}

}  // namespace oroforge::driver
