// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "type_reader.hpp"

#include <algorithm>
#include <set>

#include <clang/base/check_headers.hpp>
#include <clang/base/diagnostic_bridge.hpp>
#include <clang/base/header_needs.hpp>
#include <clang/base/parse_files.hpp>
#include <clang/base/resource_dir.hpp>
#include <clang/base/toolchain_flags.hpp>
#include <clang/base/type_names.hpp>
#include <model/shown_name.hpp>

#include "describe_type.hpp"
#include "field_fixes.hpp"
#include "find_names.hpp"
#include "find_roots.hpp"
#include "hidden_fields.hpp"
#include "side_notes.hpp"
#include "sound_types.hpp"

namespace oroforge::cxx {

namespace {

/// Results of a reading besides the types.
struct Aside {
    std::string more;        ///< C++ to read after the headers
    Layouts layouts;         ///< for headers that differ without __orogen
    bool usesMacro = false;  ///< a header tests __orogen
};

/// Watches how the headers are read, and works on the complete AST.
class Reading {
public:
    Reading(const ParseRequest& request, const std::vector<model::Header>& headers, const SourcePlaces& places,
            diag::Sink& sink, model::TypeModel& into, Aside& aside)
        : request_(request), headers_(headers), places_(places), sink_(sink), into_(into), aside_(aside) {}

    void begin(clang::Preprocessor& preprocessor) {
        attributes_.watch(preprocessor);
        if (into_.headers.size() > 1) includes_.watch(preprocessor);
        watchForMacro(preprocessor, aside_.usesMacro);
    }

    void take(const clang::Token& word) {
        attributes_.take(word);
        if (into_.headers.size() > 1) includes_.take(word);
    }

    /// Sema still exists here, and answers questions about implicit constructors.
    void end(clang::Sema& sema) {
        const clang::ASTContext& context = sema.getASTContext();
        HeaderCheck headers(sema.getPreprocessor(), places_, sink_);
        for (const model::Header& header : headers_) headers.checkRead(header);
        const bool broken = context.getDiagnostics().hasErrorOccurred();
        diag::Sink found;
        // A broken text, or a part of it, may lack classes that an adapter names.
        diag::Sink unused;
        const bool isWhole = !broken && headers_.size() == request_.headers.size();
        const AdapterFinder adapters(request_.adapters, context, isWhole ? found : unused);
        const HeaderNeeds needs(headersToTell(), includes_, context);
        TypeDescriber types(sema, places_, attributes_, adapters, needs, request_.strict, found, into_);
        SoundTypes sound;
        const std::vector<Root> roots = findRoots(context, places_, adapters);
        std::vector<Root> described;
        for (const Root& root : roots) {
            headers.checkGuard(*root.type);
            const DocComment doc = types.docOf(*root.type);
            if (doc.skip || (doc.bytes && root.type->isUnion())) continue;
            // Other types may be incomplete, which would only cause follow-up errors.
            if (broken && !sound.has(*root.type)) continue;
            described.push_back(root);
            if (const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(root.type)) types.describe(*record, root);
            if (const auto* enumeration = llvm::dyn_cast<clang::EnumDecl>(root.type)) types.describe(*enumeration);
        }
        for (const OtherName& name : findNames(context, places_, described)) addName(name, types);
        passOnWithFixes(found, context, places_, sink_);
        for (diag::Note& note : unusedTemplates(context, places_, into_)) into_.notes.push_back(std::move(note));
        if (aside_.usesMacro) aside_.layouts = layoutsOf(context, roots);
        for (std::size_t i = 0; i != into_.headers.size(); ++i) into_.headers[i].before = needs.before(i);
    }

private:
    void addName(const OtherName& name, TypeDescriber& types) {
        const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(name.type);
        const TypeFate& fate =
            record != nullptr ? types.describe(*record) : types.describe(*llvm::cast<clang::EnumDecl>(name.type));
        const auto first = nameOf(*name.type);
        if (!fate.usable || !first) return;
        // A type is named after its first alias, so a type that keeps its own name gets that as its first alias.
        const bool isCalled = std::any_of(into_.aliases.begin(), into_.aliases.end(),
                                          [&](const model::Alias& one) { return one.of == first->registry; });
        if (!isCalled) into_.aliases.push_back({first->registry, first->registry, types.locate(name.at)});
        into_.aliases.push_back({name.alias, first->registry, types.locate(name.at)});
    }
    /// Returns nothing unless all headers were read, because a header may depend on any other.
    std::vector<model::Header> headersToTell() {
        if (into_.headers.size() < 2) return {};
        for (const Attributes::Note& note : attributes_.notes())
            if (note.name == "make") includes_.addWords(note.value, note.at);
        return headers_;
    }

    const ParseRequest& request_;
    const std::vector<model::Header>& headers_;
    const SourcePlaces& places_;
    diag::Sink& sink_;
    model::TypeModel& into_;
    Aside& aside_;
    Attributes attributes_;
    IncludeWatch includes_;
};

/// Records every file that was opened, including system headers: a new compiler must regenerate.
class FileCollector : public clang::DependencyCollector {
public:
    bool needSystemDependencies() override { return true; }
};

std::string makeMainText(const std::vector<model::Header>& headers, const std::string& more) {
    std::string text;
    for (const model::Header& header : headers) text += "#include \"" + header.path + "\"\n";
    return text + more;
}

/// Compiler errors go into `compileErrors`, errors about types into `sink`. False if the compiler could not start.
bool read(const ParseRequest& request, const std::string& resourceDir, const std::vector<model::Header>& headers,
          diag::Sink& compileErrors, diag::Sink& sink, model::TypeModel& into, Aside& aside) {
    const SourcePlaces places(request.headers);
    DiagnosticBridge bridge(places, compileErrors, headers.empty() ? "typegen" : plainPath(headers.back().path));
    bridge.hintAtMissingFile(
        "give the folder that holds it (-I DIR), the package that installs it (-i PACKAGE), or the options that a "
        "build knows "
        "(-p BUILD)");
    FileCollector files;
    Reading reading(request, headers, places, sink, into, aside);
    Parse parse;
    parse.mainFile = kMainFile;
    parse.files[kMainFile] = makeMainText(headers, aside.more);
    parse.flags = {"-D__orogen", "-D__orogen2", "-DOROCOS_TARGET=" + request.target};
    parse.flags.insert(parse.flags.end(), request.flags.begin(), request.flags.end());
    for (const std::string& flag : toolchainFlagsBesides(request.flags)) parse.flags.push_back(flag);
    parse.resourceDir = resourceDir;
    parse.messages = &bridge;
    parse.skipsBody = [](clang::Decl&) { return true; };
    parse.begin = [&](clang::CompilerInstance& compiler) {
        bridge.goOnAfterFatalErrors(compiler.getDiagnostics());
        files.attachToPreprocessor(compiler.getPreprocessor());
        reading.begin(compiler.getPreprocessor());
    };
    parse.word = [&](const clang::Token& word) { reading.take(word); };
    parse.end = [&](clang::Sema& sema) { reading.end(sema); };
    const bool started = parseFiles(parse);
    for (const std::string& file : files.getDependencies()) {
        if (file != kMainFile) into.files.push_back(file);
    }
    return started || compileErrors.hadErrors();
}

/// Returns the first header with an error; the first of all if that is not known.
std::size_t firstBroken(const std::vector<model::Header>& headers, const diag::Sink& compileErrors) {
    std::size_t first = headers.size();
    const auto add = [&](const diag::Location& where) {
        std::size_t i = 0;
        while (i != headers.size() && plainPath(headers[i].path) != where.file.str()) ++i;
        first = std::min(first, i == headers.size() ? 0 : i);
    };
    for (const diag::Diagnostic& error : compileErrors.all()) {
        add(error.where);
        for (const diag::Note& note : error.notes) add(note.where);
    }
    return first;
}

/// A missing '}' in a header may have hidden the headers after it: reads each of these alone. Compiler errors are then
/// left out, because some headers need others before them; for those headers, findings of the whole text count.
diag::Sink readEachAlone(const ParseRequest& request, const std::string& resourceDir, const diag::Sink& inWhole,
                         std::size_t first) {
    diag::Sink found;
    std::set<std::string> complete;
    std::set<std::pair<diag::Location, std::string>> known;
    for (std::size_t i = first; i < request.headers.size(); ++i) {
        const model::Header& header = request.headers[i];
        diag::Sink compileErrors;
        model::TypeModel unused;
        Aside aside;
        read(request, resourceDir, {header}, compileErrors, found, unused, aside);
        if (!compileErrors.hadErrors()) complete.insert(plainPath(header.path));
    }
    for (const diag::Diagnostic& one : found.all()) known.emplace(one.where, one.code);
    for (const diag::Diagnostic& one : inWhole.all()) {
        if (complete.count(one.where.file) == 0 && known.count({one.where, one.code}) == 0) found.add(one);
    }
    return found;
}

/// Finds fields that are hidden from typegen but not from the compiler.
void checkHiddenFields(const ParseRequest& request, const std::string& resourceDir, const Aside& described,
                       model::TypeModel& model, diag::Sink& sink) {
    ParseRequest asCompiled = request;
    asCompiled.flags.insert(asCompiled.flags.end(), {"-U__orogen", "-U__orogen2"});
    diag::Sink compileErrors, aboutTypes;
    model::TypeModel unused;
    Aside seen;
    read(asCompiled, resourceDir, request.headers, compileErrors, aboutTypes, unused, seen);
    compareLayouts(model, described.layouts, seen.layouts, sink);
    // Headers that are included only in this reading matter as well.
    model.files.insert(model.files.end(), unused.files.begin(), unused.files.end());
}

/// Returns C++ that compiles only if [[oro::make(…)]] gives a value of the type.
std::string makerTest(const model::Struct& type) {
    const std::size_t arguments = std::min(type.cpp.find('<'), type.cpp.size());
    const std::size_t own = type.cpp.rfind("::", arguments) + 2;
    return "namespace oroforge_check {" + (type.space.empty() ? "" : "using namespace " + type.space + ";") + "using " +
           type.cpp.substr(own, arguments - own) + " = " + type.cpp + ";\nusing Made = decltype(" + type.make +
           ");\nstatic_assert(__is_same(Made, " + type.cpp + "), \"it is no value of the type\");}\n";
}

/// Returns the compiler's error about such C++ after the headers; empty if there is none.
std::string errorBehindHeaders(const ParseRequest& request, const std::string& resourceDir, const std::string& more) {
    Aside aside;
    aside.more = more;
    diag::Sink compileErrors, aboutTypes;
    model::TypeModel unused;
    read(request, resourceDir, request.headers, compileErrors, aboutTypes, unused, aside);
    return compileErrors.hadErrors() ? compileErrors.all().front().message : "";
}

/// True for a struct with [[oro::make(…)]] that is named only by a field.
bool isUnnamed(const model::Struct& type) { return !type.make.empty() && type.cpp.rfind("decltype(", 0) == 0; }

/// Checks that [[oro::make(…)]] gives a value of the type, so that the error is here and not in generated code.
void checkMakers(const ParseRequest& request, const std::string& resourceDir, const model::TypeModel& model,
                 diag::Sink& sink) {
    std::string all;
    for (const model::Struct& type : model.structs) {
        if (isUnnamed(type)) {
            sink.error(type.where, "TK040",
                       "'" + type.make + "' has no name to call what it makes: the struct is unnamed")
                .hint("give the struct a name");
        } else if (!type.make.empty()) {
            all += "namespace oroforge_check_" + std::to_string(all.size()) + " {" + makerTest(type) + "}\n";
        }
    }
    // One reading is enough unless it finds an error: then one bad text may spoil others.
    if (all.empty() || errorBehindHeaders(request, resourceDir, all).empty()) return;
    for (const model::Struct& type : model.structs) {
        const std::string error =
            type.make.empty() || isUnnamed(type) ? "" : errorBehindHeaders(request, resourceDir, makerTest(type));
        if (error.empty()) continue;
        const std::string why = error.find("__is_same") != std::string::npos ? "it is of another type" : error;
        sink.error(type.where, "TK040",
                   "'" + type.make + "' makes no value of '" + model::cppShown(type.cpp) + "': " + why)
            .hint("give [[oro::make(\"…\")]] an expression that holds in the namespace of the type");
    }
}

}  // namespace

std::optional<model::TypeModel> readTypes(const ParseRequest& request, diag::Sink& sink) {
    const auto resourceDir = findResourceDir(request.resourceDir, sink);
    if (!resourceDir) return std::nullopt;
    model::TypeModel result;
    result.headers = request.headers;
    const std::size_t errorsBefore = sink.errorCount();
    diag::Sink compileErrors, aboutTypes;
    Aside aside;
    const bool started = read(request, *resourceDir, request.headers, compileErrors, aboutTypes, result, aside);
    if (compileErrors.hadErrors() && request.headers.size() > 1) {
        aboutTypes = readEachAlone(request, *resourceDir, aboutTypes, firstBroken(request.headers, compileErrors));
    }
    for (const diag::Diagnostic& found : aboutTypes.all()) sink.add(found);
    for (const diag::Diagnostic& error : compileErrors.all()) sink.add(error);
    if (sink.errorCount() != errorsBefore) return std::nullopt;
    checkMakers(request, *resourceDir, result, sink);
    if (sink.errorCount() != errorsBefore) return std::nullopt;
    if (aside.usesMacro) checkHiddenFields(request, *resourceDir, aside, result, sink);
    if (!started) {
        sink.error({"typegen"}, "TK006", "the compiler could not be started with these options");
        return std::nullopt;
    }
    return result;
}

}  // namespace oroforge::cxx
