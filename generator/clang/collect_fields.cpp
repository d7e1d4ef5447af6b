// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "collect_fields.hpp"

#include "doc_comment.hpp"
#include "type_names.hpp"

namespace oroforge::cxx {

namespace {

const clang::TagDecl& ownerOf(const clang::FieldDecl& field) {
    const clang::RecordDecl* owner = field.getParent();
    while (owner->isAnonymousStructOrUnion()) owner = llvm::cast<clang::RecordDecl>(owner->getParent());
    return *owner;
}

std::string subjectOf(const clang::FieldDecl& field) {
    const std::string own = field.getNameAsString();
    return (own.empty() ? "unnamed member" : "field '" + own + "'") + " of '" + shownName(ownerOf(field)) + "'";
}

Rejection makeRejection(Reason reason, std::string subject, std::string type, clang::SourceLocation at) {
    Rejection rejection;
    rejection.reason = reason;
    rejection.subject = std::move(subject);
    rejection.type = std::move(type);
    rejection.at = at;
    return rejection;
}

}  // namespace

void FieldCollector::addRecord(const clang::CXXRecordDecl& type, std::uint64_t offset) {
    const clang::ASTRecordLayout& layout = types_.context().getASTRecordLayout(&type);
    for (const clang::CXXBaseSpecifier& base : type.bases()) addBase(type, base, offset);
    for (const clang::FieldDecl* field : type.fields()) {
        addField(*field, offset + layout.getFieldOffset(field->getFieldIndex()) / 8);
    }
}

void FieldCollector::addBase(const clang::CXXRecordDecl& type, const clang::CXXBaseSpecifier& specifier,
                             std::uint64_t offset) {
    const clang::CXXRecordDecl& base = *specifier.getType()->getAsCXXRecordDecl()->getDefinition();
    const std::string subject = "base class '" + shownName(base) + "' of '" + shownName(type) + "'";
    Rejection rejection = makeRejection(Reason::OtherStandard, subject, shownName(base), specifier.getBeginLoc());
    if (specifier.isVirtual()) {
        rejection.reason = Reason::VirtualBase;
    } else if (specifier.getAccessSpecifier() != clang::AS_public) {
        rejection.reason = Reason::HiddenBase;
    } else if (!isStandard(base)) {
        if (base_.empty()) baseAt_ = specifier.getBeginLoc();
        const std::string outer = std::exchange(base_, shownName(base));
        const std::size_t before = rejections_.size();
        addRecord(base, offset + types_.context().getASTRecordLayout(&type).getBaseClassOffset(&base).getQuantity());
        base_ = outer;
        if (rejections_.size() == before) return;
        rejection.causes.assign(rejections_.begin() + before, rejections_.end());
        rejections_.resize(before);
        rejection.type.clear();
        // The user's own base class speaks for itself, at its own fields.
        broken_ = true;
        if (types_.isOwn(base)) return;
    }
    rejections_.push_back(rejection);
}

void FieldCollector::reject(const clang::FieldDecl& field, Reason reason) {
    rejections_.push_back(
        makeRejection(reason, subjectOf(field), shownName(field.getType(), types_.context()), field.getLocation()));
}

void FieldCollector::rejectName(const clang::FieldDecl& field) {
    clashes_.push_back(
        makeRejection(Reason::SameName, subjectOf(field), "", base_.empty() ? field.getLocation() : baseAt_));
}

std::vector<Rejection> FieldCollector::rejections() const {
    std::vector<Rejection> all = rejections_;
    all.insert(all.end(), clashes_.begin(), clashes_.end());
    return all;
}

void FieldCollector::addField(const clang::FieldDecl& field, std::uint64_t offset) {
    if (field.isUnnamedBitField()) return;  // padding only
    if (field.isAnonymousStructOrUnion()) {
        const clang::CXXRecordDecl& inner = *field.getType()->getAsCXXRecordDecl();
        return inner.isUnion() ? reject(field, Reason::Union) : addRecord(inner, offset);
    }
    if (field.getAccess() != clang::AS_public) return reject(field, Reason::PrivateMember);
    if (field.isBitField()) return reject(field, Reason::BitField);
    if (field.hasAttr<clang::NoUniqueAddressAttr>()) return reject(field, Reason::Overlapping);
    const auto align = types_.context().getTypeAlignInChars(field.getType()).getQuantity();
    const Classified type = classifyMember(field.getType(), types_.context());
    if (type.use && offset % align != 0) return reject(field, Reason::Misaligned);
    if (type.use && !names_.insert(field.getNameAsString()).second) return rejectName(field);
    addClassified(field, type, offset);
}

void FieldCollector::addClassified(const clang::FieldDecl& field, const Classified& type, std::uint64_t offset) {
    if (!usable(field, type)) return;
    const DocComment comment = docComment(types_.context(), field);
    model::Field result;
    result.name = field.getNameAsString();
    result.type = *type.use;
    result.count = type.count;
    result.offset = offset;
    result.doc = comment.text;
    result.unit = comment.unit;
    result.base = base_;
    result.where = types_.locate(field.getLocation());
    fields_.push_back(result);
}

bool FieldCollector::usable(const clang::FieldDecl& field, const Classified& type) {
    const clang::ASTContext& context = types_.context();
    if (!type.use) {
        const bool isElement =
            !context.hasSameType(type.culprit.getUnqualifiedType(), field.getType().getUnqualifiedType());
        rejections_.push_back(makeRejection(type.reason, (isElement ? "element of " : "") + subjectOf(field),
                                            shownName(type.culprit, context), field.getLocation()));
        return false;
    }
    const clang::TagDecl* tag = type.record;
    if (type.enumeration != nullptr) tag = type.enumeration;
    if (tag == nullptr) return true;
    if (tag->getDefinition() == nullptr) {
        reject(field, Reason::NeverDefined);
        return false;
    }
    if (isHidden(*tag)) {
        reject(field, Reason::HiddenType);
        return false;
    }
    const TypeFate& fate = type.record != nullptr ? types_.describe(*type.record) : types_.describe(*type.enumeration);
    if (fate.usable) return true;
    broken_ = true;
    if (!fate.rejections.empty()) {
        Rejection rejection = makeRejection(fate.rejections.front().reason, subjectOf(field),
                                            shownName(field.getType(), context), field.getLocation());
        rejection.causes = fate.rejections;
        rejections_.push_back(rejection);
    }
    return false;
}

}  // namespace oroforge::cxx
