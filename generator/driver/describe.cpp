// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
//
//     files ─► flags of the compiler ─► classes ─► model ─► checks ─► manifest
#include <driver/commands.hpp>

#include <cstdlib>
#include <filesystem>
#include <ostream>

#include <check/check.hpp>
#include <clang/describe/component_reader.hpp>
#include <emit/outputs.hpp>
#include <flags/compile_database.hpp>
#include <manifest/writer.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

/// Returns the package's folder: the file's folder, without the inner folders that packages usually have.
fs::path packageFolder(const std::string& file) {
    fs::path folder = fs::absolute(file).lexically_normal().parent_path();
    for (fs::path above = folder; above.has_relative_path(); above = above.parent_path()) {
        if (above.filename() == "include") folder = above;
    }
    while (folder.filename() == "src" || folder.filename() == "include") folder = folder.parent_path();
    return folder;
}

std::string packageName(const Options& options, diag::Sink& sink) {
    const bool isGiven = !options.package.empty();
    const std::string name = isGiven ? options.package : packageFolder(options.words.front()).filename().string();
    const std::string fault = check::packageNameFault(name);
    if (!fault.empty()) {
        sink.error({"orocreate-pkg"}, "OC002", "package name '" + name + "' " + fault)
            .hint(isGiven ? "it was given with --package" : "it is the folder's; --package gives another one");
    }
    return name;
}

/// Takes the unit from "of the fingers [m/s]", the form that generated code and people use.
void takeUnit(std::string& doc, std::string& unit) {
    const std::size_t open = doc.rfind('[');
    if (open == std::string::npos || doc.back() != ']' || (open != 0 && doc[open - 1] != ' ')) return;
    const std::string inner = doc.substr(open + 1, doc.size() - open - 2);
    if (inner.empty() || inner.find_first_of(" ,;[]") != std::string::npos) return;
    unit = inner;
    doc.erase(open == 0 ? 0 : open - 1);
}

void takeUnits(model::Interface& interface) {
    for (auto& property : interface.properties) takeUnit(property.doc, property.unit);
    for (auto& operation : interface.operations) {
        for (auto& argument : operation.arguments) takeUnit(argument.doc, argument.unit);
    }
    for (auto& service : interface.services) takeUnits(service);
}

/// The class does have what the manifest reader would refuse: each fault is a warning, with the code that explains it.
void checkAsRemarks(const model::Package& package, diag::Sink& sink) {
    diag::Sink faults;
    check::run(package, faults);
    bool first = true;
    for (diag::Diagnostic fault : faults.sorted()) {
        fault.severity = diag::Severity::Warning;
        if (first) fault.hint("nothing can be generated from the manifest before this is changed");
        first = false;
        sink.add(fault);
    }
}

cxx::ComponentFiles filesOf(const Options& options, diag::Sink& sink) {
    cxx::ComponentFiles files;
    files.files = options.words;
    files.root = packageFolder(options.words.front()).string();
    files.flags = options.flags;
    if (const char* target = std::getenv("OROCOS_TARGET"); target != nullptr && *target != '\0') files.target = target;
    files.missingHint = options.database.empty()
                            ? "if the build of the package makes this file, build first and give its folder: -p build"
                            : "if the build of the package makes this file, build first";
    if (options.database.empty()) return files;
    const auto database = flags::readCompileDatabase(options.database, options.databaseEntry, files.files, sink);
    if (!database) return files;
    const auto more = flags::withoutOverridden(database->flags, files.flags);
    files.flags.insert(files.flags.end(), more.begin(), more.end());
    return files;
}

}  // namespace

void describeComponents(const Options& options, std::ostream& out, diag::Sink& sink) {
    const std::string name = packageName(options, sink);
    const cxx::ComponentFiles files = filesOf(options, sink);
    if (sink.hadErrors()) return;
    auto package = cxx::readComponents(files, sink);
    if (!package) return;
    for (auto& component : package->components) takeUnits(component);
    for (auto& service : package->services) takeUnits(service);
    package->name = {name, {"orocreate-pkg", 1, 1}};
    checkAsRemarks(*package, sink);
    const std::string text = manifest::write(*package);
    if (options.output.empty()) {
        out << text;
        return;
    }
    const fs::path file = options.output;
    emit::write({{file.filename().string(), text}}, file.has_parent_path() ? file.parent_path() : ".", sink);
}

}  // namespace oroforge::driver
