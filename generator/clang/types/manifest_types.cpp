// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "manifest_types.hpp"

#include <map>

#include <clang/base/parse_files.hpp>
#include <clang/base/resource_dir.hpp>
#include <clang/base/type_names.hpp>

#include "attributes.hpp"
#include "classify.hpp"
#include "find_accessors.hpp"

namespace oroforge::cxx {

namespace {

const std::string kTypeProbe = "oroforge_type_";

/// Each question has a line, so that the line of an error identifies the question.
struct ProbeText {
    std::string text;
    std::map<unsigned, std::size_t> types, values;  ///< line → question
};

/// Rejects text that could swallow the next line; it cannot be an enumerator anyway.
bool isHarmless(const std::string& value) { return value.find_first_of("\n\r{};\"'#\\/") == std::string::npos; }

ProbeText probeTextOf(const TypeLookupRequest& request) {
    ProbeText result;
    unsigned line = 1;
    const auto add = [&](const std::string& words) {
        result.text += words + "\n";
        return line++;
    };
    for (const std::string& header : request.standardHeaders) add("#include <" + header + ">");
    for (const std::string& header : request.headers) add("#include \"" + header + "\"");
    for (std::size_t i = 0; i != request.questions.size(); ++i) {
        const TypeQuestion& question = request.questions[i];
        const std::string number = std::to_string(i);
        const std::string open = question.space.empty() ? "" : "namespace " + question.space + " { ";
        const std::string close = question.space.empty() ? "" : " }";
        result.types[add(open + "using " + kTypeProbe + number + " = " + question.type + ";" + close)] = i;
        if (question.value.empty() || !isHarmless(question.value)) continue;  // such text is reported elsewhere
        result.values[add(open + "const " + kTypeProbe + number + " oroforge_value_" + number + " = " + question.value +
                          ";" + close)] = i;
    }
    return result;
}

/// Keeps the first error of each probe's line; an error elsewhere means that the headers were not understood.
class ProbeMessages : public clang::DiagnosticConsumer {
public:
    ProbeMessages(const ProbeText& probes, TypeLookup& result) : probes_(probes), result_(result) {}

    void HandleDiagnostic(clang::DiagnosticsEngine::Level level, const clang::Diagnostic& info) override {
        clang::DiagnosticConsumer::HandleDiagnostic(level, info);
        if (level < clang::DiagnosticsEngine::Error) return;
        llvm::SmallString<128> text;
        info.FormatDiagnostic(text);
        if (info.hasSourceManager() && info.getLocation().isValid()) {
            const clang::SourceManager& sources = info.getSourceManager();
            const clang::SourceLocation at = sources.getExpansionLoc(info.getLocation());
            const unsigned line = sources.getExpansionLineNumber(at);
            if (sources.isInMainFile(at) && note(probes_.types, line, &TypeAnswer::fault, text.str().str())) return;
            if (sources.isInMainFile(at) && note(probes_.values, line, &TypeAnswer::valueFault, text.str().str()))
                return;
        }
        result_.isSound = false;
    }

private:
    bool note(const std::map<unsigned, std::size_t>& lines, unsigned line, std::string TypeAnswer::*where,
              const std::string& text) {
        const auto found = lines.find(line);
        if (found == lines.end()) return false;
        std::string& fault = result_.answers[found->second].*where;
        if (fault.empty()) fault = text;
        return true;
    }

    const ProbeText& probes_;
    TypeLookup& result_;
};

class TypeLister {
public:
    TypeLister(clang::ASTContext& context, const Attributes& attributes, TypeLookup& result)
        : context_(context), attributes_(attributes), result_(result) {}

    void walk(const clang::DeclContext& scope) {
        for (const clang::Decl* declaration : scope.decls()) {
            const auto* named = llvm::dyn_cast<clang::NamedDecl>(declaration);
            if (llvm::isa<clang::LinkageSpecDecl>(declaration)) walk(*llvm::cast<clang::DeclContext>(declaration));
            if (named == nullptr || !named->getIdentifier() || isOfSystem(*named)) continue;
            if (named->getName().starts_with(kTypeProbe)) {
                answer(*llvm::cast<clang::TypedefNameDecl>(named));
                continue;
            }
            if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(named)) walk(*space);
            const auto access = named->getAccess();
            if (access == clang::AS_private || access == clang::AS_protected) continue;
            if (llvm::isa<clang::TagDecl, clang::TypedefNameDecl, clang::ClassTemplateDecl,
                          clang::TypeAliasTemplateDecl>(named) &&
                !named->isImplicit())
                result_.names.push_back(named->getQualifiedNameAsString());
            if (const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(named)) walk(*record);
        }
    }

private:
    bool isOfSystem(const clang::NamedDecl& declaration) const {
        const clang::SourceManager& sources = context_.getSourceManager();
        return sources.isInSystemHeader(sources.getExpansionLoc(declaration.getLocation()));
    }

    void answer(const clang::TypedefNameDecl& probe) {
        TypeAnswer& answer = result_.answers[std::stoul(probe.getName().substr(kTypeProbe.size()).str())];
        const clang::QualType type = probe.getUnderlyingType().getNonReferenceType().getCanonicalType();
        if (const auto* enumeration = type->getAs<clang::EnumType>()) {
            for (const clang::EnumConstantDecl* value : enumeration->getDecl()->enumerators())
                answer.enumerators.push_back(value->getQualifiedNameAsString());
        }
        for (const clang::TagDecl* user : classifyValue(type, context_).users) {
            const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(user);
            if (record != nullptr && record->getDefinition() != nullptr && answer.noValue.empty())
                answer.noValue = whyNoValue(*record->getDefinition());
        }
    }

    /// Returns why typegen rejects a class in a listed header. Other classes may have adapters.
    std::string whyNoValue(const clang::CXXRecordDecl& type) const {
        if (!isListed(type) || docOf(type).skip) return "";
        if (type.isPolymorphic()) return "has virtual functions";
        for (const clang::FieldDecl* field : type.fields()) {
            const bool isHidden = field->getAccess() == clang::AS_private || field->getAccess() == clang::AS_protected;
            if (isHidden && !docOf(*field).skip && !findAccessors(*field))
                return "has the field '" + field->getNameAsString() + "', which is not public";
        }
        return "";
    }

    DocComment docOf(const clang::Decl& declaration) const {
        DocComment doc = docComment(context_, declaration);
        attributes_.addTo(doc, declaration);
        return doc;
    }

    /// True if the type is in a file that the main file includes.
    bool isListed(const clang::CXXRecordDecl& type) const {
        const clang::SourceManager& sources = context_.getSourceManager();
        const clang::FileID file = sources.getFileID(sources.getExpansionLoc(type.getLocation()));
        return !llvm::isa<clang::ClassTemplateSpecializationDecl>(type) &&
               sources.isInMainFile(sources.getIncludeLoc(file));
    }

    clang::ASTContext& context_;
    const Attributes& attributes_;
    TypeLookup& result_;
};

}  // namespace

TypeLookup lookUpTypes(const TypeLookupRequest& request) {
    TypeLookup result;
    for (const TypeQuestion& question : request.questions)
        result.answers.push_back({"", "", {}, isHarmless(question.value) ? "" : "it is no expression"});
    diag::Sink unused;
    const auto resourceDir = findResourceDir("", unused);
    const ProbeText probes = probeTextOf(request);
    ProbeMessages messages(probes, result);
    Attributes attributes;
    clang::DependencyCollector files;
    Parse parse;
    parse.mainFile = "orocreate_pkg_input.cpp";
    parse.files[parse.mainFile] = probes.text;
    parse.flags = request.flags;
    parse.resourceDir = resourceDir.value_or("");
    parse.messages = &messages;
    parse.skipsBody = [](clang::Decl&) { return true; };
    parse.begin = [&](clang::CompilerInstance& compiler) {
        files.attachToPreprocessor(compiler.getPreprocessor());
        attributes.watch(compiler.getPreprocessor());
        compiler.getPreprocessor().setTokenWatcher([&](const clang::Token& token) { attributes.take(token); });
    };
    parse.end = [&](clang::Sema& sema) {
        TypeLister(sema.getASTContext(), attributes, result).walk(*sema.getASTContext().getTranslationUnitDecl());
    };
    // parseFiles() is also false if only probes fail.
    if (!resourceDir || (!parseFiles(parse) && messages.getNumErrors() == 0)) result.isSound = false;
    for (const std::string& file : files.getDependencies())
        if (file != parse.mainFile) result.headers.push_back(file);
    return result;
}

}  // namespace oroforge::cxx
