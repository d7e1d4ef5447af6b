// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "collect_fields.hpp"

#include <clang/base/type_names.hpp>

#include "find_accessors.hpp"
#include "side_notes.hpp"

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

/// Adds the names of all fields, including those of base classes and anonymous structs.
void addNames(const clang::CXXRecordDecl& type, std::multiset<std::string>& names) {
    for (const clang::CXXBaseSpecifier& base : type.bases()) {
        const auto* record = base.getType()->getAsCXXRecordDecl();
        if (record != nullptr && record->hasDefinition()) addNames(*record->getDefinition(), names);
    }
    for (const clang::FieldDecl* field : type.fields()) {
        if (field->isAnonymousStructOrUnion())
            addNames(*field->getType()->getAsCXXRecordDecl(), names);
        else
            names.insert(field->getNameAsString());
    }
}

/// Returns "0.5" for `double gain = 0.5;`.
std::string initialOf(const clang::FieldDecl& field) {
    const clang::Expr* value = field.getInClassInitializer();
    if (value == nullptr) return "";
    const clang::ASTContext& context = field.getASTContext();
    const auto range = clang::CharSourceRange::getTokenRange(value->getSourceRange());
    return clang::Lexer::getSourceText(range, context.getSourceManager(), context.getLangOpts()).str();
}

/// True if a field of the base class has the same name as another field of the type.
bool hasAmbiguousName(const clang::CXXRecordDecl& type, const clang::CXXRecordDecl& base) {
    std::multiset<std::string> all, inherited;
    addNames(type, all);
    addNames(base, inherited);
    for (const std::string& name : inherited)
        if (!name.empty() && all.count(name) > inherited.count(name)) return true;
    return false;
}

}  // namespace

void FieldCollector::addRecord(const clang::CXXRecordDecl& type, std::uint64_t offset) {
    const clang::ASTRecordLayout& layout = types_.context().getASTRecordLayout(&type);
    for (const clang::CXXBaseSpecifier& base : type.bases()) addBase(type, base, offset);
    for (const clang::FieldDecl* field : type.fields()) {
        const std::size_t before = fields_.size();
        const std::uint64_t bits = 8 * offset + layout.getFieldOffset(field->getFieldIndex());
        addField(*field, bits);
        if (fields_.size() == before || field->isAnonymousStructOrUnion()) continue;
        fields_.back().place = bits;
        if (field->isBitField()) fields_.back().width = field->getBitWidthValue(types_.context());
    }
}

void FieldCollector::addBase(const clang::CXXRecordDecl& type, const clang::CXXBaseSpecifier& specifier,
                             std::uint64_t offset) {
    const clang::CXXRecordDecl& base = *specifier.getType()->getAsCXXRecordDecl()->getDefinition();
    const std::string subject = "base class '" + shownName(base) + "' of '" + shownName(type) + "'";
    Rejection rejection = makeRejection(Reason::StandardBase, subject, shownName(base), specifier.getBeginLoc());
    if (specifier.isVirtual()) {
        rejection.reason = Reason::VirtualBase;
    } else if (specifier.getAccessSpecifier() != clang::AS_public) {
        rejection.reason = Reason::HiddenBase;
    } else if (!isStandard(base) && (types_.isAdapted(base) || hasAmbiguousName(type, base))) {
        return addWholeBase(type, base, specifier, offset);
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
        rejection.isInBase = true;
        // Faults of the user's own base class are reported at its fields, unless the base class is left out.
        broken_ = true;
        if (types_.isOwn(base) && !types_.isLeftOut(base)) return;
    }
    rejections_.push_back(rejection);
}

/// A base class whose field names clash, or that has an adapter, is shown as a member.
void FieldCollector::addWholeBase(const clang::CXXRecordDecl& type, const clang::CXXRecordDecl& base,
                                  const clang::CXXBaseSpecifier& specifier, std::uint64_t offset) {
    const Classified whole = classifyValue(types_.context().getTypeDeclType(&base), types_.context());
    const std::string subject = "base class '" + shownName(base) + "' of '" + shownName(type) + "'";
    const TypeFate& fate = types_.describe(base);
    if (!whole.use || !fate.usable || !names_.insert(base.getNameAsString()).second) {
        Rejection rejection = makeRejection(whole.use ? Reason::SameName : whole.reason, subject, shownName(base),
                                            specifier.getBeginLoc());
        rejection.causes = fate.rejections;
        broken_ = broken_ || !fate.usable;
        if (fate.usable || !fate.rejections.empty()) rejections_.push_back(rejection);
        return;
    }
    model::Field result;
    result.name = base.getNameAsString();
    result.type = *whole.use;
    result.offset = offset + types_.context().getASTRecordLayout(&type).getBaseClassOffset(&base).getQuantity();
    result.place = 8 * result.offset;
    result.doc = types_.docOf(base).text;
    result.base = shownName(base);
    result.where = types_.locate(specifier.getBeginLoc());
    hasConstants_ = hasConstants_ || !fate.isSample;
    fields_.push_back(result);
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

void FieldCollector::addField(const clang::FieldDecl& field, std::uint64_t bits) {
    if (field.isUnnamedBitField()) {  // only padding; compilers agree on it only if it fits its type
        const clang::ASTContext& context = types_.context();
        if (field.getBitWidthValue(context) > context.getTypeSize(field.getType())) reject(field, Reason::WideBitField);
        return;
    }
    doc_ = types_.docOf(field);
    if (doc_.skip) return;
    types_.refuseMessage(doc_, field.getLocation(), subjectOf(field));
    if (field.isAnonymousStructOrUnion()) {
        const clang::CXXRecordDecl& inner = *field.getType()->getAsCXXRecordDecl();
        return inner.isUnion() ? reject(field, Reason::Union) : addRecord(inner, bits / 8);
    }
    const std::string name = field.getNameAsString();
    if (field.getAccess() != clang::AS_public) {
        const auto accessors = findAccessors(field);
        if (!accessors) return reject(field, Reason::PrivateMember);
        return addByCopy(field, accessors->name, accessors->access);
    }
    const clang::ASTContext& context = types_.context();
    const auto* unnamed = field.getType()->getAs<clang::EnumType>();
    if (unnamed != nullptr && !nameOf(*unnamed->getDecl())) return addUnnamedEnum(field, *unnamed->getDecl());
    if (const auto form = formOf(field, doc_, types_)) return addForm(field, *form, bits);
    if (field.isBitField() || field.hasAttr<clang::NoUniqueAddressAttr>())
        return addByCopy(field, name, {model::AccessKind::Copy, name, name});
    const auto align = context.getTypeAlignInChars(field.getType()).getQuantity();
    if (bits / 8 % align != 0) return addPacked(field, bits / 8);
    model::Field& added = addClassified(field, name, classifyMember(field.getType(), context));
    added.offset = bits / 8;
    if (added.type.kind != model::TypeKind::Count || added.count != 0) return;
    // It holds only this number, so scripts may compute with it.
    const model::TypeUse number = added.type.element.front();
    added.type = number;
}

/// An enum without a name is shown as its number; it is not converted, because it may hold a value without enumerator.
void FieldCollector::addUnnamedEnum(const clang::FieldDecl& field, const clang::EnumDecl& type) {
    const std::string name = field.getNameAsString();
    const Classified number = classifyMember(type.getIntegerType(), types_.context());
    model::Field& added = addClassified(field, name, number);
    added.declared.clear();
    added.access = {field.isBitField() ? model::AccessKind::EnumBits : model::AccessKind::Bytes, name, name};
}

void FieldCollector::addForm(const clang::FieldDecl& field, const FieldForm& form, std::uint64_t bits) {
    model::Field& added = addClassified(field, field.getNameAsString(), form.type);
    added.offset = bits / 8;
    added.access = form.access;
    hasConstants_ = hasConstants_ || form.access.isConstant();
}

/// No reference can bind to a field that is not aligned for its type.
void FieldCollector::addPacked(const clang::FieldDecl& field, std::uint64_t offset) {
    if (!field.getType().isTriviallyCopyableType(types_.context())) return reject(field, Reason::Misaligned);
    const std::string name = field.getNameAsString();
    addByCopy(field, name, {model::AccessKind::Packed, name, name, offset});
}

void FieldCollector::addByCopy(const clang::FieldDecl& field, const std::string& name,
                               const model::FieldAccess& access) {
    addClassified(field, name, classifyValue(field.getType(), types_.context())).access = access;
}

model::Field& FieldCollector::addClassified(const clang::FieldDecl& field, const std::string& name,
                                            const Classified& type) {
    static model::Field rejected;
    if (!usable(field, type)) return rejected;
    if (!names_.insert(name).second) {
        rejectName(field);
        return rejected;
    }
    const bool hasRoom = type.use->kind == model::TypeKind::String || type.use->kind == model::TypeKind::Sequence;
    if (!doc_.capacity.empty() && (!hasRoom || doc_.capacity.find_first_not_of("0123456789") != std::string::npos)) {
        reject(field, Reason::UnsuitedAttribute);
        return rejected;
    }
    if (types_.isOwn(ownerOf(field))) types_.checkName(field, subjectOf(field));
    if (const std::string about = portabilityOf(field); !about.empty()) types_.note(field.getLocation(), about);
    model::Field result;
    result.name = name;
    result.type = *type.use;
    result.declared = type.declared;
    result.count = type.count;
    result.doc = doc_.text;
    result.unit = doc_.unit.empty() ? type.use->unit : doc_.unit;
    result.range = doc_.range;
    result.capacity = doc_.capacity;
    result.initial = initialOf(field);
    result.base = base_;
    result.where = types_.locate(field.getLocation());
    fields_.push_back(result);
    return fields_.back();
}

bool FieldCollector::usable(const clang::FieldDecl& field, const Classified& type) {
    const clang::ASTContext& context = types_.context();
    if (!type.use) {
        const bool isElement =
            !context.hasSameType(type.culprit.getUnqualifiedType(), field.getType().getUnqualifiedType());
        rejections_.push_back(makeRejection(type.reason, (isElement ? "element of " : "") + subjectOf(field),
                                            shownName(type.culprit, context), field.getLocation()));
        if (type.reason == Reason::TemplateArgument)
            rejections_.back().detail =
                ": its argument '" + unnamedArgument(*type.culprit->getAsTagDecl()) + "' has no name";
        return false;
    }
    bool all = true;
    for (const clang::TagDecl* tag : type.users) all = usable(field, *tag, type) && all;
    return all;
}

bool FieldCollector::usable(const clang::FieldDecl& field, const clang::TagDecl& tag, const Classified& type) {
    complete(tag, types_.sema(), field.getLocation());
    if (tag.getDefinition() == nullptr) {
        reject(field, Reason::NeverDefined);
        return false;
    }
    if (isHidden(tag)) {
        reject(field, Reason::HiddenType);
        return false;
    }
    const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(&tag);
    const TypeFate& fate =
        record != nullptr ? types_.describe(*record) : types_.describe(llvm::cast<clang::EnumDecl>(tag));
    if (fate.usable && !fate.isSample) {
        const bool isPlain = type.use->kind == model::TypeKind::Struct && type.count == 0 && !type.declared.empty();
        if (!isPlain) reject(field, Reason::RestrictedElement);
        hasConstants_ = true;
        return isPlain;
    }
    if (fate.usable) return true;
    broken_ = true;
    if (!fate.rejections.empty()) {
        Rejection rejection = makeRejection(fate.rejections.front().reason, subjectOf(field),
                                            shownName(field.getType(), types_.context()), field.getLocation());
        rejection.causes = fate.rejections;
        rejections_.push_back(rejection);
    }
    return false;
}

}  // namespace oroforge::cxx
