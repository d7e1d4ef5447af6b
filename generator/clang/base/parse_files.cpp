// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "parse_files.hpp"

#include <array>

#include "large_stack.hpp"
#include "lean_library.hpp"
#include "nesting_limit.hpp"
#include "type_names.hpp"

namespace oroforge::cxx {

namespace {

class Consumer : public clang::SemaConsumer {
public:
    explicit Consumer(const Parse& parse) : parse_(parse) {}
    void InitializeSema(clang::Sema& sema) override { sema_ = &sema; }
    void ForgetSema() override { sema_ = nullptr; }
    void HandleTagDeclDefinition(clang::TagDecl* type) override { dropComparisons(*type); }
    bool shouldSkipFunctionBody(clang::Decl* function) override { return parse_.skipsBody(*function); }
    void HandleTranslationUnit(clang::ASTContext&) override { parse_.end(*sema_); }

private:
    const Parse& parse_;
    clang::Sema* sema_ = nullptr;
};

class Action : public clang::ASTFrontendAction {
public:
    explicit Action(const Parse& parse) : parse_(parse) {}
    std::unique_ptr<clang::ASTConsumer> CreateASTConsumer(clang::CompilerInstance& compiler, llvm::StringRef) override {
        if (parse_.begin) parse_.begin(compiler);
        compiler.getPreprocessor().setTokenWatcher(
            [this, &engine = compiler.getDiagnostics()](const clang::Token& word) {
                nesting_.take(word, engine);
                if (parse_.word) parse_.word(word);
            });
        return std::make_unique<Consumer>(parse_);
    }

private:
    const Parse& parse_;
    NestingLimit nesting_;
};

llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> filesOf(const Parse& parse) {
    auto memory = llvm::makeIntrusiveRefCnt<llvm::vfs::InMemoryFileSystem>();
    llvm::SmallString<256> here;
    if (!llvm::sys::fs::current_path(here)) memory->setCurrentWorkingDirectory(here.str().str());
    for (const auto& [name, text] : parse.files)
        memory->addFile(name, 0, llvm::MemoryBuffer::getMemBufferCopy(text, name));
    auto all = llvm::makeIntrusiveRefCnt<llvm::vfs::OverlayFileSystem>(llvm::vfs::getRealFileSystem());
    all->pushOverlay(memory);
    return all;
}

std::shared_ptr<clang::CompilerInvocation> invocationOf(const Parse& parse, clang::CreateInvocationOptions options) {
    std::vector<const char*> words = {"oroforge", "--driver-mode=g++", "-xc++",        "-std=c++17", "-fsyntax-only",
                                      "-w",       "-ferror-limit=0",   "-resource-dir"};
    words.push_back(parse.resourceDir.c_str());
    for (const std::string& flag : parse.flags) words.push_back(flag.c_str());
    words.push_back(parse.mainFile.c_str());
    std::shared_ptr<clang::CompilerInvocation> invocation = clang::createInvocation(words, std::move(options));
    if (!invocation) return nullptr;
    invocation->getFrontendOpts().SkipFunctionBodies = true;  // clang then asks shouldSkipFunctionBody()
    invocation->getFrontendOpts().DisableFree = false;        // one process may parse several times
    invocation->getDiagnosticOpts().ShowCarets = false;       // otherwise clang prints the number of errors to stderr
    return invocation;
}

bool parseHere(const Parse& parse) {
    const auto files = filesOf(parse);
    clang::CreateInvocationOptions options;
    options.Diags = clang::CompilerInstance::createDiagnostics(new clang::DiagnosticOptions, parse.messages,
                                                               /*ShouldOwnClient=*/false);
    options.VFS = files;
    const auto invocation = invocationOf(parse, options);
    if (!invocation) return false;
    clang::CompilerInstance compiler;
    compiler.setInvocation(invocation);
    compiler.createDiagnostics(parse.messages, /*ShouldOwnClient=*/false);
    compiler.getDiagnostics().setFatalsAsError(true);  // a missing file must not hide other errors
    compiler.createFileManager(files);
    Action action(parse);
    return compiler.ExecuteAction(action);
}

}  // namespace

bool parseFiles(const Parse& parse) {
    bool started = false;
    runOnLargeStack([&] { started = parseHere(parse); });
    return started;
}

bool isLibrary(const clang::Decl& declaration) {
    const clang::SourceManager& sources = declaration.getASTContext().getSourceManager();
    if (sources.isInSystemHeader(sources.getExpansionLoc(declaration.getLocation()))) return true;
    static const std::array names = {"std", "boost", "RTT", "__gnu_cxx"};
    return std::find(names.begin(), names.end(), outermostNamespace(declaration)) != names.end();
}

}  // namespace oroforge::cxx
