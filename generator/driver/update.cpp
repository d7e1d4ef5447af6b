// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/commands.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <ostream>

#include <check/check.hpp>
#include <clang/base/toolchain_flags.hpp>
#include <clang/update/format_inserted.hpp>
#include <clang/update/user_class.hpp>
#include <diag/nearest_match.hpp>
#include <driver/manifest_types.hpp>
#include <driver/new_classes.hpp>
#include <driver/package_files.hpp>
#include <driver/package_sources.hpp>
#include <driver/wanted_classes.hpp>
#include <manifest/reader.hpp>
#include <merge/plan.hpp>
#include <merge/text_places.hpp>
#include <merge/unified_diff.hpp>
#include <model/names.hpp>
#include <view/cpp_text.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

const diag::Location kHere{"orocreate-pkg", 0, 0};

/// Finds the only file in the current directory that describes components.
std::optional<std::string> findManifest(diag::Sink& sink) {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(".")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".xml" || name == "package.xml" || name == "manifest.xml") continue;
        const std::string text = emit::textOf(entry.path());
        if (text.find("<package ") != std::string::npos) found.push_back(name);
    }
    std::sort(found.begin(), found.end());
    if (found.size() == 1) return found.front();
    sink.error(kHere, "OC036",
               found.empty() ? "there is no manifest of components in the current directory"
                             : "there are several manifests in the current directory: " + diag::oneOf(found))
        .hint("orocreate-pkg --update MANIFEST names it");
    return std::nullopt;
}

struct Package {
    std::string manifest;  ///< as it was given
    fs::path root;         ///< absolute
    std::string shown;     ///< "" or "tank/": goes before names of files
    model::Package model;
    std::vector<merge::WantedClass> wanted;
    merge::Record record;
};

std::optional<Package> readPackage(const Options& options, const render::Renderer& renderer, diag::Sink& sink) {
    Package package;
    if (options.words.empty()) {
        const auto found = findManifest(sink);
        if (!found) return std::nullopt;
        package.manifest = *found;
    } else {
        package.manifest = options.words.front();
    }
    const auto model = manifest::readFile(package.manifest, sink);
    if (model) check::run(*model, sink);
    if (!sink.hadErrors()) checkTypes(*model, fs::path(package.manifest).parent_path(), options.flags, sink);
    if (sink.hadErrors()) return std::nullopt;
    package.model = *model;
    const fs::path folder = fs::path(package.manifest).parent_path();
    package.root = fs::canonical(folder.empty() ? fs::path(".") : folder);
    package.shown = folder.empty() || folder == "." ? "" : folder.string() + "/";
    package.wanted = wantedClasses(*model, renderer);
    const std::string record = emit::textOf(package.root / merge::kRecordFile);
    if (record.empty()) return package;
    const auto parsed = merge::parseRecord(record, package.shown + merge::kRecordFile, sink);
    if (!parsed) return std::nullopt;
    package.record = *parsed;
    return package;
}

/// Returns the headers that the build makes, where the compiler finds them: --update needs no build.
std::map<std::string, std::string> generatedHeaders(const Package& package, const render::Renderer& renderer) {
    const fs::path folder = package.root / ".orocreate-pkg";
    std::map<std::string, std::string> headers;
    const std::string name = fs::path(package.manifest).filename().string();
    for (const auto& [file, text] : generatedFiles(package.model, name, renderer))
        if (fs::path(file).extension() == ".hpp") headers[(folder / file).string()] = text;
    for (const model::Text& header : package.model.typekitHeaders) {
        const std::string included = view::includeName(header.value, package.model.name.value);
        // The build offers them under that name, wherever they are.
        if (!emit::exists(package.root / "include" / included))
            headers[(folder / included).string()] = "#include \"" + (package.root / header.value).string() + "\"\n";
    }
    return headers;
}

std::vector<std::string> flagsFor(const Package& package, const Options& options) {
    std::vector<std::string> flags = {"-DRTT_COMPONENT", "-DOROCOS_TARGET=gnulinux"};
    for (const char* folder : {".orocreate-pkg", "include", "src", ""})
        flags.push_back("-I" + (package.root / folder).string());
    flags.insert(flags.end(), options.flags.begin(), options.flags.end());
    // Generated headers no longer include what the manifest dropped, but the code may still use it.
    std::vector<std::string> types;
    for (const auto& [name, recorded] : package.record) {
        for (const auto& [method, what] : recorded.methods) types.push_back(merge::toText(what.signature, method));
        for (const auto& [member, what] : recorded.members) types.push_back(what.type);
    }
    for (const std::string& header : view::standardHeaders(types)) flags.insert(flags.end(), {"-include", header});
    const std::vector<std::string> toolchain = cxx::toolchainFlags();
    flags.insert(flags.end(), toolchain.begin(), toolchain.end());
    return flags;
}

struct Code {
    model::UserCode user;
    std::map<std::string, merge::Answers> answers;
};

Code readCode(const Package& package, const Options& options, const render::Renderer& renderer, diag::Sink& sink) {
    cxx::UserCodeRequest request;
    request.root = package.root.string();
    request.shown = package.shown;
    request.flags = flagsFor(package, options);
    request.generated = generatedHeaders(package, renderer);
    std::vector<std::string> names;
    const auto add = [&](const std::string& name, const std::string& base, std::vector<model::Signature> signatures) {
        names.push_back(model::lastName(name));
        request.classes.push_back({name, base, std::move(signatures)});
    };
    for (const merge::WantedClass& wanted : package.wanted) {
        const auto recorded = package.record.find(wanted.name);
        add(wanted.name, wanted.base,
            merge::questionsOf(wanted, recorded == package.record.end() ? nullptr : &recorded->second));
    }
    for (const auto& [name, recorded] : package.record) {
        const auto same = [&, &known = name](const merge::WantedClass& wanted) { return wanted.name == known; };
        if (std::none_of(package.wanted.begin(), package.wanted.end(), same)) add(name, model::baseName(name), {});
    }
    const PackageSources sources = findSources(package.root, names);
    request.sources = sources.sources;
    request.headers = sources.headers;
    Code code;
    std::vector<std::vector<model::CanonicalSignature>> canonical;
    code.user = cxx::readUserCode(request, canonical, sink);
    for (std::size_t i = 0; i != canonical.size(); ++i)
        for (std::size_t j = 0; j != canonical[i].size(); ++j)
            code.answers[request.classes[i].name][merge::question(request.classes[i].signatures[j])] = canonical[i][j];
    for (const model::UserClass& one : code.user.classes) {
        code.user.texts[one.file];
        for (const model::UserFunction& function : one.functions) code.user.texts[function.file];
        for (const model::UserField& field : one.fields) code.user.texts[field.file];
        for (const model::UserRegistration& call : one.registrations) code.user.texts[call.file];
    }
    for (auto& [file, text] : code.user.texts) text = emit::textOf(package.root / file);
    return code;
}

/// Reports choices for names that do not exist.
void checkChoices(const Package& package, const Options& options, diag::Sink& sink) {
    std::vector<std::string> known;
    for (const merge::WantedClass& wanted : package.wanted) {
        const std::string prefix = model::lastName(wanted.name) + ".";
        for (const auto& method : wanted.methods) known.insert(known.end(), {method.shown, prefix + method.shown});
        for (const auto& member : wanted.members) known.insert(known.end(), {member.shown, prefix + member.shown});
    }
    const auto check = [&](const char* option, const std::vector<std::string>& names) {
        for (const std::string& name : names) {
            if (std::find(known.begin(), known.end(), name) != known.end()) continue;
            sink.error(kHere, "OC035",
                       std::string(option) + " '" + name +
                           "': the manifest has no operation, hook, port, property or " + "attribute of that name" +
                           diag::didYouMean(name, known));
        }
    };
    check("--take-manifest", options.takeManifest);
    check("--take-code", options.takeCode);
}

void tellDifferences(const emit::Outputs& outputs, const Package& package, const Options& options, std::ostream& out,
                     diag::Sink& sink) {
    std::vector<std::string> files;
    for (const auto& [file, text] : outputs) {
        const std::string before = emit::textOf(package.root / file);
        if (before == text) continue;
        files.push_back(package.shown + file);
        if (options.dryRun) out << merge::unifiedDiff(before, text, package.shown + file);
    }
    if (!options.check) return;
    for (const std::string& file : files)
        sink.error({file, 0, 0}, "OC040", "this file does not follow the manifest")
            .hint("orocreate-pkg --update brings it up to date");
}

/// Passes diagnostics on, with places as they are after the files are written.
void passOn(const diag::Sink& found, const merge::Edits& edits, const std::string& shown, const model::UserCode& code,
            diag::Sink& sink) {
    const auto now = [&](const diag::Location& where) {
        const std::string file = where.file.str().substr(std::min(shown.size(), where.file.str().size()));
        const auto edited = edits.byFile().find(file);
        if (edited == edits.byFile().end()) return where;
        return merge::moved(where, code.texts.at(file), edited->second);
    };
    for (diag::Diagnostic diagnostic : found.all()) {
        diagnostic.where = now(diagnostic.where);
        for (diag::Note& note : diagnostic.notes) note.where = now(note.where);
        sink.add(std::move(diagnostic));
    }
}

}  // namespace

void updatePackage(const Options& options, const render::Renderer& renderer, std::ostream& out, diag::Sink& sink) {
    const auto package = readPackage(options, renderer, sink);
    if (!package) return;
    checkChoices(*package, options, sink);
    const Code code = readCode(*package, options, renderer, sink);
    const merge::Choices choices{{options.takeManifest.begin(), options.takeManifest.end()},
                                 {options.takeCode.begin(), options.takeCode.end()}};
    diag::Sink found;
    merge::Plan plan = merge::plan(package->wanted, {code.user, code.answers, package->record, choices}, found);
    const merge::Formatter format = [&](const auto& file, const auto& text, const auto& inserted) {
        return cxx::formatInserted({package->root.string(), package->shown, file, text, inserted}, sink);
    };
    if (!found.hadErrors()) plan.edits.format(code.user.texts, format);
    emit::Outputs outputs;
    for (const auto& [file, edits] : plan.edits.byFile())
        outputs[file] = merge::applied(code.user.texts.at(file), edits);
    const NewClasses fresh{package->model,  fs::path(package->manifest).filename().string(),
                           package->root,   package->shown,
                           package->wanted, package->record,
                           code.user,       format};
    addNewClasses(fresh, renderer, outputs, plan, found);
    const bool writes = !sink.hadErrors() && !found.hadErrors() && !options.dryRun && !options.check;
    passOn(found, writes ? plan.edits : merge::Edits(), package->shown, code.user, sink);
    if (sink.hadErrors()) return;
    outputs[merge::kRecordFile] = merge::toText(plan.record);
    if (options.dryRun || options.check) return tellDifferences(outputs, *package, options, out, sink);
    emit::Written written;
    if (!emit::write(outputs, package->root, sink, &written)) return;
    for (const std::string& change : plan.changes) out << package->shown << change << '\n';
    if (written.changed.empty())
        out << "nothing to do\n";
    else if (plan.changes.empty())
        out << "the record is up to date, nothing else changed\n";
}

}  // namespace oroforge::driver
