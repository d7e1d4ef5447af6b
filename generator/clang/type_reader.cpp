// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "type_reader.hpp"

#include "describe_type.hpp"
#include "diagnostic_bridge.hpp"
#include "find_roots.hpp"

namespace oroforge::cxx {

namespace {

/// Works on the finished AST; Sema is still there, to ask for implicit constructors.
class TypeConsumer : public clang::SemaConsumer {
public:
    TypeConsumer(const SourcePlaces& places, diag::Sink& sink, model::TypeModel& into)
        : places_(places), sink_(sink), into_(into) {}
    void InitializeSema(clang::Sema& sema) override { sema_ = &sema; }
    void ForgetSema() override { sema_ = nullptr; }
    void HandleTranslationUnit(clang::ASTContext& context) override {
        // After a compile error types may be incomplete in ways that would only cause follow-up errors.
        if (context.getDiagnostics().hasErrorOccurred()) return;
        TypeDescriber types(*sema_, places_, sink_, into_);
        for (const clang::TagDecl* root : findRoots(context, places_)) {
            if (const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(root)) types.describe(*record);
            if (const auto* enumeration = llvm::dyn_cast<clang::EnumDecl>(root)) types.describe(*enumeration);
        }
    }

private:
    const SourcePlaces& places_;
    diag::Sink& sink_;
    model::TypeModel& into_;
    clang::Sema* sema_ = nullptr;
};

class TypeAction : public clang::ASTFrontendAction {
public:
    TypeAction(const SourcePlaces& places, diag::Sink& sink, model::TypeModel& into)
        : places_(places), sink_(sink), into_(into) {}
    std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance&, llvm::StringRef) override {
        return std::make_unique<TypeConsumer>(places_, sink_, into_);
    }

private:
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
        kMainFile, llvm::MemoryBuffer::getMemBufferCopy(makeMainText(request.headers)).release());
    return invocation;
}

}  // namespace

std::optional<model::TypeModel> readTypes(const ParseRequest& request, diag::Sink& sink) {
    const auto resourceDir = findResourceDir(request.resourceDir, sink);
    if (!resourceDir) return std::nullopt;
    model::TypeModel result;
    result.headers = request.headers;
    const std::size_t errorsBefore = sink.errorCount();
    const SourcePlaces places(request.headers);
    DiagnosticBridge bridge(places, sink);
    const auto diagnostics =
        clang::CompilerInstance::createDiagnostics(new clang::DiagnosticOptions, &bridge, /*ShouldOwnClient=*/false);

    clang::CompilerInstance compiler;
    const auto invocation = makeInvocation(request, *resourceDir, *diagnostics);
    const auto files = std::make_shared<FileCollector>();
    bool parsed = false;
    if (invocation) {
        compiler.setInvocation(invocation);
        compiler.createDiagnostics(&bridge, /*ShouldOwnClient=*/false);
        compiler.addDependencyCollector(files);
        TypeAction action(places, sink, result);
        parsed = compiler.ExecuteAction(action);
    }
    if (sink.errorCount() != errorsBefore) return std::nullopt;
    if (!parsed) {
        sink.error({"typegen"}, "TK006", "the compiler could not be started with these options");
        return std::nullopt;
    }
    for (const std::string& file : files->getDependencies()) {
        if (file != kMainFile) result.files.push_back(file);
    }
    return result;
}

}  // namespace oroforge::cxx
