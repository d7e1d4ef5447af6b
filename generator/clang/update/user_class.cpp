// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "user_class.hpp"

#include <algorithm>
#include <set>

#include <clang/base/resource_dir.hpp>

#include "conditional_watch.hpp"
#include "function_spans.hpp"
#include "registrations.hpp"
#include "source_run.hpp"

namespace oroforge::cxx {

namespace {

const char* const kProbe = "oroforge_probe_";

/// Returns functions with the wanted signatures, in the class's namespace, so that the compiler resolves the types.
std::string probes(const UserCodeRequest& request) {
    std::string marks, functions;
    for (std::size_t i = 0; i != request.classes.size(); ++i) {
        const WantedClass& wanted = request.classes[i];
        const std::size_t end = wanted.name.rfind("::");
        const std::string open = end == std::string::npos ? "" : "namespace " + wanted.name.substr(0, end) + " {\n";
        const std::string close = end == std::string::npos ? "" : "}\n";
        // The marks come first, so that an unknown type cannot hide one.
        marks += open + "struct " + (kProbe + std::to_string(i)) + " {};\n" + close;
        functions += open;
        for (std::size_t j = 0; j != wanted.signatures.size(); ++j) {
            const model::Signature& signature = wanted.signatures[j];
            functions += signature.returns + " " + kProbe + std::to_string(i) + "_" + std::to_string(j) + "(";
            for (const model::TypedName& argument : signature.arguments)
                functions += (&argument == &signature.arguments.front() ? "" : ", ") + argument.type;
            functions += ");\n";
        }
        functions += close;
    }
    return "\n\n" + marks + functions;
}

/// The findings of all sources.
struct Found {
    model::UserCode code;
    std::vector<std::vector<model::CanonicalSignature>> canonical;
};

model::Access accessOf(const clang::Decl& declaration) {
    switch (declaration.getAccess()) {
        case clang::AS_protected: return model::Access::Protected;
        case clang::AS_private: return model::Access::Private;
        default: return model::Access::Public;
    }
}

bool derivesFrom(const clang::CXXRecordDecl& type, const std::string& base) {
    if (!type.hasDefinition()) return false;
    for (const clang::CXXBaseSpecifier& one : type.bases()) {
        const clang::CXXRecordDecl* record = one.getType()->getAsCXXRecordDecl();
        if (record != nullptr && (record->getQualifiedNameAsString() == base || derivesFrom(*record, base)))
            return true;
    }
    return false;
}

/// Returns "InputPort" and so on, with its argument, if the type is RTT's.
const clang::ClassTemplateSpecializationDecl* wrapperOf(clang::QualType type, std::string& name) {
    const auto* record =
        llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(type.getCanonicalType()->getAsCXXRecordDecl());
    if (record == nullptr || record->getTemplateArgs().size() == 0) return nullptr;
    static const std::set<std::string> known = {"RTT::InputPort", "RTT::OutputPort", "RTT::Property", "RTT::Attribute",
                                                "RTT::Constant"};
    const std::string qualified = record->getQualifiedNameAsString();
    if (known.count(qualified) == 0) return nullptr;
    if (record->getTemplateArgs()[0].getKind() != clang::TemplateArgument::Type) return nullptr;
    name = qualified.substr(5);
    return record;
}

class ClassReader : public SourceVisitor {
public:
    ClassReader(const UserCodeRequest& request, const SourceRun& run, Found& found)
        : request_(request), run_(run), found_(found) {}

    void begin(clang::Preprocessor& preprocessor) override {
        watchConditionals(preprocessor, run_, found_.code.conditionals);
    }

    void visit(clang::Sema& sema) override {
        const clang::ASTContext& context = sema.getASTContext();
        const PackagePlaces places(context.getSourceManager(), run_);
        places_ = &places;
        for (const clang::Decl* one : context.getTranslationUnitDecl()->decls()) walk(*one);
        places_ = nullptr;
    }

    /// True if the text after the source was read at the outermost level: all braces before it are closed.
    bool sawProbes() const { return probes_ == request_.classes.size(); }
    const std::set<std::string>& files() const { return files_; }

private:
    void walk(const clang::Decl& declaration) {
        if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(&declaration)) return walkInside(*space);
        if (const auto* block = llvm::dyn_cast<clang::LinkageSpecDecl>(&declaration)) return walkInside(*block);
        if (places_->isBehind(declaration.getLocation())) return readProbe(declaration);
        const std::string file = places_->fileOf(declaration.getLocation());
        if (file.empty() || isGenerated(file)) return;
        files_.insert(file);
        if (const auto* type = llvm::dyn_cast<clang::CXXRecordDecl>(&declaration)) {
            if (type->isThisDeclarationADefinition()) readClass(*type, file);
        } else if (const auto* pattern = llvm::dyn_cast<clang::FunctionTemplateDecl>(&declaration)) {
            if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(pattern->getTemplatedDecl()))
                readOutside(*method, *pattern);
        } else if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(&declaration)) {
            readOutside(*method, *method);
        }
    }

    void walkInside(const clang::DeclContext& scope) {
        for (const clang::Decl* one : scope.decls()) walk(*one);
    }

    bool isGenerated(const std::string& file) const {
        return request_.generated.count(request_.root + "/" + file) != 0;
    }

    void readProbe(const clang::Decl& declaration) {
        const auto* named = llvm::dyn_cast<clang::NamedDecl>(&declaration);
        if (named == nullptr || named->getNameAsString().rfind(kProbe, 0) != 0) return;
        const std::string name = named->getNameAsString();
        char* rest = nullptr;
        const std::size_t i = std::strtoul(name.c_str() + std::string(kProbe).size(), &rest, 10);
        const std::string& wanted = request_.classes[i].name;
        const std::size_t end = wanted.rfind("::");
        const std::string space = end == std::string::npos ? "" : wanted.substr(0, end + 2);
        if (named->getQualifiedNameAsString() != space + name) return;
        if (*rest == '\0') {
            ++probes_;
        } else if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(named)) {
            const std::size_t j = std::strtoul(rest + 1, nullptr, 10);
            model::CanonicalSignature& known = found_.canonical[i][j];
            // Sources include different headers: the first one that knows the types answers.
            if (!known.known()) known = canonicalSignature(*function);
        }
    }

    const WantedClass* wantedFor(const clang::CXXRecordDecl& type) const {
        const std::string name = type.getQualifiedNameAsString();
        for (const WantedClass& wanted : request_.classes)
            if (wanted.name == name) return &wanted;
        return nullptr;
    }

    model::UserClass& classNamed(const std::string& name) {
        for (model::UserClass& one : found_.code.classes)
            if (one.name == name) return one;
        found_.code.classes.emplace_back();
        found_.code.classes.back().name = name;
        return found_.code.classes.back();
    }

    void readClass(const clang::CXXRecordDecl& type, const std::string& file) {
        const WantedClass* wanted = wantedFor(type);
        if (wanted == nullptr) return;
        model::UserClass& into = classNamed(wanted->name);
        if (!into.file.empty()) return readMembers(type, into);  // several sources include this header
        const clang::SourceRange braces = type.getBraceRange();
        into.file = file;
        into.where = places_->locate(type.getLocation());
        into.isMacro = type.getLocation().isMacroID() || braces.getBegin().isMacroID() || braces.getEnd().isMacroID();
        into.hasGeneratedBase = derivesFrom(type, wanted->base);
        into.isStruct = type.isStruct();
        into.whole = {places_->offset(type.getBeginLoc()), places_->offset(braces.getEnd()) + 1};
        into.body = {places_->offset(braces.getBegin()) + 1, places_->offset(braces.getEnd())};
        readMembers(type, into);
    }

    void readMembers(const clang::CXXRecordDecl& type, model::UserClass& into) {
        const bool first = into.labels.empty() && into.functions.empty();
        for (const clang::Decl* member : type.decls()) {
            if (member->isImplicit()) continue;
            if (const auto* label = llvm::dyn_cast<clang::AccessSpecDecl>(member)) {
                if (first && !label->getBeginLoc().isMacroID())
                    into.labels.push_back(
                        {accessOf(*label),
                         {places_->offset(label->getAccessSpecifierLoc()), places_->offset(label->getColonLoc()) + 1}});
            } else if (const auto* pattern = llvm::dyn_cast<clang::FunctionTemplateDecl>(member)) {
                if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(pattern->getTemplatedDecl()))
                    addFunction(*method, *pattern, into, true);
            } else if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member)) {
                addFunction(*method, *method, into, true);
            } else if (const auto* field = llvm::dyn_cast<clang::FieldDecl>(member)) {
                addField(*field, into);
            }
        }
    }

    void readOutside(const clang::CXXMethodDecl& method, const clang::Decl& outer) {
        if (wantedFor(*method.getParent()) == nullptr) return;
        addFunction(method, outer, classNamed(wantedFor(*method.getParent())->name), false);
    }

    void addFunction(const clang::CXXMethodDecl& method, const clang::Decl& outer, model::UserClass& into,
                     bool inClass) {
        model::UserFunction one;
        one.name = method.getNameAsString();
        if (llvm::isa<clang::CXXConstructorDecl>(method)) one.kind = model::FunctionKind::Constructor;
        if (llvm::isa<clang::CXXDestructorDecl>(method)) one.kind = model::FunctionKind::Destructor;
        one.access = accessOf(inClass || method.getPreviousDecl() == nullptr ? method : *method.getPreviousDecl());
        one.isTemplate = &outer != &method;
        one.isOther = method.isStatic() || method.isConst() || method.isVolatile() ||
                      method.getRefQualifier() != clang::RQ_None || method.isVariadic();
        one.inClass = inClass;
        one.file = places_->fileOf(method.getLocation());
        one.where = places_->locate(method.getLocation());
        fillSpans(method, outer, *places_, one);
        one.scope = inClass ? into.body : scopeAround(outer, *places_);
        if (const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(outer.getLexicalDeclContext()))
            one.space = space->getQualifiedNameAsString();
        one.types = canonicalSignature(method);
        if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(&method))
            addLiterals(*constructor, into);
        addRegistrations(method, into);
        for (const model::UserFunction& known : into.functions)
            if (known.file == one.file && known.nameSpan == one.nameSpan && known.whole == one.whole) return;
        into.functions.push_back(std::move(one));
    }

    void addLiterals(const clang::CXXConstructorDecl& constructor, model::UserClass& into) {
        for (const clang::CXXCtorInitializer* initializer : constructor.inits()) {
            if (!initializer->isMemberInitializer() || !initializer->isWritten()) continue;
            const std::string text = firstString(initializer->getInit());
            if (!text.empty()) literals_[into.name + "::" + initializer->getMember()->getNameAsString()] = text;
        }
        for (model::UserField& field : into.fields) giveLiteral(field, into);
    }

    void addRegistrations(const clang::CXXMethodDecl& method, model::UserClass& into) {
        if (!method.doesThisDeclarationHaveABody()) return;
        for (model::UserRegistration& one : registrationsIn(method, *places_)) {
            const auto same = [&](const model::UserRegistration& known) {
                return known.file == one.file && known.statement == one.statement;
            };
            if (std::none_of(into.registrations.begin(), into.registrations.end(), same))
                into.registrations.push_back(std::move(one));
        }
    }

    void giveLiteral(model::UserField& field, const model::UserClass& type) {
        const auto found = literals_.find(type.name + "::" + field.name);
        if (found != literals_.end() && field.literal.empty()) field.literal = found->second;
    }

    void addField(const clang::FieldDecl& field, model::UserClass& into) {
        model::UserField one;
        one.name = field.getNameAsString();
        one.file = places_->fileOf(field.getLocation());
        one.where = places_->locate(field.getLocation());
        for (const model::UserField& known : into.fields)
            if (known.name == one.name) return;
        const clang::ASTContext& context = field.getASTContext();
        const clang::ClassTemplateSpecializationDecl* wrapper = wrapperOf(field.getType(), one.portClass);
        const clang::QualType type = wrapper != nullptr ? wrapper->getTemplateArgs()[0].getAsType() : field.getType();
        if (!field.isInvalidDecl())
            one.canonical = type.getCanonicalType().getUnqualifiedType().getAsString(context.getPrintingPolicy());
        one.literal = firstString(field.getInClassInitializer());
        const bool macro = field.getBeginLoc().isMacroID() || field.getLocation().isMacroID();
        if (!macro) {
            one.whole.begin = places_->offset(field.getBeginLoc());
            const clang::SourceLocation end = behindSemicolon(context, field.getLocation());
            one.whole.end = end.isValid() ? places_->offset(end) : one.whole.begin;
            one.type = typeSpan(field, wrapper != nullptr ? one.portClass : "", one.portWord);
        }
        giveLiteral(one, into);
        into.fields.push_back(std::move(one));
    }

    /// For a port, returns the text between '<' and '>', and the word before it. Nothing if several names share a type.
    model::Span typeSpan(const clang::FieldDecl& field, const std::string& wrapper, model::Span& wrapperWord) const {
        clang::TypeLoc type = field.getTypeSourceInfo()->getTypeLoc();
        Words words(field.getASTContext(), field.getBeginLoc());
        clang::Token token;
        model::Span all, word;
        std::size_t open = 0, close = 0;
        bool severalNames = false;
        int depth = 0;
        bool behindName = false;
        while (words.next(token) && !token.is(clang::tok::semi)) {
            const std::size_t at = places_->offset(token.getLocation());
            if (token.getLocation() == field.getLocation()) behindName = true;
            if (behindName && token.isOneOf(clang::tok::equal, clang::tok::l_brace)) break;
            if (token.is(clang::tok::comma) && (behindName || depth == 0)) severalNames = true;
            if (token.is(clang::tok::l_square)) return {};
            if (behindName) continue;
            if (token.is(clang::tok::less) && ++depth == 1) open = at + 1;
            if (token.isOneOf(clang::tok::greater, clang::tok::greatergreater)) {
                depth -= token.is(clang::tok::greater) ? 1 : 2;
                close = at + token.getLength() - 1;
            }
            if (words.spelled(token) == "mutable" && all.empty()) continue;
            if (depth == 0 && words.spelled(token) == wrapper) word = {at, at + token.getLength()};
            if (all.empty()) all.begin = at;
            all.end = at + token.getLength();
        }
        if (severalNames || !behindName || type.getBeginLoc().isMacroID()) return {};
        if (wrapper.empty()) return all;
        wrapperWord = word;
        return open != 0 && close > open && close + 1 == all.end ? model::Span{open, close} : model::Span{};
    }

    const UserCodeRequest& request_;
    const SourceRun& run_;
    Found& found_;
    const PackagePlaces* places_ = nullptr;
    std::size_t probes_ = 0;
    std::set<std::string> files_;
    std::map<std::string, std::string> literals_;  ///< by member, with its class
};

void tell(const SourceRun& run, const std::vector<CompileMessage>& messages, bool sawProbes, diag::Sink& sink) {
    bool syntax = false;
    std::size_t told = 0;
    for (const CompileMessage& message : messages) {
        diag::Location where = message.where;
        if (where.file.empty()) where = {run.shown + run.file, 0, 0};
        if (message.kind == CompileMessage::MissingFile) {
            sink.warning(where, "OC038", message.text + "; what it declares is not understood")
                .hint("give the folder it is found in with -I DIR");
        }
        if (message.kind != CompileMessage::Syntax) continue;
        syntax = true;
        // One mistake makes many words hard to read.
        if (++told > 3) continue;
        sink.error(where, "OC037", message.text);
    }
    if (!syntax && !sawProbes)
        sink.error({run.shown + run.file, 0, 0}, "OC037",
                   "a '}' is missing at the end of the file or in what it includes");
}

bool holdsAny(const model::UserCode& code, const std::string& file) {
    return std::any_of(code.classes.begin(), code.classes.end(), [&](const model::UserClass& one) {
        return one.file == file ||
               std::any_of(one.functions.begin(), one.functions.end(),
                           [&](const model::UserFunction& function) { return function.file == file; });
    });
}

bool comesBefore(const model::UserFunction& a, const model::UserFunction& b) {
    return a.file != b.file ? a.file < b.file : a.whole < b.whole;
}

}  // namespace

model::UserCode readUserCode(const UserCodeRequest& request,
                             std::vector<std::vector<model::CanonicalSignature>>& canonical, diag::Sink& sink) {
    Found found;
    for (const WantedClass& wanted : request.classes) found.canonical.emplace_back(wanted.signatures.size());
    const auto resourceDir = findResourceDir("", sink);
    if (!resourceDir) return found.code;
    std::set<std::string> seen;
    const auto read = [&](const std::string& file) {
        SourceRun run{request.root,    file,        request.shown, request.flags, request.generated,
                      probes(request), *resourceDir};
        std::vector<CompileMessage> messages;
        ClassReader reader(request, run, found);
        if (!runOnSource(run, reader, messages)) {
            sink.error({request.shown + file, 0, 0}, "OC037", "the compiler could not be started with these options");
            return;
        }
        // A source without its headers, such as a test without its macros, counts only if it has such a class.
        const bool lacksHeaders = std::any_of(messages.begin(), messages.end(), [](const CompileMessage& one) {
            return one.kind == CompileMessage::MissingFile;
        });
        if (!lacksHeaders || holdsAny(found.code, file)) tell(run, messages, reader.sawProbes(), sink);
        seen.insert(reader.files().begin(), reader.files().end());
    };
    for (const std::string& source : request.sources) read(source);
    for (const std::string& header : request.headers)
        if (seen.count(header) == 0) read(header);
    for (model::UserClass& one : found.code.classes) {
        std::sort(one.functions.begin(), one.functions.end(), comesBefore);
        one.hasGeneratedBase = one.hasGeneratedBase && !one.file.empty();
    }
    canonical = std::move(found.canonical);
    return std::move(found.code);
}

}  // namespace oroforge::cxx
