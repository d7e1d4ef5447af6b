// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "typekit_headers.hpp"

#include <algorithm>
#include <filesystem>

#include <clang/base/parse_files.hpp>
#include <clang/base/type_names.hpp>

namespace fs = std::filesystem;

namespace oroforge::cxx {

namespace {

std::string realPath(const std::string& path) {
    std::error_code failed;
    const fs::path found = fs::weakly_canonical(path, failed);
    return failed ? path : found.string();
}

bool isHeader(const std::string& file) {
    static const std::set<std::string> known = {".h", ".hh", ".hpp", ".hxx", ".H", ".h++", ".ipp", ".tpp"};
    return known.count(fs::path(file).extension().string()) != 0;
}

}  // namespace

TypekitHeaders::TypekitHeaders(const clang::SourceManager& sources, const SourcePlaces& places, const std::string& root)
    : sources_(sources), places_(places), root_(realPath(root)) {}

std::string TypekitHeaders::fileOf(const clang::Decl& type) const {
    const clang::SourceLocation at = sources_.getExpansionLoc(type.getLocation());
    const auto file = sources_.getFileEntryRefForID(sources_.getFileID(at));
    if (!file || isLibrary(type)) return {};
    const std::string path = realPath(file->getName().str());
    return path.compare(0, root_.size() + 1, root_ + "/") == 0 ? path.substr(root_.size() + 1) : std::string();
}

void TypekitHeaders::addComponent(const clang::CXXRecordDecl& type) { components_.insert(fileOf(type)); }

void TypekitHeaders::addUse(clang::QualType type) {
    if (type.isNull()) return;
    type = type.getNonReferenceType().getCanonicalType();
    if (type->isPointerType()) return addUse(type->getPointeeType());
    if (type->isArrayType()) return addUse(clang::QualType(type->getPointeeOrArrayElementType(), 0));
    const clang::TagDecl* tag = type->getAsTagDecl();
    if (tag == nullptr) return;
    if (const auto* instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(tag)) {
        for (const clang::TemplateArgument& argument : instance->getTemplateArgs().asArray())
            if (argument.getKind() == clang::TemplateArgument::Type) addUse(argument.getAsType());
    }
    const clang::TagDecl* definition = tag->getDefinition();
    if (definition == nullptr || fileOf(*definition).empty()) return;
    if (std::find(types_.begin(), types_.end(), definition) == types_.end()) types_.push_back(definition);
}

std::vector<model::Text> TypekitHeaders::headers(diag::Sink& remarks) const {
    std::vector<model::Text> found;
    for (const clang::TagDecl* type : types_) {
        const diag::Location where = places_.locate(sources_, type->getLocation());
        const std::string file = fileOf(*type);
        if (!isHeader(file) || components_.count(file) != 0) {
            remarks.warning(where, "OC028",
                            "the interface uses the type '" + shownName(*type) + "', which is defined in " +
                                (isHeader(file) ? "the header of a component" : "a source") +
                                ", so typegen cannot make a typekit of it");
            continue;
        }
        const bool known =
            std::any_of(found.begin(), found.end(), [&](const model::Text& other) { return other.value == file; });
        if (!known) found.push_back({file, where});
    }
    std::sort(found.begin(), found.end(), [](const model::Text& a, const model::Text& b) { return a.value < b.value; });
    return found;
}

}  // namespace oroforge::cxx
