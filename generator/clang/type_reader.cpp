// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "type_reader.hpp"

#include <set>

#include "check_headers.hpp"
#include "describe_type.hpp"
#include "diagnostic_bridge.hpp"
#include "find_roots.hpp"
#include "fix_it.hpp"
#include "sound_types.hpp"

namespace oroforge::cxx {

namespace {

/// Works on the finished AST; Sema is still there, to ask for implicit constructors.
class TypeConsumer : public clang::SemaConsumer {
public:
    TypeConsumer(const std::vector<model::Header>& headers, const SourcePlaces& places, diag::Sink& sink,
                 model::TypeModel& into, clang::Preprocessor& preprocessor)
        : headers_(headers), places_(places), sink_(sink), into_(into) {
        attributes_.watch(preprocessor);
    }
    void InitializeSema(clang::Sema& sema) override { sema_ = &sema; }
    void ForgetSema() override { sema_ = nullptr; }
    void HandleTranslationUnit(clang::ASTContext& context) override {
        HeaderCheck headers(sema_->getPreprocessor(), places_, sink_);
        for (const model::Header& header : headers_) headers.checkRead(header);
        const bool broken = context.getDiagnostics().hasErrorOccurred();
        diag::Sink found;
        TypeDescriber types(*sema_, places_, attributes_, found, into_);
        SoundTypes sound;
        for (const Root& root : findRoots(context, places_)) {
            headers.checkGuard(*root.type);
            if (types.docOf(*root.type).skip) continue;
            // Elsewhere types may be incomplete in ways that would only cause follow-up errors.
            if (broken && !sound.has(*root.type)) continue;
            if (const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(root.type)) types.describe(*record, root);
            if (const auto* enumeration = llvm::dyn_cast<clang::EnumDecl>(root.type)) types.describe(*enumeration);
        }
        passOnWithFixes(found, context, places_, sink_);
    }

private:
    const std::vector<model::Header>& headers_;
    const SourcePlaces& places_;
    diag::Sink& sink_;
    model::TypeModel& into_;
    Attributes attributes_;
    clang::Sema* sema_ = nullptr;
};

class TypeAction : public clang::ASTFrontendAction {
public:
    TypeAction(const std::vector<model::Header>& headers, const SourcePlaces& places, diag::Sink& sink,
               model::TypeModel& into)
        : headers_(headers), places_(places), sink_(sink), into_(into) {}
    std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance& compiler, llvm::StringRef) override {
        return std::make_unique<TypeConsumer>(headers_, places_, sink_, into_, compiler.getPreprocessor());
    }

private:
    const std::vector<model::Header>& headers_;
    const SourcePlaces& places_;
    diag::Sink& sink_;
    model::TypeModel& into_;
};

/// Remembers every file that was opened, system headers too: a new compiler must regenerate.
class FileCollector : public clang::DependencyCollector {
public:
    bool needSystemDependencies() override { return true; }
};

std::vector<std::string> makeArguments(const ParseRequest& request, const std::string& resourceDir) {
    std::vector<std::string> arguments = {"typegen",         "--driver-mode=g++", "-xc++",
                                          "-std=c++17",      "-fsyntax-only",     "-w",
                                          "-ferror-limit=0", "-resource-dir",     resourceDir,
                                          "-D__orogen",      "-D__orogen2",       "-DOROCOS_TARGET=" + request.target};
    arguments.insert(arguments.end(), request.flags.begin(), request.flags.end());
    arguments.push_back(kMainFile);
    return arguments;
}

std::string makeMainText(const std::vector<model::Header>& headers) {
    std::string text;
    for (const model::Header& header : headers) text += "#include \"" + header.path + "\"\n";
    return text;
}

std::shared_ptr<clang::CompilerInvocation> makeInvocation(const ParseRequest& request, const std::string& resourceDir,
                                                          const std::vector<model::Header>& headers,
                                                          clang::DiagnosticsEngine& diagnostics) {
    const std::vector<std::string> arguments = makeArguments(request, resourceDir);
    std::vector<const char*> words;
    for (const std::string& argument : arguments) words.push_back(argument.c_str());
    clang::CreateInvocationOptions options;
    options.Diags = &diagnostics;
    std::shared_ptr<clang::CompilerInvocation> invocation = clang::createInvocation(words, options);
    if (!invocation) return nullptr;
    invocation->getFrontendOpts().SkipFunctionBodies = true;
    invocation->getFrontendOpts().DisableFree = false;   // one process may read many times, as the tests do
    invocation->getDiagnosticOpts().ShowCarets = false;  // else it counts errors on stderr by itself
    invocation->getPreprocessorOpts().addRemappedFile(
        kMainFile, llvm::MemoryBuffer::getMemBufferCopy(makeMainText(headers)).release());
    return invocation;
}

/// The compiler's errors go into `compileErrors`, those about types into `sink`. False if it could not start.
bool read(const ParseRequest& request, const std::string& resourceDir, const std::vector<model::Header>& headers,
          diag::Sink& compileErrors, diag::Sink& sink, model::TypeModel& into) {
    const SourcePlaces places(request.headers);
    DiagnosticBridge bridge(places, compileErrors, headers.empty() ? "typegen" : headers.back().path);
    const auto diagnostics =
        clang::CompilerInstance::createDiagnostics(new clang::DiagnosticOptions, &bridge, /*ShouldOwnClient=*/false);
    clang::CompilerInstance compiler;
    const auto invocation = makeInvocation(request, resourceDir, headers, *diagnostics);
    if (!invocation) return false;
    const auto files = std::make_shared<FileCollector>();
    compiler.setInvocation(invocation);
    compiler.createDiagnostics(&bridge, /*ShouldOwnClient=*/false);
    bridge.goOnAfterFatalErrors(compiler.getDiagnostics());
    compiler.addDependencyCollector(files);
    TypeAction action(headers, places, sink, into);
    const bool started = compiler.ExecuteAction(action);
    for (const std::string& file : files->getDependencies()) {
        if (file != kMainFile) into.files.push_back(file);
    }
    return started || compileErrors.hadErrors();
}

/// A header may have swallowed those after it, a '}' being forgotten: each once more, alone. What the compiler says then
/// is left out, as some headers only make sense after others; of those what was found in the whole is true too.
diag::Sink readEachAlone(const ParseRequest& request, const std::string& resourceDir, const diag::Sink& inWhole) {
    diag::Sink found;
    std::set<std::string> complete;
    std::set<std::pair<diag::Location, std::string>> known;
    for (const model::Header& header : request.headers) {
        diag::Sink compileErrors;
        model::TypeModel unused;
        read(request, resourceDir, {header}, compileErrors, found, unused);
        if (!compileErrors.hadErrors()) complete.insert(header.path);
    }
    for (const diag::Diagnostic& one : found.all()) known.emplace(one.where, one.code);
    for (const diag::Diagnostic& one : inWhole.all()) {
        if (complete.count(one.where.file) == 0 && known.count({one.where, one.code}) == 0) found.add(one);
    }
    return found;
}

}  // namespace

std::optional<model::TypeModel> readTypes(const ParseRequest& request, diag::Sink& sink) {
    const auto resourceDir = findResourceDir(request.resourceDir, sink);
    if (!resourceDir) return std::nullopt;
    model::TypeModel result;
    result.headers = request.headers;
    const std::size_t errorsBefore = sink.errorCount();
    diag::Sink compileErrors, aboutTypes;
    const bool started = read(request, *resourceDir, request.headers, compileErrors, aboutTypes, result);
    if (compileErrors.hadErrors() && request.headers.size() > 1) {
        aboutTypes = readEachAlone(request, *resourceDir, aboutTypes);
    }
    for (const diag::Diagnostic& found : aboutTypes.all()) sink.add(found);
    for (const diag::Diagnostic& error : compileErrors.all()) sink.add(error);
    if (sink.errorCount() != errorsBefore) return std::nullopt;
    if (!started) {
        sink.error({"typegen"}, "TK006", "the compiler could not be started with these options");
        return std::nullopt;
    }
    return result;
}

}  // namespace oroforge::cxx
