// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "attributes.hpp"

#include <algorithm>

#include <xml/escape.hpp>

namespace oroforge::cxx {

namespace {

void set(DocComment& doc, llvm::StringRef name, const std::string& value) {
    if (name == "unit") doc.unit = value;
    if (name == "range") doc.range = value;
    if (name == "doc") doc.text = value;
    if (name == "capacity") doc.capacity = value;
    if (name == "make") doc.make = value;
    if (name == "ros") doc.ros = value.empty() ? " " : value;
    if (name == "skip") doc.skip = true;
    if (name == "text") doc.asText = true;
    if (name == "bytes") doc.bytes = true;
    if (name == "by_value") doc.byValue = true;
}

/// Returns the end of the declaration before this one, or its class's beginning: attributes after that may be its own.
clang::SourceLocation beginOf(const clang::Decl& declaration) {
    clang::SourceLocation begin;
    const clang::DeclContext* scope = declaration.getLexicalDeclContext();
    if (const auto* record = llvm::dyn_cast<clang::TagDecl>(scope))
        begin = record->getBraceRange().getBegin();
    else if (!scope->isTranslationUnit())
        begin = llvm::cast<clang::Decl>(scope)->getBeginLoc();
    for (const clang::Decl* other : declaration.getLexicalDeclContext()->decls()) {
        if (other == &declaration) break;
        if (!other->isImplicit() && !llvm::isa<clang::AccessSpecDecl>(other)) begin = other->getEndLoc();
    }
    const clang::SourceManager& sources = declaration.getASTContext().getSourceManager();
    if (begin.isInvalid() && scope->isTranslationUnit())
        begin = sources.getLocForStartOfFile(sources.getFileID(sources.getExpansionLoc(declaration.getLocation())));
    return begin;
}

/// For a type, returns the end of its head.
clang::SourceLocation endOf(const clang::Decl& declaration) {
    const auto* tag = llvm::dyn_cast<clang::TagDecl>(&declaration);
    return tag != nullptr && tag->isThisDeclarationADefinition() ? tag->getBraceRange().getBegin()
                                                                 : declaration.getEndLoc();
}

}  // namespace

void Attributes::take(const clang::Token& token) {
    if (brackets_ == 2) return takeInside(token);
    if (closing_ == 1 && token.isOneOf(clang::tok::semi, clang::tok::equal, clang::tok::comma)) notes_.resize(before_);
    if (closing_ != 0) --closing_;
    brackets_ = token.is(clang::tok::l_square) ? brackets_ + 1 : 0;
    if (brackets_ != 2) return;
    before_ = notes_.size();
    isOurs_ = false;
    depth_ = 0;
    name_.clear();
    value_.clear();
}

void Attributes::takeInside(const clang::Token& token) {
    if (depth_ == 0 && token.isOneOf(clang::tok::comma, clang::tok::r_square, clang::tok::eof)) {
        endAttribute(token.getLocation());
        if (token.is(clang::tok::comma)) return;
        brackets_ = 0;
        closing_ = 2;
    } else if (depth_ == 0 && name_.empty() && !isOurs_) {
        name_ = preprocessor_->getSpelling(token);
    } else if (depth_ == 0 && token.is(clang::tok::coloncolon)) {
        isOurs_ = name_ == "oro";
    } else if (depth_ == 0 && token.isNot(clang::tok::l_paren)) {
        name_ = preprocessor_->getSpelling(token);
    } else if (token.is(clang::tok::l_paren) && depth_++ == 0) {
        // the value begins
    } else if (token.is(clang::tok::r_paren) && --depth_ == 0) {
        // the value is complete
    } else if (clang::tok::isStringLiteral(token.getKind())) {
        value_ += clang::StringLiteralParser(token, *preprocessor_).GetString().str();
    } else {
        value_ += token.is(clang::tok::comma) ? ".." : preprocessor_->getSpelling(token);
    }
}

void Attributes::endAttribute(clang::SourceLocation at) {
    if (isOurs_) notes_.push_back({name_, xml::asUtf8(value_), at});
    isOurs_ = false;
    name_.clear();
    value_.clear();
}

void Attributes::addTo(DocComment& doc, const clang::Decl& declaration) const {
    for (const auto* annotation : declaration.specific_attrs<clang::AnnotateAttr>()) {
        const auto [name, value] = annotation->getAnnotation().split('=');
        if (name.starts_with("oro.")) set(doc, name.drop_front(4), xml::asUtf8(value.str()));
    }
    if (notes_.empty()) return;
    const clang::SourceManager& sources = declaration.getASTContext().getSourceManager();
    const clang::SourceLocation begin = beginOf(declaration), end = endOf(declaration);
    if (begin.isInvalid() || end.isInvalid()) return;
    const auto isBefore = [&](clang::SourceLocation a, clang::SourceLocation b) {
        return sources.isBeforeInTranslationUnit(a, b);
    };
    const auto first = std::lower_bound(notes_.begin(), notes_.end(), begin,
                                        [&](const Note& note, auto at) { return isBefore(note.at, at); });
    for (auto note = first; note != notes_.end() && isBefore(note->at, end); ++note) set(doc, note->name, note->value);
}

}  // namespace oroforge::cxx
