// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "header_needs.hpp"

#include <algorithm>

#include "needed_files.hpp"

namespace oroforge::cxx {

HeaderNeeds::HeaderNeeds(const std::vector<model::Header>& headers, const IncludeWatch& read,
                         const clang::ASTContext& context)
    : read_(read) {
    if (headers.size() < 2) return;
    for (const model::Header& header : headers) listed_.push_back(read.fileCalled(header.path));
    findReach();
    needed_ = neededFiles(read, context);
    for (std::size_t file = 0; file != needed_.size(); ++file)
        if (!needed_[file].empty()) needy_.push_back(file);
}

void HeaderNeeds::findReach() {
    const std::vector<ReadFile>& files = read_.files();
    for (const std::size_t first : listed_) {
        std::vector<bool> reached(files.size(), false);
        std::vector<std::size_t> open;
        if (first != IncludeWatch::kNone) open.push_back(first);
        while (!open.empty()) {
            const std::size_t file = open.back();
            open.pop_back();
            if (reached[file]) continue;
            reached[file] = true;
            open.insert(open.end(), files[file].includes.begin(), files[file].includes.end());
        }
        reach_.push_back(std::move(reached));
    }
}

bool HeaderNeeds::reachesAny(std::size_t header, const Files& files) const {
    return std::any_of(files.begin(), files.end(), [&](std::size_t file) { return reach_[header][file]; });
}

std::vector<std::size_t> HeaderNeeds::before(std::size_t header) const {
    std::vector<std::size_t> found;
    if (listed_.empty()) return found;
    for (const std::size_t file : needy_) {
        if (!reach_[header][file]) continue;
        for (const Files& files : needed_[file]) {
            const auto has = [&](std::size_t other) { return reachesAny(other, files); };
            if (has(header) || std::any_of(found.begin(), found.end(), has)) continue;
            const std::size_t best = bestBefore(header, files);
            if (best != header) found.push_back(best);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

/// Prefers a header that is one of the files, then the first that includes one; `header` if there is none.
std::size_t HeaderNeeds::bestBefore(std::size_t header, const Files& files) const {
    for (std::size_t other = 0; other != header; ++other)
        if (std::find(files.begin(), files.end(), listed_[other]) != files.end()) return other;
    for (std::size_t other = 0; other != header; ++other)
        if (reachesAny(other, files)) return other;
    return header;
}

std::vector<std::size_t> HeaderNeeds::headersThatBring(std::size_t file) const {
    std::vector<std::size_t> found;
    for (std::size_t header = 0; header != listed_.size(); ++header)
        if (file != IncludeWatch::kNone && reach_[header][file]) found.push_back(header);
    // The header that defines it comes before those that include that header.
    const auto own =
        std::find_if(found.begin(), found.end(), [&](std::size_t header) { return listed_[header] == file; });
    if (own != found.end()) std::rotate(found.begin(), own, own + 1);
    return found;
}

model::Homes HeaderNeeds::homesOf(const clang::TagDecl& type) const {
    model::Homes homes;
    if (!listed_.empty()) addHomes(type, homes);
    return homes;
}

void HeaderNeeds::addHomes(const clang::TagDecl& type, model::Homes& to) const {
    const std::vector<std::size_t> headers = headersThatBring(read_.fileOf(type.getLocation()));
    if (std::find(to.begin(), to.end(), headers) == to.end()) to.push_back(headers);
    if (const auto* outer = llvm::dyn_cast<clang::TagDecl>(type.getDeclContext())) addHomes(*outer, to);
    if (const auto* instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&type))
        for (const clang::TemplateArgument& argument : instance->getTemplateArgs().asArray()) addHomes(argument, to);
}

void HeaderNeeds::addHomes(const clang::TemplateArgument& argument, model::Homes& to) const {
    clang::QualType type;
    if (argument.getKind() == clang::TemplateArgument::Type) type = argument.getAsType();
    if (argument.getKind() == clang::TemplateArgument::Integral) type = argument.getIntegralType();
    if (argument.getKind() == clang::TemplateArgument::Pack)
        for (const clang::TemplateArgument& one : argument.pack_elements()) addHomes(one, to);
    const clang::TagDecl* tag = type.isNull() ? nullptr : type->getPointeeOrArrayElementType()->getAsTagDecl();
    if (tag != nullptr) addHomes(tag->getDefinition() != nullptr ? *tag->getDefinition() : *tag, to);
}

}  // namespace oroforge::cxx
