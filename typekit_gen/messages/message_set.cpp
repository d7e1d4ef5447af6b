// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <messages/message_set.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <diag/nearest_match.hpp>
#include <messages/parse_message.hpp>

namespace fs = std::filesystem;

namespace oroforge::messages {

namespace {

std::string packageOf(const std::string& fullName) { return fullName.substr(0, fullName.find('/')); }
std::string lastOf(const std::string& fullName) { return fullName.substr(fullName.find('/') + 1); }

std::vector<std::string> namesIn(const std::vector<std::string>& folders) {
    std::vector<std::string> names;
    std::error_code error;
    for (const std::string& folder : folders)
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
            if (entry.path().extension() == ".msg") names.push_back(entry.path().stem().string());
    return names;
}

}  // namespace

void MessageSet::addFile(const std::string& package, const std::string& file) {
    given_[package + "/" + fs::path(file).stem().string()] = file;
}

const Message* MessageSet::find(const std::string& fullName) const {
    const auto found = messages_.find(fullName);
    return found == messages_.end() ? nullptr : &found->second;
}

std::string MessageSet::fileOf(const std::string& fullName, const diag::Location& where) {
    const auto given = given_.find(fullName);
    if (given != given_.end()) return given->second;
    const std::string package = packageOf(fullName);
    const auto folders = search_.foldersOf(package, "msg");
    for (const std::string& folder : folders) {
        const std::string file = folder + "/" + lastOf(fullName) + ".msg";
        std::error_code error;
        if (fs::exists(file, error)) return file;
    }
    auto names = namesIn(folders);
    for (const auto& [name, file] : given_)
        if (packageOf(name) == package) names.push_back(lastOf(name));
    if (names.empty())
        sink_.error(
            where, "RM006",
            "'" + fullName + "': no package '" + package + "' with .msg files; searched: " + search_.described() +
                "; install it (Debian: ros-" +
                [&] {
                    std::string dashed = package;
                    std::replace(dashed.begin(), dashed.end(), '_', '-');
                    return dashed;
                }() +
                "), or add its workspace to ROS_PACKAGE_PATH");
    else
        sink_.error(where, "RM006",
                    "'" + fullName + "': package '" + package + "' has no message '" + lastOf(fullName) + "'" +
                        diag::didYouMean(lastOf(fullName), names));
    return "";
}

bool MessageSet::read(const std::string& file, std::string& text, const diag::Location& where) {
    std::ifstream in(file, std::ios::binary);
    text.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    std::error_code error;
    if (!in || fs::is_directory(file, error)) {
        sink_.error(where, "RM001", "cannot read '" + file + "'");
        return false;
    }
    if (std::find(files_.begin(), files_.end(), file) == files_.end()) files_.push_back(file);
    return true;
}

const Message* MessageSet::message(const std::string& fullName, const diag::Location& where) {
    if (const Message* known = find(fullName)) return complete_.count(fullName) || readParts(*known) ? known : nullptr;
    if (failed_.count(fullName)) return nullptr;
    const std::string file = fileOf(fullName, where);
    std::string text;
    const std::size_t faults = sink_.errorCount();
    if (file.empty() || !read(file, text, where)) {
        failed_.insert(fullName);
        return nullptr;
    }
    Message message = parseMessage(text, packageOf(fullName), lastOf(fullName), file, sink_);
    if (sink_.errorCount() != faults) {
        failed_.insert(fullName);
        return nullptr;
    }
    return add(std::move(message));
}

const Message* MessageSet::add(Message message) {
    const std::string name = message.fullName();
    const auto [place, isNew] = messages_.emplace(name, std::move(message));
    if (!isNew) {
        sink_.error({place->second.file, 1, 1}, "RM005",
                    "'" + name + "' is there twice: as a message, and as a part of a service; rename one of them");
        return nullptr;
    }
    return readParts(place->second) ? &place->second : nullptr;
}

bool MessageSet::readParts(const Message& message) {
    const std::string name = message.fullName();
    if (complete_.count(name)) return true;
    if (failed_.count(name)) return false;
    const auto open = std::find(openNames_.begin(), openNames_.end(), name);
    if (open != openNames_.end()) {
        const auto from = static_cast<std::size_t>(open - openNames_.begin());
        auto& error = sink_.error(open_[from]->where, "RM007",
                                  "a '" + name + "' contains itself, so that it would never end; break the circle");
        for (std::size_t i = from; i != open_.size(); ++i)
            error.note(open_[i]->where, "through field '" + open_[i]->name + "' of '" + openNames_[i] + "'");
        return false;
    }
    openNames_.push_back(name);
    bool good = true;
    for (const Field& field : message.fields) {
        if (field.type.isBuiltin) continue;
        open_.push_back(&field);
        good &= this->message(field.type.name, field.where) != nullptr;
        open_.pop_back();
    }
    openNames_.pop_back();
    (good ? complete_ : failed_).insert(name);
    return good;
}

const Service* MessageSet::service(const std::string& package, const std::string& file) {
    const std::string name = package + "/" + fs::path(file).stem().string();
    const auto known = services_.find(name);
    if (known != services_.end()) return &known->second;
    std::string text;
    const std::size_t faults = sink_.errorCount();
    if (!read(file, text, {"typegen-ros"})) return nullptr;
    Service service = parseService(text, package, lastOf(name), file, sink_);
    if (sink_.errorCount() != faults || !add(service.request) || !add(service.response)) return nullptr;
    return &services_.emplace(name, std::move(service)).first->second;
}

}  // namespace oroforge::messages
